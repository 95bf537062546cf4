#pragma once
#include <strike/material/failure/failure.hpp>
#include <strike/range.hpp>

namespace strike {

/// Rankine's law of brittle materials such as glass: failure when the largest principal stress reaches the strength in
/// tension.
struct PrincipalStress {
  double strength;  ///< [stress]

  void ranges(const auto& number) const { number("strength", strength, range::or_infinite(range::not_negative)); }

  template <class T>
  using State = detail::Intact<T>;
  template <class T, class S>
  auto fails(const T&, const S& state) const {
    return largest_principal(state.stress) >= strength;
  }
};

}  // namespace strike
