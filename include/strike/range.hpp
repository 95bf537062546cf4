#pragma once
#include <cmath>
#include <concepts>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <strike/error.hpp>
#include <strike/protocol.hpp>
#include <strike/text.hpp>

// The values that a number of a model may have are said once, beside the numbers:
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
// A model made of others names them: number(eos), number(strength), or with their place number(layer, "layer 1"). Of a
// list each number is visited: number("properties", properties, range::finite). A fourth argument is advice that ends
// the sentence. A run, or whatever takes the model, calls `check_ranges` when it begins; steps cost nothing.
namespace strike {

/// The values that a number may have. NaN is one of them only where it stands for a number that is not given, and none
/// is larger than `largest` unless it may be infinite.
struct Range {
  static constexpr double largest = 1e100;  ///< the product of three such numbers is still a double

  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
  bool without_low = true, without_high = true;  ///< the ends themselves are outside
  bool may_be_nan = false;

  constexpr bool holds(double value) const {
    if (value != value) return may_be_nan;
    return (without_low ? value > low : value >= low) && (without_high ? value < high : value <= high) &&
           !is_too_large(value);
  }
  /// After "it must be", of a value that is outside.
  [[gnu::cold]] std::string words(double value) const {
    const std::string in = words();
    if (!is_too_large(value)) return in;
    if (std::isinf(value)) return in == "finite" ? in : in + " and finite";
    return detail::joined({in, " and at most ", detail::text(largest), " in size"});
  }
  [[gnu::cold]] std::string words() const {
    using detail::joined, detail::text;
    const bool below = std::isfinite(low), above = std::isfinite(high);
    if (!below && !above) return without_low || without_high ? "finite" : "a number";
    if (low == high) return text(low);
    std::string words = !above ? "" : joined({below ? " and " : "", without_high ? "below " : "at most ", text(high)});
    if (!below) return words;
    if (low == 0) return joined({without_low ? "positive" : "zero or positive", words});
    return joined({without_low ? "above " : "at least ", text(low), words});
  }

 private:
  constexpr bool is_too_large(double value) const {
    return (value > largest && high > largest && without_high) || (value < -largest && low < -largest && without_low);
  }
};

/// The values that a vector may have.
enum class VectorRange { finite, not_zero };

namespace range {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

inline constexpr Range finite{}, positive{.low = 0}, not_negative{.low = 0, .without_low = false};
inline constexpr Range share{.low = 0, .high = 1, .without_low = false, .without_high = false};  ///< 0 to 1
inline constexpr VectorRange point = VectorRange::finite, direction = VectorRange::not_zero;

/// A count from 1 on; negative numbers that became unsigned ones are larger.
inline constexpr Range count{.low = 1, .high = 2147483647, .without_low = false, .without_high = false};

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
/// The same, or NaN: not given.
constexpr Range or_nan(Range range) {
  range.may_be_nan = true;
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
  void operator()(std::string_view name, const Number& number, const Range& range, std::string_view advice = {}) const {
    const auto value = static_cast<double>(number);
    if (!range.holds(value)) refuse(name, text(value), range.words(value), advice);
  }
  /// A list of numbers.
  template <class Numbers>
    requires requires(const Numbers& numbers, const RangeCheck& check, const Range& range) {
      check("", numbers[numbers.size() - 1], range);
    }
  void operator()(std::string_view name, const Numbers& numbers, const Range& range,
                  std::string_view advice = {}) const {
    for (decltype(numbers.size()) i = 0; i < numbers.size(); ++i)
      (*this)(joined({name, "[", std::to_string(i), "]"}), numbers[i], range, advice);
  }
  template <class Vector>
  void operator()(std::string_view name, const Eigen::MatrixBase<Vector>& vector, VectorRange range,
                  std::string_view advice = {}) const {
    const auto value = vector.eval();
    if (value.allFinite() && value.cwiseAbs().maxCoeff() <= Range::largest &&
        (range == VectorRange::finite || value.norm() > 0))
      return;
    std::string components;
    for (Eigen::Index i = 0; i < value.size(); ++i)
      components += joined({i == 0 ? "(" : ", ", text(static_cast<double>(value(i)))});
    refuse(name, components + ")", range == VectorRange::not_zero ? "finite and not zero" : "finite", advice);
  }
  /// A model in this one, at a place such as "layer 1".
  template <class Model>
  void operator()(const Model& model, std::string_view place = {}) const;

 private:
  [[noreturn, gnu::cold]] void refuse(std::string_view name, const std::string& value, const std::string& words,
                                      std::string_view advice) const {
    throw Error(joined({"strike: the ", name, " of ", model_, where_, " is ", value, "; it must be ", words,
                        advice.empty() ? "" : ": ", advice, "."}));
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
void RangeCheck::operator()(const Model& model, std::string_view place) const {
  check_ranges(model, place.empty() ? where_ : joined({where_, where_.empty() ? ", in " : " in ", place, ","}));
}
/// The numbers of a model and of models in it, in the order in which their `ranges` visit them.
class Constants {
 public:
  explicit Constants(std::vector<double>& all) : all_(all) {}

  template <class Number>
    requires std::convertible_to<Number, double> || std::is_arithmetic_v<Number>
  void operator()(std::string_view, const Number& number, const Range&, std::string_view = {}) const {
    all_.push_back(static_cast<double>(number));
  }
  template <class Numbers>
    requires requires(const Numbers& numbers, const Constants& constants, const Range& range) {
      constants("", numbers[numbers.size() - 1], range);
    }
  void operator()(std::string_view name, const Numbers& numbers, const Range& range, std::string_view = {}) const {
    for (const auto& number : numbers) (*this)(name, number, range);
  }
  template <class Vector>
  void operator()(std::string_view, const Eigen::MatrixBase<Vector>& vector, VectorRange, std::string_view = {}) const {
    const auto value = vector.eval();
    for (Eigen::Index i = 0; i < value.size(); ++i) all_.push_back(static_cast<double>(value(i)));
  }
  template <class Model>
  void operator()(const Model& model, std::string_view = {}) const {
    if constexpr (answers<Ranges, const Model, const Constants>) Ranges::call(model, *this);
  }

 private:
  std::vector<double>& all_;
};
template <class Model>
[[gnu::cold]] std::vector<double> constants_of(const Model& model) {
  std::vector<double> all;
  Constants{all}(model);
  return all;
}
/// The model itself, checked.
template <class Model>
const Model& in_range(const Model& model) {
  check_ranges(model);
  return model;
}

}  // namespace detail

}  // namespace strike
