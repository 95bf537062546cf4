#pragma once
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

#include <strike/scalar/pack.hpp>

namespace strike {

namespace detail {

template <class T>
struct MathConstants;

template <>
struct MathConstants<double> {
  using Unsigned = std::uint64_t;
  static constexpr int mantissa_bits = 52;
  static constexpr double normal_scale = 0x1p54;          // brings every denormal into the normal range
  static constexpr double cbrt_normal_unscale = 0x1p-18;  // its cube root, inverted
};

template <>
struct MathConstants<float> {
  using Unsigned = std::uint32_t;
  static constexpr int mantissa_bits = 23;
  static constexpr float normal_scale = 0x1p24f;
  static constexpr float cbrt_normal_unscale = 0x1p-8f;
};

/// The functions of one register. Everything is straight-line code on vector extensions; a*b + c becomes one fused
/// instruction where the target has it, and nothing here depends on whether it does.
template <class T, std::size_t Width>
struct RegisterMath {
  using C = MathConstants<T>;
  using Unsigned = typename C::Unsigned;
  using V = typename Register<T, Width>::type;
  using U = typename Register<Unsigned, Width>::type;

  static constexpr T infinity = std::numeric_limits<T>::infinity();
  static constexpr T smallest_normal = std::numeric_limits<T>::min();
  static constexpr Unsigned sign_bit = Unsigned{1} << (sizeof(T) * 8 - 1);

  static U bits(const V& x) { return std::bit_cast<U>(x); }
  static V number(const U& u) { return std::bit_cast<V>(u); }
  static V magnitude(const V& x) { return number(bits(x) & ~sign_bit); }

  /// A first guess of x^(-1/3) for normal x > 0: the bits of a number, read as an integer, are its logarithm up to a
  /// factor, an offset and 9 %; so the bits of the root are an offset minus a third of them. Within 3.5 %.
  static V inverse_cbrt_guess(const V& x) {
    if constexpr (sizeof(T) == 8) {
      // 2^52 + h has the integer h in its low bits: conversion to double and back without an instruction for it.
      constexpr T two52 = 0x1p52;
      constexpr Unsigned two52_bits = 0x4330'0000'0000'0000;
      const V high_word = number((bits(x) >> 32) | two52_bits);
      return number(bits(high_word * (T(-1) / 3) + (0x553ef0ff + two52 + two52 / 3)) << 32);
    } else {
      using I = typename Register<std::int32_t, Width>::type;
      const V x_bits = __builtin_convertvector(std::bit_cast<I>(x), V);
      return std::bit_cast<V>(__builtin_convertvector(x_bits * (T(-1) / 3) + T(0x54a21d2a), I));
    }
  }

  /// x^(1/3) by the reciprocal root t, which needs no division: with e = 1 - x t^3,
  ///   x^(-1/3) = t (1 - e)^(-1/3) = t (1 + e/3 + 2 e^2/9 + ...)
  ///   x^(1/3) = x t^2 (1 - e)^(-2/3) = x t^2 (1 + 2 e/3 + 5 e^2/9 + 40 e^3/81 + 110 e^4/243 + ...)
  /// The first step takes |e| <= 0.11 to 7e-4; what the second leaves out is 0.42 e^5 = 6e-17 of the result.
  static V cbrt(const V& x) {
    const V a = magnitude(x);
    const auto denormal = a < smallest_normal;
    const V m = denormal ? a * C::normal_scale : a;

    V t = inverse_cbrt_guess(m);
    V e = T(1) - (m * t) * (t * t);
    t = t + t * e * (T(1) / 3 + e * (T(2) / 9));

    V y = (m * t) * t;
    e = T(1) - y * t;
    if constexpr (sizeof(T) == 8)
      y = y + y * e * (T(2) / 3 + e * (T(5) / 9 + e * (T(40) / 81 + e * (T(110) / 243))));
    else
      y = y + y * e * (T(2) / 3 + e * (T(5) / 9));

    y = denormal ? y * C::cbrt_normal_unscale : y;
    y = a < infinity ? y : a;  // inf and NaN
    return number(bits(y) | (bits(x) & sign_bit));
  }
};

/// f(math, register) in every register of x.
template <class T, std::size_t N, class F>
Pack<T, N> by_register(const Pack<T, N>& x, F f) {
  using P = Pack<T, N>;
  P y;
  for (std::size_t k = 0; k < P::registers; ++k) y.native(k) = f(x.native(k));
  return y;
}

}  // namespace detail

/// The real cube root, for every number: odd, exact at 0 and inf, NaN for NaN.
template <class T, std::size_t N>
Pack<T, N> cbrt(const Pack<T, N>& x) {
  using Math = detail::RegisterMath<T, Pack<T, N>::width>;
  return detail::by_register(x, [](const auto& r) { return Math::cbrt(r); });
}

}  // namespace strike
