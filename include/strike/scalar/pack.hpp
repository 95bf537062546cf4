#pragma once
#include <bit>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>

#include <strike/cxx20.hpp>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace strike {

namespace detail {

#if defined(__AVX512F__) && !defined(__znver4__) && !defined(__znver3__)
inline constexpr std::size_t register_bytes = 64;
#elif defined(__AVX__)  // and Zen 4, which older compilers name after Zen 3: it works on 512 bits by halves
inline constexpr std::size_t register_bytes = 32;
#else
inline constexpr std::size_t register_bytes = 16;
#endif

template <class T, std::size_t Width>
struct Register {
  typedef T type __attribute__((vector_size(Width * sizeof(T))));
};

template <class T>
using SignedOf = std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t>;

/// f(k) in every register k. Unrolled by the language, because a loop would keep the registers in memory.
template <class Result, class F>
constexpr Result by_register(F f) {
  return [&]<std::size_t... k>(std::index_sequence<k...>) {
    Result r;
    ((r.native(k) = f(k)), ...);
    return r;
  }(std::make_index_sequence<Result::registers>{});
}

}  // namespace detail

/// Numbers of type T in one register of the target.
template <class T>
inline constexpr std::size_t native_lanes = detail::register_bytes / sizeof(T);

template <class T, std::size_t N>
class Mask;

/// N numbers that are computed at once, one in each lane of the machine's vector registers. Behaves like one number:
/// every formula written for `double` runs on it; a comparison gives a `Mask`, and a branch is `select(mask, then,
/// otherwise)`. Literals convert by themselves. N is a power of two.
template <std::floating_point T, std::size_t N = native_lanes<T>>
class Pack {
  static_assert(std::has_single_bit(N), "strike: the number of lanes of a Pack must be a power of two.");

 public:
  /// N = registers * width. For code that moves data, not for formulas.
  static constexpr std::size_t width = N < native_lanes<T> ? N : native_lanes<T>;
  static constexpr std::size_t registers = N / width;
  using value_type = T;
  using Register = typename detail::Register<T, width>::type;

  Pack() = default;
  template <class U>
    requires std::is_arithmetic_v<U>
  constexpr Pack(U value)  // implicit: literals stand in formulas
      : Pack(detail::by_register<Pack>([&](std::size_t) { return static_cast<T>(value) - Register{}; })) {}  // exact

  /// The same numbers in another precision.
  template <std::floating_point U>
  explicit Pack(const Pack<U, N>& a) {
    if constexpr (width == Pack<U, N>::width)
      for (std::size_t k = 0; k < registers; ++k) r_[k] = __builtin_convertvector(a.native(k), Register);
    else
      for (std::size_t i = 0; i < N; ++i) set(i, static_cast<T>(a[i]));
  }

  static constexpr std::size_t size() { return N; }
  T operator[](std::size_t lane) const { return r_[lane / width][lane % width]; }
  void set(std::size_t lane, T value) { r_[lane / width][lane % width] = value; }

  /// The k-th register: for code that moves data, not for formulas.
  constexpr Register& native(std::size_t k) { return r_[k]; }
  constexpr const Register& native(std::size_t k) const { return r_[k]; }

  /// f(lane) in every lane.
  template <class F>
  static Pack generate(F f) {
    Pack p;
    for (std::size_t i = 0; i < N; ++i) p.set(i, static_cast<T>(f(i)));
    return p;
  }

