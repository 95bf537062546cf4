#pragma once
#include <array>
#include <concepts>
#include <cstddef>
#include <type_traits>
#include <utility>

#include <strike/scalar/scalar.hpp>

namespace strike {

/// A number and its derivatives by N variables (forward automatic differentiation): u + u,i d_i with d_i d_j = 0.
/// T is any Scalar; `Dual<Dual<double, N>, N>` has the second derivatives. Compares, and so selects, by the value;
/// where a formula has a kink (abs, min, max, select) the derivative is that of the branch taken, at abs(0) the right
/// one. An infinite slope, as of sqrt at 0, gives an infinite or NaN derivative and a right value. (Griewank and
/// Walther, Evaluating Derivatives, 2008, section 3.1.)
template <class T, std::size_t N>
class Dual {
  template <class U>
  static constexpr bool is_constant = std::is_arithmetic_v<U> || std::same_as<U, T>;

 public:
  using value_type = T;
  using Mask = decltype(std::declval<T>() < std::declval<T>());

  Dual() = default;
  template <class U>
    requires is_constant<U>
  constexpr Dual(const U& value) : value_(static_cast<T>(value)) {  // implicit: literals stand in formulas
    derivatives_.fill(T(0));
  }
  constexpr Dual(const T& value, const std::array<T, N>& derivatives) : value_(value), derivatives_(derivatives) {}

  /// The i-th of the N variables, whose derivative by itself is 1.
  static constexpr Dual variable(const T& value, std::size_t i) {
    Dual u(value);
    u.derivatives_[i] = T(1);
    return u;
  }

  static constexpr std::size_t variables() { return N; }
  /// The value alone: for output in plain numbers, never for formulas.
  explicit constexpr operator T() const { return value_; }
  constexpr const T& value() const { return value_; }
  constexpr const T& derivative(std::size_t i) const { return derivatives_[i]; }

  friend constexpr Dual operator+(const Dual& a) { return a; }
  friend constexpr Dual operator-(const Dual& a) {
    return map(-a.value_, [&](std::size_t i) { return -a.derivatives_[i]; });
  }

  friend constexpr Dual operator+(const Dual& a, const Dual& b) {
    return map(a.value_ + b.value_, [&](std::size_t i) { return a.derivatives_[i] + b.derivatives_[i]; });
  }
  friend constexpr Dual operator-(const Dual& a, const Dual& b) {
    return map(a.value_ - b.value_, [&](std::size_t i) { return a.derivatives_[i] - b.derivatives_[i]; });
  }
  friend constexpr Dual operator*(const Dual& a, const Dual& b) {
    return map(a.value_ * b.value_,
               [&](std::size_t i) { return a.derivatives_[i] * b.value_ + a.value_ * b.derivatives_[i]; });
  }
  friend constexpr Dual operator/(const Dual& a, const Dual& b) {
    const T q = a.value_ / b.value_;
    return map(q, [&](std::size_t i) { return (a.derivatives_[i] - q * b.derivatives_[i]) / b.value_; });
  }

  // A constant has no derivatives: half the work, and no 0 * inf.
  template <class U>
    requires is_constant<U>
  friend constexpr Dual operator+(const Dual& a, const U& b) {
    return {a.value_ + T(b), a.derivatives_};
  }
  template <class U>
    requires is_constant<U>
  friend constexpr Dual operator+(const U& a, const Dual& b) {
    return b + a;
  }
  template <class U>
    requires is_constant<U>
  friend constexpr Dual operator-(const Dual& a, const U& b) {
    return {a.value_ - T(b), a.derivatives_};
  }
  template <class U>
    requires is_constant<U>
  friend constexpr Dual operator-(const U& a, const Dual& b) {
    return -b + a;
  }
  template <class U>
    requires is_constant<U>
  friend constexpr Dual operator*(const Dual& a, const U& b) {
    const T c(b);
    return map(a.value_ * c, [&](std::size_t i) { return a.derivatives_[i] * c; });
  }
  template <class U>
    requires is_constant<U>
  friend constexpr Dual operator*(const U& a, const Dual& b) {
    return b * a;
  }
  template <class U>
    requires is_constant<U>
  friend constexpr Dual operator/(const Dual& a, const U& b) {
    const T c(b);
    return map(a.value_ / c, [&](std::size_t i) { return a.derivatives_[i] / c; });
  }
  template <class U>
    requires is_constant<U>
  friend constexpr Dual operator/(const U& a, const Dual& b) {
    const T q = T(a) / b.value_;
    return chain(b, q, -q / b.value_);
  }

  template <class U>
  constexpr Dual& operator+=(const U& b) {
    return *this = *this + b;
  }
  template <class U>
  constexpr Dual& operator-=(const U& b) {
    return *this = *this - b;
  }
  template <class U>
  constexpr Dual& operator*=(const U& b) {
    return *this = *this * b;
  }
  template <class U>
  constexpr Dual& operator/=(const U& b) {
    return *this = *this / b;
  }

  friend constexpr Mask operator<(const Dual& a, const Dual& b) { return a.value_ < b.value_; }
  friend constexpr Mask operator<=(const Dual& a, const Dual& b) { return a.value_ <= b.value_; }
  friend constexpr Mask operator>(const Dual& a, const Dual& b) { return a.value_ > b.value_; }
  friend constexpr Mask operator>=(const Dual& a, const Dual& b) { return a.value_ >= b.value_; }
  friend constexpr Mask operator==(const Dual& a, const Dual& b) { return a.value_ == b.value_; }
  friend constexpr Mask operator!=(const Dual& a, const Dual& b) { return a.value_ != b.value_; }

