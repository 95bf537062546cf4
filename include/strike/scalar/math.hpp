#pragma once
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <type_traits>

#include <strike/scalar/pack.hpp>

namespace strike {

namespace detail {

/// The formats binary64 and binary32, and the constants that are cut to fit them.
template <class T>
struct Binary;

template <>
struct Binary<double> {
  using Unsigned = std::uint64_t;
  static constexpr int mantissa_bits = 52;
  static constexpr int bias = 1023;
  static constexpr Unsigned low_half = (Unsigned{1} << 27) - 1;  // without it, 26 bits: products are exact
  static constexpr int denormal_shift = 54;                      // a multiple of 3, for the cube root
  static constexpr double ln2_high = 0x1.62e42fefa38p-1;         // 42 bits: n ln2_high is exact
  static constexpr double ln2_low = 0x1.ef35793c7673p-45;
  static constexpr double two_thirds_log2e_high = 0x1.ec709d8p-1;  // 26 bits
  static constexpr double two_thirds_log2e_low = 0x1.0e80ff5d27f05p-27;
  static constexpr double exp_largest = 710;
  static constexpr double exp_smallest = -746;
  static constexpr double exp2_limit = 1100;
};

template <>
struct Binary<float> {
  using Unsigned = std::uint32_t;
  static constexpr int mantissa_bits = 23;
  static constexpr int bias = 127;
  static constexpr Unsigned low_half = (Unsigned{1} << 12) - 1;
  static constexpr int denormal_shift = 24;
  static constexpr float ln2_high = 0x1.62e4p-1f;
  static constexpr float ln2_low = 0x1.7f7d1cp-20f;
  static constexpr float two_thirds_log2e_high = 0x1.ec6p-1f;
  static constexpr float two_thirds_log2e_low = 0x1.09dc3ap-13f;
  static constexpr float exp_largest = 89;
  static constexpr float exp_smallest = -105;
  static constexpr float exp2_limit = 160;
};

/// The functions of one register of Width numbers. Straight-line code on vector extensions: no branch, table or
/// intrinsic. `a * b + c` becomes one fused operation where the target has it; no step depends on whether it does,
/// because where a product must be exact its factors have half the bits.
template <class T, std::size_t Width>
struct RegisterMath {
  using B = Binary<T>;
  using Unsigned = typename B::Unsigned;
  using V = typename Register<T, Width>::type;
  using U = typename Register<Unsigned, Width>::type;

  static constexpr T infinity = std::numeric_limits<T>::infinity();
  static constexpr T nan = std::numeric_limits<T>::quiet_NaN();
  static constexpr T smallest_normal = std::numeric_limits<T>::min();
  static constexpr T one_in_integers = T(Unsigned{1} << B::mantissa_bits);  // above it a number's last bit is 1
  static constexpr Unsigned sign_bit = Unsigned{1} << (sizeof(T) * 8 - 1);
  static constexpr Unsigned mantissa = (Unsigned{1} << B::mantissa_bits) - 1;

  static U bits(const V& x) { return std::bit_cast<U>(x); }
  static constexpr Unsigned bits(T x) { return std::bit_cast<Unsigned>(x); }
  static V number(const U& u) { return std::bit_cast<V>(u); }
  static V magnitude(const V& x) { return number(bits(x) & ~sign_bit); }
  static V upper_half(const V& x) { return number(bits(x) & ~B::low_half); }
  static V all(T x) { return V{} + x; }
  static constexpr T power_of_two(int n) { return std::bit_cast<T>(Unsigned(n + B::bias) << B::mantissa_bits); }

  /// c[0] + c[1] x + c[2] x^2 + ..., in pairs of pairs (Estrin 1960): the chain of dependent operations is short.
  template <std::size_t n>
  static V polynomial(const V& x, const T (&c)[n]) {
    const V x2 = x * x;
    const V x4 = x2 * x2;
    const V powers[] = {x, x2, x4, x4 * x4};
    return polynomial<n>(powers, c);
  }
  template <std::size_t n>
  static V polynomial(const V (&powers)[4], const T* c) {
    if constexpr (n == 1) {
      return all(c[0]);
    } else {
      constexpr std::size_t half = std::bit_ceil(n) / 2;
      return polynomial<half>(powers, c) + powers[std::bit_width(half) - 1] * polynomial<n - half>(powers, c + half);
    }
  }

