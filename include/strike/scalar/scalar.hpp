#pragma once
#include <cmath>
#include <concepts>
#include <cstddef>
#include <span>
#include <type_traits>

#include <strike/scalar/math.hpp>
#include <strike/scalar/pack.hpp>

namespace strike {

// Functions of a Scalar, for the built-in numbers; the functions of Pack and Dual are found by their argument.
using std::abs;
using std::cbrt;
using std::exp;
using std::log;
using std::pow;
using std::sqrt;

namespace detail {
template <class A, class B>
concept BuiltIn =
    std::is_arithmetic_v<A> && std::is_arithmetic_v<B> && (std::floating_point<A> || std::floating_point<B>);
}

template <class A, class B>
  requires detail::BuiltIn<A, B>
constexpr std::common_type_t<A, B> select(bool condition, A then, B otherwise) {
  return condition ? then : otherwise;
}
template <class A, class B>
  requires detail::BuiltIn<A, B>
constexpr std::common_type_t<A, B> min(A a, B b) {
  return b < a ? b : a;
}
template <class A, class B>
  requires detail::BuiltIn<A, B>
constexpr std::common_type_t<A, B> max(A a, B b) {
  return a < b ? b : a;
}
/// 1/sqrt(a).
template <std::floating_point T>
T rsqrt(T a) {
  return T(1) / std::sqrt(a);
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

/// A number of strike's formulas: a `double`, a `Pack` of `double` or `float`, a `Dual`.
/// Laws: arithmetic is that of the real numbers to rounding; `select(c, a, b)` is `c ? a : b` in each lane, and its
/// unselected branch may be computed and be anything, NaN included; a `double` literal may stand wherever a number may;
/// lane i of f(a) is f of lane i, bit for bit in + - * / < min max abs sqrt, else within 4 units in the last place.
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
  { rsqrt(a) } -> std::convertible_to<T>;
  { cbrt(a) } -> std::convertible_to<T>;
  { exp(a) } -> std::convertible_to<T>;
  { log(a) } -> std::convertible_to<T>;
  { pow(a, b) } -> std::convertible_to<T>;
  { select(a < 1.0 && !(b >= a), 2.0 * a, a + 2.0) } -> std::convertible_to<T>;
  { any(a < b) } -> std::convertible_to<bool>;
  { all(a == b) } -> std::convertible_to<bool>;
};

namespace detail {
template <class T>
struct ScalarTraits {
  using Real = T;
  using Lane = T;
  static constexpr std::size_t lanes = 1;
};
template <class T, std::size_t N>
struct ScalarTraits<Pack<T, N>> {
  using Real = T;
  using Lane = T;
  static constexpr std::size_t lanes = N;
};
}  // namespace detail

/// The built-in number that T is made of: `double` or `float`.
template <class T>
using RealOf = typename detail::ScalarTraits<T>::Real;

/// One lane of T: its built-in number, or the Dual of that.
template <class T>
using LaneOf = typename detail::ScalarTraits<T>::Lane;

/// Number of independent numbers in T.
template <class T>
inline constexpr std::size_t lanes = detail::ScalarTraits<T>::lanes;

/// Lane i of a scalar; of a built-in number, itself.
template <class T>
constexpr LaneOf<T> lane(const T& a, std::size_t i) {
  if constexpr (requires { a[i]; })
    return a[i];
  else
    return (void)i, a;
}
template <class T>
constexpr void set_lane(T& a, std::size_t i, std::type_identity_t<LaneOf<T>> value) {
  if constexpr (requires { a.set(i, value); })
    a.set(i, value);
  else
    (void)i, a = value;
}

/// An aggregate of nothing but numbers T, such as the state of an element, as the range of them.
template <class T, class Aggregate>
auto numbers_of(Aggregate& aggregate) {
  using Number = std::conditional_t<std::is_const_v<Aggregate>, const T, T>;
  static_assert(sizeof(Aggregate) % sizeof(T) == 0 && std::is_trivially_destructible_v<Aggregate>,
                "strike: numbers_of needs an aggregate that holds numbers of this type alone.");
  return std::span<Number, sizeof(Aggregate) / sizeof(T)>(reinterpret_cast<Number*>(&aggregate),
                                                          sizeof(Aggregate) / sizeof(T));
}

/// f(numbers of a, numbers of b) of two such aggregates; where they hold lists, all that a.visit_numbers(b, f) visits.
template <class T, class Aggregate, class F>
void visit_numbers(Aggregate& a, const Aggregate& b, const F& f) {
  if constexpr (std::is_empty_v<Aggregate>)
    return;
  else if constexpr (std::is_trivially_destructible_v<Aggregate>)
    f(numbers_of<T>(a), numbers_of<T>(b));
  else
    a.visit_numbers(b, f);
}

}  // namespace strike