  friend constexpr Dual select(const Mask& m, const Dual& then, const Dual& otherwise) {
    return map(select(m, then.value_, otherwise.value_),
               [&](std::size_t i) { return select(m, then.derivatives_[i], otherwise.derivatives_[i]); });
  }
  friend constexpr Dual min(const Dual& a, const Dual& b) { return select(b < a, b, a); }
  friend constexpr Dual max(const Dual& a, const Dual& b) { return select(a < b, b, a); }
  friend constexpr Dual abs(const Dual& a) { return select(a.value_ < T(0), -a, a); }

  friend Dual sqrt(const Dual& a) {
    const T root = sqrt(a.value_);
    return chain(a, root, T(0.5) / root);
  }
  friend Dual rsqrt(const Dual& a) {
    const T root = rsqrt(a.value_);
    return chain(a, root, T(-0.5) * root / a.value_);
  }
  friend Dual cbrt(const Dual& a) {
    const T root = cbrt(a.value_);
    return chain(a, root, 1 / (3 * root * root));
  }
  friend Dual exp(const Dual& a) {
    const T power = exp(a.value_);
    return chain(a, power, power);
  }
  friend Dual log(const Dual& a) { return chain(a, log(a.value_), 1 / a.value_); }

  template <class U>
    requires is_constant<U>
  friend Dual pow(const Dual& a, const U& b) {
    const T n(b);
    const T power = pow(a.value_, n);
    using Limits = std::numeric_limits<RealOf<T>>;
    if (all(a.value_ >= Limits::min() && power >= Limits::min() && power <= Limits::max()))
      return chain(a, power, n * (power / a.value_));
    const T slope = n * pow(a.value_, n - 1);
    return chain(a, power, select(n == T(0) && a.value_ == T(0), T(0), slope));
  }
  template <class U>
    requires is_constant<U>
  friend Dual pow(const U& a, const Dual& b) {
    const T base(a);
    const T power = pow(base, b.value_);
    const T slope = power * log(base);
    return chain(b, power, select(power == T(0), T(0), slope));
  }
  friend Dual pow(const Dual& a, const Dual& b) {
    const Dual by_base = pow(a, b.value_);
    const Dual by_exponent = pow(a.value_, b);
    return map(by_base.value_, [&](std::size_t i) {
      const auto constant = b.derivatives_[i] == T(0) && a.value_ <= T(0);  // there a^b has no slope in b
      return by_base.derivatives_[i] + select(constant, T(0), by_exponent.derivatives_[i]);
    });
  }

 private:
  template <class F>
  static constexpr Dual map(const T& value, F derivative) {
    Dual u;
    u.value_ = value;
    for (std::size_t i = 0; i < N; ++i) u.derivatives_[i] = derivative(i);
    return u;
  }
  /// f(a) by the chain rule, from f and its slope at the value of a.
  static constexpr Dual chain(const Dual& a, const T& f, const T& slope) {
    return map(f, [&](std::size_t i) { return slope * a.derivatives_[i]; });
  }

  T value_;
  std::array<T, N> derivatives_;
};

namespace detail {
template <class T, std::size_t N>
struct ScalarTraits<Dual<T, N>> {
  using Real = RealOf<T>;
  using Lane = Dual<LaneOf<T>, N>;
  static constexpr std::size_t lanes = strike::lanes<T>;
};
}  // namespace detail

template <class T, std::size_t N>
constexpr LaneOf<Dual<T, N>> lane(const Dual<T, N>& a, std::size_t i) {
  std::array<LaneOf<T>, N> derivatives;
  for (std::size_t k = 0; k < N; ++k) derivatives[k] = lane(a.derivative(k), i);
  return {lane(a.value(), i), derivatives};
}
template <class T, std::size_t N>
constexpr void set_lane(Dual<T, N>& a, std::size_t i, const LaneOf<Dual<T, N>>& lane_i) {
  T value = a.value();
  set_lane(value, i, lane_i.value());
  std::array<T, N> derivatives;
  for (std::size_t k = 0; k < N; ++k) {
    derivatives[k] = a.derivative(k);
    set_lane(derivatives[k], i, lane_i.derivative(k));
  }
  a = {value, derivatives};
}

template <class T, std::size_t N>
constexpr LaneOf<Dual<T, N>> reduce_sum(const Dual<T, N>& a) {
  auto s = lane(a, 0);
  for (std::size_t i = 1; i < lanes<T>; ++i) s += lane(a, i);
  return s;
}
template <class T, std::size_t N>
constexpr LaneOf<Dual<T, N>> reduce_min(const Dual<T, N>& a) {
  auto s = lane(a, 0);
  for (std::size_t i = 1; i < lanes<T>; ++i) s = min(s, lane(a, i));
  return s;
}
template <class T, std::size_t N>
constexpr LaneOf<Dual<T, N>> reduce_max(const Dual<T, N>& a) {
  auto s = lane(a, 0);
  for (std::size_t i = 1; i < lanes<T>; ++i) s = max(s, lane(a, i));
  return s;
}

}  // namespace strike