  /// Added to a small number, rounds it to the integer n and leaves n + 2 bias in the low bits.
  static constexpr T rounder = T(1.5) * one_in_integers + 2 * B::bias;

  /// e^r 2^n for |r| <= ln(2)/2 and t = n + rounder. 2^n is applied in two factors, so that the result may be denormal.
  /// e^r = 1 + r + r^2 Q(r); Q is minimax (Remez) for the relative error of e^r: 2^-57.9, in float 2^-28.3.
  static V exp_times_power_of_two(const V& r, const V& t) {
    V q;
    if constexpr (std::same_as<T, double>)
      q = polynomial(r, {0x1.000000000000ap-1, 0x1.55555555554fap-3, 0x1.5555555550866p-5, 0x1.1111111127c51p-7,
                         0x1.6c16c1842f58ep-10, 0x1.a01a012a3d4cdp-13, 0x1.a01999fd3bb3dp-16, 0x1.71df2575e706fp-19,
                         0x1.28ad81810f387p-22, 0x1.ad7f5c3b0f5dbp-26});
    else
      q = polynomial(r, {0x1.fffffcp-2f, 0x1.555492p-3f, 0x1.5558f2p-5f, 0x1.1239f8p-7f, 0x1.6a2428p-10f});
    const V e_r = T(1) + (r + r * r * q);
    const V half = (t - rounder) * T(0.5) + (rounder - B::bias);
    return e_r * number(bits(half) << B::mantissa_bits) * number((bits(t) - bits(half)) << B::mantissa_bits);
  }

  /// x = n ln 2 + r (Cody and Waite 1980).
  static V exp(const V& x) {
    const V t = x * std::numbers::log2e_v<T> + rounder;
    const V n = t - rounder;
    V y = exp_times_power_of_two((x - n * B::ln2_high) - n * B::ln2_low, t);
    y = x > B::exp_largest ? all(infinity) : y;
    return x < B::exp_smallest ? V{} : y;
  }

  /// a = 2^k m with sqrt(1/2) <= m < sqrt(2), for finite a > 0.
  struct Parts {
    V k, m;
    explicit Parts(const V& a) {
      constexpr Unsigned lowest = bits(std::numbers::sqrt2_v<T> / 2);
      const auto denormal = a < smallest_normal;
      const U u = bits(denormal ? a * power_of_two(B::denormal_shift) : a) + (bits(T(1)) - lowest);
      const V k_biased = number((u >> B::mantissa_bits) | bits(one_in_integers));
      k = k_biased - (denormal ? all(one_in_integers + B::bias + B::denormal_shift) : all(one_in_integers + B::bias));
      m = number((u & mantissa) + lowest);
    }
  };

  /// W in ln m = 2 atanh s = (2/3) s (3 + z + z^2 W(z)), s = (m - 1)/(m + 1), z = s^2 <= 0.0295. Minimax (Remez) for
  /// the relative error of the logarithm: 2^-66.3, in float 2^-36.8.
  static V log_series(const V& z) {
    if constexpr (std::same_as<T, double>)
      return polynomial(z, {0x1.3333333333464p-1, 0x1.b6db6db683c8fp-2, 0x1.555555a20693fp-2, 0x1.1745af6cbf1b9p-2,
                            0x1.d8ae613bf885dp-3, 0x1.973ff23e2dda8p-3, 0x1.9563469341590p-3});
    else
      return polynomial(z, {0x1.333338p-1f, 0x1.b67be6p-2f, 0x1.67b598p-2f});
  }

  /// With f = m - 1, 2 s = f - s f = f - f^2/2 + s f^2/2 saves the rounding error of s (Ng 1993).
  static V log(const V& x) {
    const Parts p(x);
    const V f = p.m - T(1);
    const V s = f / (p.m + T(1));
    const V z = s * s;
    const V half_f2 = T(0.5) * f * f;
    const V rest = s * (half_f2 + T(2.0 / 3) * (z + z * z * log_series(z)));
    V y = p.k * B::ln2_high + (f - (half_f2 - (rest + p.k * B::ln2_low)));
    y = x < infinity ? y : x;
    return x > T(0) ? y : (x == T(0) ? all(-infinity) : all(nan));
  }

