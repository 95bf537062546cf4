#pragma once
#include <string>

#include <strike/scalar/dual.hpp>
#include <strike/scalar/pack.hpp>
#include <strike/scalar/scalar.hpp>

namespace strike::detail {

/// The number in which a law is tried where it is composed: that of a run without `in<T>`.
using TrialLanes = Pack<double>;

/// Instantiates a class that reports flaws, whose pointer is looked up for friends. A longer way tells the user more
/// lines of ours, and to clang a class whose static_assert failed is incomplete, so that nothing may depend on it.
constexpr bool instantiates(const void*) { return true; }

/// Instantiates a function that uses a law on lanes, so that errors in its formulas stand beside the law and not below
/// the driver.
template <auto function>
struct Tried {};

/// `warning()` of a law or of a material.
struct Warning {
  struct Decoy {
    int warning;
  };
  template <class Model>
  using Member = decltype(&Model::warning);
  static auto call(const auto& model) -> decltype(std::string(model.warning())) { return model.warning(); }
};

}  // namespace strike::detail