  friend Pack operator+(const Pack& a, const Pack& b) {
    return detail::by_register<Pack>([&](std::size_t k) { return a.r_[k] + b.r_[k]; });
  }
  friend Pack operator-(const Pack& a, const Pack& b) {
    return detail::by_register<Pack>([&](std::size_t k) { return a.r_[k] - b.r_[k]; });
  }
  friend Pack operator*(const Pack& a, const Pack& b) {
    return detail::by_register<Pack>([&](std::size_t k) { return a.r_[k] * b.r_[k]; });
  }
  friend Pack operator/(const Pack& a, const Pack& b) {
    return detail::by_register<Pack>([&](std::size_t k) { return a.r_[k] / b.r_[k]; });
  }
  friend Pack operator-(const Pack& a) {
    return detail::by_register<Pack>([&](std::size_t k) { return -a.r_[k]; });
  }
  friend Pack operator+(const Pack& a) { return a; }
  Pack& operator+=(const Pack& b) { return *this = *this + b; }
  Pack& operator-=(const Pack& b) { return *this = *this - b; }
  Pack& operator*=(const Pack& b) { return *this = *this * b; }
  Pack& operator/=(const Pack& b) { return *this = *this / b; }

  friend Mask<T, N> operator<(const Pack& a, const Pack& b) {
    return detail::by_register<Mask<T, N>>([&](std::size_t k) { return a.r_[k] < b.r_[k]; });
  }
  friend Mask<T, N> operator<=(const Pack& a, const Pack& b) {
    return detail::by_register<Mask<T, N>>([&](std::size_t k) { return a.r_[k] <= b.r_[k]; });
  }
  friend Mask<T, N> operator==(const Pack& a, const Pack& b) {
    return detail::by_register<Mask<T, N>>([&](std::size_t k) { return a.r_[k] == b.r_[k]; });
  }
  friend Mask<T, N> operator>(const Pack& a, const Pack& b) { return b < a; }
  friend Mask<T, N> operator>=(const Pack& a, const Pack& b) { return b <= a; }
  friend Mask<T, N> operator!=(const Pack& a, const Pack& b) { return !(a == b); }

  friend Pack select(const Mask<T, N>& m, const Pack& then, const Pack& otherwise) {
    return detail::by_register<Pack>([&](std::size_t k) { return m.native(k) ? then.r_[k] : otherwise.r_[k]; });
  }
  friend Pack min(const Pack& a, const Pack& b) { return select(b < a, b, a); }
  friend Pack max(const Pack& a, const Pack& b) { return select(a < b, b, a); }
  friend Pack abs(const Pack& a) {
    constexpr auto sign = std::numeric_limits<detail::SignedOf<T>>::min();
    return detail::by_register<Pack>([&](std::size_t k) {
      return std::bit_cast<Register>(std::bit_cast<typename Mask<T, N>::Register>(a.r_[k]) & ~sign);
    });
  }
  friend Pack sqrt(const Pack& a) {
    return detail::by_register<Pack>([&](std::size_t k) { return root(a.r_[k]); });
  }
  /// 1/sqrt(a) to 2 ulp: in the widest registers by the machine's first 14 bits, which takes half the time of root and
  /// quotient.
  friend Pack rsqrt(const Pack& a) {
    return detail::by_register<Pack>([&](std::size_t k) { return inverse_root(a.r_[k]); });
  }
  friend T reduce_sum(const Pack& a) {
    T s = a[0];
    for (std::size_t i = 1; i < N; ++i) s += a[i];
    return s;
  }
  friend T reduce_min(const Pack& a) {
    T s = a[0];
    for (std::size_t i = 1; i < N; ++i) s = a[i] < s ? a[i] : s;
    return s;
  }
  friend T reduce_max(const Pack& a) { return -reduce_min(-a); }