  /// Part of pow that depends on y alone: computed once for a constant y.
  struct Exponent {
    using M = decltype(V{} < V{});
    V y;  // within 2^(bias - 23), so that it is finite
    M zero, integer;
    U odd;  // its sign bit tells
    explicit Exponent(const V& value) {
      constexpr T limit = power_of_two(B::bias - 23);
      y = value > limit ? all(limit) : value;
      y = y < -limit ? all(-limit) : y;
      zero = y == T(0);
      const V a = magnitude(y);
      const V shifted = a + one_in_integers;  // where the last bit of a number is 1
      const M large = a >= one_in_integers;
      integer = large | ((shifted - one_in_integers) == a);
      const M has_ones = integer & (a < 2 * one_in_integers);
      odd = (has_ones ? bits(large ? a : shifted) : U{}) << (sizeof(T) * 8 - 1);
    }
  };

  /// |x|^y = 2^(y log2 |x|), the logarithm in two numbers: y log2 |x| reaches 1075, so that its error needs 10 bits
  /// more than the result has.
  static V pow(const V& x, const Exponent& exponent) {
    const V a = magnitude(x);
    const V y = exponent.y;

    // s = (m - 1)/(m + 1) = s_h + s_l
    const Parts p(a);
    const V f = p.m - T(1);
    const V g = p.m + T(1);
    const V reciprocal = T(1) / g;
    const V s = f * reciprocal;
    const V s_h = upper_half(s);
    const V g_h = upper_half(g);
    const V g_l = p.m - (g_h - T(1));
    const V s_l = ((f - s_h * g_h) - s_h * g_l) * reciprocal;

    // q_h + q_l = 3 + s^2 + s^4 W(s^2). Each high part is taken from what is known early.
    const V z = s * s;
    const V z_h = s_h * s_h;
    const V q_h = upper_half(T(3) + (z_h + T(0.6) * z * z));
    const V q_l = (z * z * log_series(z) + s_l * (s_h + s)) - ((q_h - T(3)) - z_h);

    // w_h + w_l = s q, c_h + c_l = 2/3 log2(e) s q = log2(m), l_h + l_l = k + log2(m) = log2 |x|
    const V u = s_h * q_h;
    const V w_h = upper_half(u);
    const V w_l = (s_l * q_h + q_l * s) + (u - w_h);
    const V c_h = B::two_thirds_log2e_high * w_h;
    const V c_l = B::two_thirds_log2e_low * w_h + (B::two_thirds_log2e_high + B::two_thirds_log2e_low) * w_l;
    const V l_h = upper_half(p.k + c_h);
    const V l_l = c_l - ((l_h - p.k) - c_h);

    // e_h + e_l = y log2 |x|
    const V y_h = upper_half(y);
    const V e_h = y_h * l_h;
    const V e_l = (y - y_h) * l_h + y * l_l;
    const V t = (e_h + e_l) + rounder;
    const V n = t - rounder;
    V result = exp_times_power_of_two(((e_h - n) + e_l) * std::numbers::ln2_v<T>, t);

    // overflow, underflow, |x| = 0, inf, NaN
    const V l = a == T(0) ? all(-infinity) : (a < infinity ? l_h : a);
    const V e = y * l;
    result = e < B::exp2_limit ? result : e + infinity;
    result = e < -B::exp2_limit ? V{} : result;

    const auto one = exponent.zero | (x == T(1));
    result = one ? all(1) : result;

    // x < 0: the sign of an odd power, NaN for a power that is no integer
    result = number(bits(result) | (bits(x) & exponent.odd));
    const auto no_root = (x < T(0)) & (a < infinity) & ~exponent.integer;
    return no_root ? all(nan) : result;
  }

  /// A first guess of x^(-1/3) for normal x > 0: the bits of a number, read as an integer, are its logarithm up to a
  /// factor, an offset and 9 %; so the bits of the root are an offset minus a third of them. Within 3.5 %.
  static V inverse_cbrt_guess(const V& x) {
    if constexpr (std::same_as<T, double>) {
      // 2^52 + i has the integer i in its low bits: conversion to double and back without an instruction for it.
      const V high_word = number((bits(x) >> 32) | bits(one_in_integers));
      constexpr double offset = 0x553ef0ff + one_in_integers + one_in_integers / 3;
      return number(bits(high_word * (-1.0 / 3) + offset) << 32);
    } else {
      using I = typename Register<std::int32_t, Width>::type;
      const V x_bits = __builtin_convertvector(std::bit_cast<I>(x), V);
      return std::bit_cast<V>(__builtin_convertvector(x_bits * (-1.0f / 3) + T(0x54a21d2a), I));
    }
  }

