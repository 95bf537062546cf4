#pragma once
#include <cmath>
#include <concepts>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>

#include <Eigen/Core>

#include <strike/error.hpp>
#include <strike/protocol.hpp>
#include <strike/text.hpp>

// What a number of a model may be is said once, beside the numbers:
//
//   struct VonMises {
//     double shear_modulus, yield_stress, hardening_modulus = 0;
//
//     void ranges(const auto& number) const {
//       number("shear_modulus", shear_modulus, range::positive);
//       number("yield_stress", yield_stress, range::not_negative);
//       number("hardening_modulus", hardening_modulus, range::above(-3 * shear_modulus));
//     }
//   };
//
// A model made of others names them: number(eos), number(strength). A run, or whatever takes the model, calls
// `check_ranges` when it begins; steps cost nothing.
namespace strike {

/// The values that a number may have. NaN is never one of them.
struct Range {
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
  bool without_low = true, without_high = true;  ///< the ends themselves are outside

  constexpr bool holds(double value) const {
    return (without_low ? value > low : value >= low) && (without_high ? value < high : value <= high);
  }
  /// After "it must be".
  [[gnu::cold]] std::string words() const {
    using detail::joined, detail::text;
    const bool below = std::isfinite(low), above = std::isfinite(high);
    if (!below && !above) return without_low || without_high ? "finite" : "a number";
    std::string words = !above ? "" : joined({below ? " and " : "", without_high ? "below " : "at most ", text(high)});
    if (!below) return words;
    if (low == 0) return joined({without_low ? "positive" : "zero or positive", words});
    return joined({without_low ? "above " : "at least ", text(low), words});
  }
};

/// What a vector may be.
enum class VectorRange { finite, not_zero };

namespace range {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

inline constexpr Range finite{}, positive{.low = 0}, not_negative{.low = 0, .without_low = false};
inline constexpr Range share{.low = 0, .high = 1, .without_low = false, .without_high = false};  ///< 0 to 1
inline constexpr VectorRange point = VectorRange::finite, direction = VectorRange::not_zero;

constexpr Range above(double low) { return {.low = low}; }
constexpr Range at_least(double low) { return {.low = low, .without_low = false}; }
constexpr Range below(double high) { return {.high = high}; }
constexpr Range at_most(double high) { return {.high = high, .without_high = false}; }
/// Both ends belong to it.
constexpr Range between(double low, double high) {
  return {.low = low, .high = high, .without_low = false, .without_high = false};
}
/// The same, or infinite: none, or never.
constexpr Range or_infinite(Range range) {
  if (range.low == -infinity) range.without_low = false;
  if (range.high == infinity) range.without_high = false;
  return range;
}

}  // namespace range

namespace detail {

/// The name of a class without its namespace and its arguments.
template <class Model>
[[gnu::cold]] std::string class_name() {
  std::string_view name = name_of<Model>();
  name.remove_prefix(name.find("T = ") + 4);
  name = name.substr(0, name.find_first_of("<;]"));
  if (const auto colons = name.rfind("::"); colons != name.npos) name.remove_prefix(colons + 2);
  return std::string(name);
}

struct Ranges {
  struct Decoy {
    int ranges;
  };
  template <class Model>
  using Member = decltype(&Model::ranges);
  template <class Look>
  static void call(const auto& model, const Look& look)
    requires requires { model.ranges(look); }
  {
    model.ranges(look);
  }
};

/// Error: the first number of a model that is outside its range.
class RangeCheck {
 public:
  /// `where` ends "the yield_stress of VonMises", such as ", in part 2,".
  RangeCheck(std::string model, std::string where) : model_(std::move(model)), where_(std::move(where)) {}

  template <class Number>
    requires std::convertible_to<Number, double> || std::is_arithmetic_v<Number>
  void operator()(const char* name, const Number& number, const Range& range) const {
    const auto value = static_cast<double>(number);
    if (!range.holds(value)) refuse(name, text(value), range.words());
  }
  void operator()(const char* name, const Eigen::Vector3d& value, VectorRange range) const {
    if (!value.allFinite() || (range == VectorRange::not_zero && !(value.norm() > 0)))
      refuse(name, joined({"(", text(value[0]), ", ", text(value[1]), ", ", text(value[2]), ")"}),
             range == VectorRange::not_zero ? "finite and not zero" : "finite");
  }
  /// A model in this one.
  template <class Model>
  void operator()(const Model& model) const;

 private:
  [[noreturn, gnu::cold]] void refuse(const char* name, const std::string& value, const std::string& words) const {
    throw Error(joined({"strike: the ", name, " of ", model_, where_, " is ", value, "; it must be ", words, "."}));
  }
  std::string model_, where_;
};

/// Error: a number of the model, or of models in it, that is outside its range; `where` is a place such as
/// ", in part 2,".
template <class Model>
[[gnu::cold]] void check_ranges(const Model& model, const std::string& where = {}) {
  static_assert(!nearly<Ranges, const Model, const RangeCheck>,
                "strike: the ranges of this model do not fit; write void ranges(const auto& number) const, which calls "
                "number(\"name\", name, range::positive) for each of its numbers.");
  if constexpr (answers<Ranges, const Model, const RangeCheck>)
    Ranges::call(model, RangeCheck(class_name<Model>(), where));
}
template <class Model>
void RangeCheck::operator()(const Model& model) const {
  check_ranges(model, where_);
}
/// The model itself, checked.
template <class Model>
const Model& in_range(const Model& model) {
  check_ranges(model);
  return model;
}

}  // namespace detail

}  // namespace strike