 private:
  /// From y = (1 - e)^(1/2)/sqrt(a): 1/sqrt(a) = y (1 + e/2 + 3 e^2/8 + 5 e^3/16 + ...), |e| < 2^-13. Of 0, inf and NaN
  /// the machine's guess is exact, and e is NaN.
  static Register inverse_root(const Register& a) {
#if defined(__AVX512F__)
    if constexpr (sizeof(Register) == 64) {
      Register y;
      if constexpr (sizeof(T) == 8)
        y = _mm512_maskz_rsqrt14_pd(0xff, a);
      else
        y = _mm512_maskz_rsqrt14_ps(0xffff, a);
      const Register e = T(1) - (a * y) * y;
      return e == e ? y + y * e * (T(0.5) + e * (T(0.375) + e * T(0.3125))) : y;
    }
#endif
    return (Register{} + T(1)) / root(a);
  }
  static Register root(const Register& a) {
#if defined(__AVX512F__)
    if constexpr (sizeof(Register) == 64) {
      if constexpr (sizeof(T) == 8)
        return _mm512_maskz_sqrt_pd(0xff, a);
      else
        return _mm512_maskz_sqrt_ps(0xffff, a);
    } else
#endif
#if defined(__AVX__)
        if constexpr (sizeof(Register) == 32) {
      if constexpr (sizeof(T) == 8)
        return _mm256_sqrt_pd(a);
      else
        return _mm256_sqrt_ps(a);
    } else
#endif
#if defined(__SSE2__)
        if constexpr (sizeof(Register) == 16) {
      if constexpr (sizeof(T) == 8)
        return _mm_sqrt_pd(a);
      else
        return _mm_sqrt_ps(a);
    } else
#endif
    {
      Register c{};
      for (std::size_t i = 0; i < width; ++i) c[i] = std::sqrt(a[i]);
      return c;
    }
  }

  Register r_[registers];
};

/// One yes or no per lane of a `Pack<T, N>`.
template <class T, std::size_t N>
class Mask {
  using Flag = detail::SignedOf<T>;

 public:
  static constexpr std::size_t width = Pack<T, N>::width;
  static constexpr std::size_t registers = Pack<T, N>::registers;
  using Register = typename detail::Register<Flag, width>::type;

  Mask() = default;
  constexpr Mask(bool value)  // implicit: `select(true, a, b)` is a formula too
      : Mask(detail::by_register<Mask>([&](std::size_t) { return Register{} - static_cast<Flag>(value); })) {}
  bool operator[](std::size_t lane) const { return r_[lane / width][lane % width] != 0; }
  constexpr Register& native(std::size_t k) { return r_[k]; }
  constexpr const Register& native(std::size_t k) const { return r_[k]; }

  /// Refused: a branch has one answer, the lanes have N.
  explicit operator bool() const {
    static_assert(sizeof(T) == 0,
                  "strike: an `if` on lanes has one answer for each: write select(condition, then, otherwise), or "
                  "any(condition) or all(condition) for one answer.");
    return false;
  }

  friend Mask operator&&(const Mask& a, const Mask& b) {
    return detail::by_register<Mask>([&](std::size_t k) { return a.r_[k] & b.r_[k]; });
  }
  friend Mask operator||(const Mask& a, const Mask& b) {
    return detail::by_register<Mask>([&](std::size_t k) { return a.r_[k] | b.r_[k]; });
  }
  friend Mask operator!(const Mask& a) {
    return detail::by_register<Mask>([&](std::size_t k) { return ~a.r_[k]; });
  }
  friend bool any(const Mask& a) {
    Register one = a.r_[0];
    for (std::size_t k = 1; k < registers; ++k) one |= a.r_[k];
    return any_of(one);
  }
  friend bool all(const Mask& a) { return !any(!a); }

 private:
  static bool any_of(const Register& a) {
#if defined(__AVX512F__)
    if constexpr (sizeof(Register) == 64)
      return _mm512_test_epi32_mask(std::bit_cast<__m512i>(a), std::bit_cast<__m512i>(a)) != 0;
    else
#endif
#if defined(__AVX__)
        if constexpr (sizeof(Register) == 32)
      return _mm256_testz_si256(std::bit_cast<__m256i>(a), std::bit_cast<__m256i>(a)) == 0;
    else
#endif
#if defined(__SSE2__)
        if constexpr (sizeof(Register) == 16)
      return _mm_movemask_epi8(std::bit_cast<__m128i>(a)) != 0;
    else
#endif
    {
      Flag flag = 0;
      for (std::size_t i = 0; i < width; ++i) flag |= a[i];
      return flag != 0;
    }
  }

  Register r_[registers];
};

}  // namespace strike