  /// By the reciprocal root t, which needs no division: with e = 1 - x t^3,
  ///   x^(-1/3) = t (1 - e)^(-1/3) = t (1 + e/3 + 2 e^2/9 + ...)
  ///   x^(1/3) = x t^2 (1 - e)^(-2/3) = x t^2 (1 + 2 e/3 + 5 e^2/9 + 40 e^3/81 + 110 e^4/243 + ...)
  /// The first step takes |e| <= 0.11 to 7e-4; what the second leaves out is 0.42 e^5 = 6e-17 of the result.
  static V cbrt(const V& x) {
    const V a = magnitude(x);
    const auto denormal = a < smallest_normal;
    const V m = denormal ? a * power_of_two(B::denormal_shift) : a;

    V t = inverse_cbrt_guess(m);
    V e = T(1) - (m * t) * (t * t);
    t = t + t * e * polynomial(e, {T(1.0 / 3), T(2.0 / 9)});

    V y = (m * t) * t;
    e = T(1) - y * t;
    if constexpr (std::same_as<T, double>)
      y = y + y * e * polynomial(e, {2.0 / 3, 5.0 / 9, 40.0 / 81, 110.0 / 243});
    else
      y = y + y * e * polynomial(e, {2.0f / 3, 5.0f / 9});

    y = denormal ? y * power_of_two(-B::denormal_shift / 3) : y;
    y = a < infinity ? y : a;
    return number(bits(y) | (bits(x) & sign_bit));
  }
};

template <class T, std::size_t N>
using PackMath = RegisterMath<T, Pack<T, N>::width>;

}  // namespace detail

// Errors in units in the last place (ulp), the largest measured against 64-bit long double over all binades, in float
// over all arguments of exp, log and cbrt, with and without fused operations. Denormals count as numbers: they are
// taken and given with the precision they have. No function branches, allocates or touches errno.

/// The real cube root of every number, to 1.6 ulp. cbrt(-x) = -cbrt(x); +-0, +-inf and NaN give themselves.
template <class T, std::size_t N>
Pack<T, N> cbrt(const Pack<T, N>& x) {
  return detail::by_register<Pack<T, N>>([&](std::size_t k) { return detail::PackMath<T, N>::cbrt(x.native(k)); });
}

/// e^x for every x, to 1.1 ulp. Above 709.8 (float: 88.7) inf, below -745.1 (-104) 0, in between denormal from -708.4
/// (-87.3).
template <class T, std::size_t N>
Pack<T, N> exp(const Pack<T, N>& x) {
  return detail::by_register<Pack<T, N>>([&](std::size_t k) { return detail::PackMath<T, N>::exp(x.native(k)); });
}

/// The natural logarithm of every x > 0, to 0.9 ulp. log(+-0) = -inf, log(inf) = inf, NaN for x < 0.
template <class T, std::size_t N>
Pack<T, N> log(const Pack<T, N>& x) {
  return detail::by_register<Pack<T, N>>([&](std::size_t k) { return detail::PackMath<T, N>::log(x.native(k)); });
}

/// x^y for every x and y, to 1.5 ulp (float 1.7), with the special values of C (ISO C, F.10.4.4): pow(x, 0) = 1 and
/// pow(1, y) = 1 even for NaN, pow(0, y > 0) = 0, pow(0, y < 0) = inf; x < 0 needs a whole y, else NaN.
template <class T, std::size_t N>
Pack<T, N> pow(const Pack<T, N>& x, const std::type_identity_t<Pack<T, N>>& y) {
  using Math = detail::PackMath<T, N>;
  return detail::by_register<Pack<T, N>>(
      [&](std::size_t k) { return Math::pow(x.native(k), typename Math::Exponent(y.native(k))); });
}
template <class T, std::size_t N, class Number>
  requires std::is_arithmetic_v<Number>
Pack<T, N> pow(const Pack<T, N>& x, Number y) {
  using Math = detail::PackMath<T, N>;
  const typename Math::Exponent exponent(Math::all(static_cast<T>(y)));
  return detail::by_register<Pack<T, N>>([&](std::size_t k) { return Math::pow(x.native(k), exponent); });
}
template <class T, std::size_t N, class Number>
  requires std::is_arithmetic_v<Number>
Pack<T, N> pow(Number x, const Pack<T, N>& y) {
  return pow(Pack<T, N>(x), y);
}

}  // namespace strike
