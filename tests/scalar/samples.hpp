#pragma once
#include <algorithm>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include <strike/scalar.hpp>

namespace scalar_test {

template <class T>
using Bits = std::conditional_t<sizeof(T) == 8, std::uint64_t, std::uint32_t>;

/// The distance of a result from the exact one, in units in the last place of the exact one. Infinite where one of them
/// is NaN, infinite or, as a T, zero of a sign that the other has not.
template <std::floating_point T>
[[gnu::noinline]] inline double ulps(T result, long double exact) {
  const T rounded = static_cast<T>(exact);
  if (std::isnan(result) && std::isnan(exact)) return 0;
  if (result == rounded && std::signbit(result) == std::signbit(rounded)) return 0.5;
  if (!std::isfinite(result) || !std::isfinite(rounded) || (result == 0 && std::signbit(result) != std::signbit(exact)))
    return std::numeric_limits<double>::infinity();
  const int exponent = std::max(std::ilogb(exact) + 1, std::numeric_limits<T>::min_exponent);
  const long double ulp = std::ldexp(1.0L, exponent - std::numeric_limits<T>::digits);
  return static_cast<double>(std::abs(static_cast<long double>(result) - exact) / ulp);
}

/// 0, 1, infinity and their neighbours, NaN, and where doubles and floats begin to be integers, even integers.
template <std::floating_point T>
std::vector<T> extremes() {
  using Limits = std::numeric_limits<T>;
  const T integers = std::ldexp(T(1), Limits::digits - 1);
  std::vector<T> x{0,
                   Limits::denorm_min(),
                   Limits::min(),
                   std::nextafter(Limits::min(), T(0)),
                   Limits::max(),
                   Limits::infinity(),
                   1,
                   std::nextafter(T(1), T(0)),
                   std::nextafter(T(1), T(2)),
                   T(1) / 3,
                   T(0.5),
                   2,
                   3,
                   5,
                   integers - T(0.5),
                   integers - 1,
                   integers,
                   integers + 1,
                   2 * integers - 1,
                   2 * integers};
  for (std::size_t i = 0, n = x.size(); i < n; ++i) x.push_back(-x[i]);
  x.push_back(Limits::quiet_NaN());
  return x;
}

/// n numbers whose bits are random: all binades, both signs, denormals, infinities and NaN among them.
template <std::floating_point T>
std::vector<T> any(std::size_t n, unsigned seed = 1) {
  std::mt19937_64 random(seed);
  std::vector<T> x(n);
  for (T& x_i : x) x_i = std::bit_cast<T>(static_cast<Bits<T>>(random() | 1));  // a NaN stays a NaN
  return x;
}

/// n numbers between a and b, evenly spread with a little noise.
template <std::floating_point T>
std::vector<T> between(double a, double b, std::size_t n, unsigned seed = 1) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> noise(0, 1);
  std::vector<T> x(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double place = (static_cast<double>(i) + noise(random)) / static_cast<double>(n);
    x[i] = static_cast<T>(a + (b - a) * place);
  }
  return x;
}

}  // namespace scalar_test
