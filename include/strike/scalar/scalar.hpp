#pragma once
#include <cmath>
#include <concepts>
#include <cstddef>
#include <type_traits>

#include <strike/scalar/pack.hpp>

namespace strike {

// The functions of a Scalar, for the built-in numbers. Those of Pack and Dual are found by their argument.
using std::abs;
using std::cbrt;
using std::exp;
using std::log;
using std::pow;
using std::sqrt;

template <std::floating_point T>
constexpr T select(bool condition, std::type_identity_t<T> then, T otherwise) {
  return condition ? then : otherwise;
}
template <std::floating_point T>
constexpr T min(T a, std::type_identity_t<T> b) {
  return b < a ? b : a;
}
template <std::floating_point T>
constexpr T max(T a, std::type_identity_t<T> b) {
  return a < b ? b : a;
}
constexpr bool any(bool condition) { return condition; }
constexpr bool all(bool condition) { return condition; }
template <std::floating_point T>
constexpr T reduce_sum(T a) {
  return a;
}
template <std::floating_point T>
constexpr T reduce_min(T a) {
  return a;
}
template <std::floating_point T>
constexpr T reduce_max(T a) {
  return a;
}

/// What the formulas of strike are written for: a `double`, a `Pack` of `double` or `float`, a `Dual`.
/// Laws: arithmetic is that of the real numbers to rounding; `select(c, a, b)` is `c ? a : b` in each lane, and its
/// unselected branch may be computed and be anything, NaN included; a `double` literal may stand wherever a number may.
template <class T>
concept Scalar = std::copyable<T> && std::constructible_from<T, double> && requires(const T a, const T b) {
  { a + b } -> std::convertible_to<T>;
  { a - b } -> std::convertible_to<T>;
  { a* b } -> std::convertible_to<T>;
  { a / b } -> std::convertible_to<T>;
  { -a } -> std::convertible_to<T>;
  { select(a < b, a, b) } -> std::convertible_to<T>;
  { min(a, b) } -> std::convertible_to<T>;
  { max(a, b) } -> std::convertible_to<T>;
  { abs(a) } -> std::convertible_to<T>;
  { sqrt(a) } -> std::convertible_to<T>;
  { any(a < b) } -> std::convertible_to<bool>;
};

namespace detail {
template <class T>
struct ScalarTraits {
  using Real = T;
  static constexpr std::size_t lanes = 1;
};
template <class T, std::size_t N>
struct ScalarTraits<Pack<T, N>> {
  using Real = T;
  static constexpr std::size_t lanes = N;
};
}  // namespace detail

/// The built-in number in a lane: `double` or `float`.
template <class T>
using RealOf = typename detail::ScalarTraits<T>::Real;

/// How many independent numbers T carries.
template <class T>
inline constexpr std::size_t lanes = detail::ScalarTraits<T>::lanes;

/// Lane i of a scalar, whatever it is.
template <class T>
constexpr RealOf<T> lane(const T& a, std::size_t i) {
  if constexpr (lanes<T> == 1 && !requires { a[i]; })
    return (void)i, a;
  else
    return a[i];
}
template <class T>
constexpr void set_lane(T& a, std::size_t i, RealOf<T> value) {
  if constexpr (requires { a.set(i, value); })
    a.set(i, value);
  else
    (void)i, a = value;
}

}  // namespace strike
