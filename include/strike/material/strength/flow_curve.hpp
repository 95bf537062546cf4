#pragma once
#include <array>
#include <cstddef>
#include <limits>

#include <strike/scalar/dual.hpp>
#include <strike/scalar/scalar.hpp>

namespace strike {

/// A quantity that depends on the increment dl of the plastic strain in a step, near one dl: the series
/// c0 + c1 u + c2 u^2 + c3 u^3 in a change u of ln dl. Increments range over many decades, and powers and logarithms of
/// the rate have closed series in u.
template <class T>
struct LogSeries {
  T c0, c1, c2, c3;

  T operator()(const T& u) const { return c0 + u * (c1 + u * (c2 + u * c3)); }

  friend LogSeries operator+(const LogSeries& a, const LogSeries& b) {
    return {a.c0 + b.c0, a.c1 + b.c1, a.c2 + b.c2, a.c3 + b.c3};
  }
  friend LogSeries operator+(const T& a, const LogSeries& b) { return {a + b.c0, b.c1, b.c2, b.c3}; }
  friend LogSeries operator*(const LogSeries& a, const LogSeries& b) {
    return {a.c0 * b.c0, a.c0 * b.c1 + a.c1 * b.c0, a.c0 * b.c2 + a.c1 * b.c1 + a.c2 * b.c0,
            a.c0 * b.c3 + a.c1 * b.c2 + a.c2 * b.c1 + a.c3 * b.c0};
  }
  friend LogSeries operator*(const T& a, const LogSeries& b) { return {a * b.c0, a * b.c1, a * b.c2, a * b.c3}; }

  /// a e^(k u).
  static LogSeries exponential(const T& a, const T& k) {
    const T k_a = k * a, k2_a = k * k_a;
    return {a, k_a, 0.5 * k2_a, (1.0 / 6) * k * k2_a};
  }
  /// a e^u, as dl itself is.
  static LogSeries proportional(const T& a) { return {a, a, 0.5 * a, (1.0 / 6) * a}; }
};

namespace detail {

/// A law that gives the flow stress of a step as a curve, an object c with
///   c.at_rest()         flow stress at dl = 0 and no rate
///   c.start_at(dl)      to its first increment
///   c.move_to(dl, u)    to another, after a change u of ln dl without derivatives
///   c.series(dl)        LogSeries of the flow stress there
///   c.is_smooth(dl, u)  optional: lanes in which no kink lies between dl and dl e^u
/// Model: PowerHardening.
template <class Law, class T = double>
concept HasFlowCurve = requires(const Law law, const T x) { law.flow_curve(x, 1.0); } ||
                       requires(const Law law, const T x) { law.flow_curve(x, x, 1.0); };

template <class Curve, class T>
concept HasKinks = requires(const Curve curve, const T x) { curve.is_smooth(x, x); };

/// A number without its derivatives.
template <class T>
T constant(const T& x) {
  return x;
}
template <class T, std::size_t N>
Dual<T, N> constant(const Dual<T, N>& x) {
  return x.value();
}

template <class T>
inline constexpr bool is_dual = false;
template <class T, std::size_t N>
inline constexpr bool is_dual<Dual<T, N>> = true;

/// (1 + a1 u + a2 u^2 + a3 u^3)^-2 of a series whose c0 is 1.
template <class T>
LogSeries<T> inverse_square(const LogSeries<T>& a) {
  const T a1 = a.c1, square = a1 * a1;
  return {T(1.0), -2.0 * a1, 3.0 * square - 2.0 * a.c2, a1 * (6.0 * a.c2 - 4.0 * square) - 2.0 * a.c3};
}
/// a^(-1/2).
template <class T>
LogSeries<T> inverse_root(const LogSeries<T>& a) {
  const T root = rsqrt(a.c0), scale = -0.5 * root * root;
  const T a1 = scale * a.c1, a2 = scale * a.c2, a3 = scale * a.c3;
  return {root, root * a1, root * (a2 + 1.5 * a1 * a1), root * (a3 + a1 * (3.0 * a2 + 2.5 * a1 * a1))};
}

/// z^n by exp and log, two thirds of the work of pow. The error of n |ln z| roundings of z^n is less than a rounding of
/// 1 for z < 1.
template <class T>
T raised(const T& z, double n) {
  return n == 1 ? z : n == 0 ? T(1.0) : n == 0.5 ? T(sqrt(z)) : T(exp(T(n * log(z))));
}

/// (e + dl)^n on the way of dl.
template <class T>
class StrainPower {
 public:
  StrainPower(const T& e, double n) : e_(e), n_(n) {}

  T at_rest() const { return raised(e_, n_); }
  void move_to(const T& dl) { power_ = raised(T(e_ + dl), n_); }
  /// The binomial series of [1 + w (e^u - 1)]^n, w = dl/(e + dl).
  LogSeries<T> series(const T& dl) const {
    const T w = dl / (e_ + dl), c1 = n_ * w;
    const T a = (0.5 * (n_ - 1)) * w, b = (1.0 / 6 * (n_ - 1) * (n_ - 2)) * w * w;
    const T p = c1 * power_;
    return {power_, p, p * (0.5 + a), p * (1.0 / 6 + a + b)};
  }

 private:
  T e_;
  double n_;
  T power_{};
};

/// r^n on the way of the rate r = dl/dt.
template <class T>
class RatePower {
 public:
  explicit RatePower(double n) : n_(n) {}

  void start_at(const T& rate) { power_ = pow(rate, n_); }
  void move(const T& u) { power_ *= exp(T(n_ * u)); }
  LogSeries<T> series() const {
    return {power_, n_ * power_, (0.5 * n_ * n_) * power_, (1.0 / 6 * n_ * n_ * n_) * power_};
  }

 private:
  double n_;
  T power_{};
};

/// A stress that is linear in the strain between two strains.
template <class T>
struct StrainLine {
  T stress, slope, from, to;
};

/// A step of Householder's of fourth order towards g = 1, from the series of a rising g, by one quotient:
///   u = N (1 + A2 N)/(1 + 2 A2 N + A3 N^2),  N = (1 - g)/g',  A2 = g''/(2 g'),  A3 = g'''/(6 g')
/// Of an exponential it passes no root, from either side. Elsewhere it is held to four of Newton's steps N; where g
/// falls it is 1 towards the root. `open` marks the lanes that count.
template <class T, class M>
T householder_step(const LogSeries<T>& g, const M& open) {
  const T lack = 1.0 - g.c0, square = g.c1 * g.c1, bend = lack * g.c2;
  const T u = lack * (square + bend) / (g.c1 * (square + (bend + bend)) + lack * lack * g.c3);
  const T rise = u * g.c1;  // of a line, `lack` in Newton's step
  const auto sound = g.c1 > 0.0 && rise * lack >= 0.0 && abs(rise) <= 4.0 * abs(lack);
  if (!any(open && !sound)) return u;
  const T newton = lack / g.c1;
  return select(sound, u, select(newton * lack >= 0.0, newton, select(lack < 0.0, T(-1.0), T(1.0))));
}

/// The increments of n points and the flow stresses there.
template <class T, std::size_t n>
struct Increments {
  std::array<T, n> dl, stress;
};

/// A point that yields: where to look for its increment.
template <class T>
struct Search {
  decltype(T{} > T{}) yields;
  T guess;  ///< of dl
  T rest;   ///< g at dl = 0
  T most;   ///< no root is above it
};

/// The roots of g_k(dl) = 1, k < n, for rising g, with `measure(k, stress, dl)` the g of a flow stress. Steps are
/// Householder's of fourth order in ln dl (Householder 1970, section 4.4); far away, where g has risen from rest by
/// less than a quarter or more than four times of what it must, they are Newton's of the logarithm of this rise, exact
/// for a power of dl. Steps that leave the bracket halve it in ln dl. A lane is done when 1 - g is rounding, or when
/// the fourth power of a step is, on a curve without a kink between. Then it keeps its answer, so that it depends on no
/// other. Dual numbers go on until the square of a step is rounding: so much their last step errs in its derivatives,
/// which are those of the implicit function. The points take each step side by side, for each is a long chain of
/// dependent operations.
template <std::size_t n, class T, class Curve, class Measure>
Increments<T, n> find_increments(std::array<Curve, n>& curves, const std::array<Search<T>, n>& searches,
                                 const Measure& measure) {
  using Limits = std::numeric_limits<RealOf<T>>;
  constexpr bool in_double = sizeof(RealOf<T>) == sizeof(double);
  constexpr double rounding = 16.0 * Limits::epsilon(), root = in_double ? 1.5e-8 : 3.5e-4;  // of epsilon
  constexpr double small_step = is_dual<T> ? root : 0.5 * (in_double ? 1.2e-4 : 1.9e-2);
  struct Iterate {
    T dl, lower, upper, rest, per_excess, step;
    decltype(T{} > T{}) open;
  };
  std::array<Iterate, n> iterates;
  Increments<T, n> found;
  for (std::size_t k = 0; k < n; ++k) {
    const Search<T>& search = searches[k];
    const T rest = constant(search.rest);
    iterates[k] = {.dl = constant(search.guess),
                   .lower = T(Limits::min()),
                   .upper = search.most,
                   .rest = rest,
                   .per_excess = 1.0 / (1.0 - rest),
                   .step = T(0.0),
                   .open = search.yields};
    found.dl[k] = found.stress[k] = T(0.0);
    curves[k].start_at(iterates[k].dl);
  }
  for (int i = 0; i < 100; ++i) {
    bool more = false;
    for (std::size_t k = 0; k < n; ++k) {
      auto& [dl, lower, upper, rest, per_excess, step, open] = iterates[k];
      const LogSeries<T> stress = curves[k].series(dl), g = measure(k, stress, dl);
      const T error = g.c0 - 1.0, rise = (g.c0 - rest) * per_excess;
      T u = householder_step(g, open);
      const auto far = open && !(rise < 4.0 && rise > 0.25);
      if (any(far)) u = select(far, T(-log(max(T(Limits::min()), rise)) * (g.c0 - rest) / g.c1), u);

      auto settled = !far && abs(u) <= small_step && abs(error) <= small_step * abs(g.c1);
      if constexpr (HasKinks<Curve, T>) settled = settled && curves[k].is_smooth(dl, u);
      settled = open && (settled || abs(error) <= rounding);
      const T last = max(T(-0.5), min(T(0.5), u));
      found.dl[k] = select(settled, dl * (1.0 + last * (1.0 + last * (0.5 + (1.0 / 6) * last))), found.dl[k]);
      found.stress[k] = select(settled, stress(last), found.stress[k]);
      open = open && !settled;
      step = T(0.0);
      if (!any(open)) continue;

      more = true;
      T next = dl * exp(u);
      lower = select(error <= 0.0, dl, lower);
      upper = select(error <= 0.0, upper, dl);
      const auto outside = open && !(next > lower && next < upper);
      if (any(outside)) {
        next = select(outside, sqrt(lower) * sqrt(upper), next);
        u = select(outside, T(log(next / dl)), u);
      }
      step = constant(T(select(open, u, T(0.0))));
      dl = constant(T(select(open, next, dl)));
    }
    if (!more) return found;
    for (std::size_t k = 0; k < n; ++k) curves[k].move_to(iterates[k].dl, iterates[k].step);
  }
  for (std::size_t k = 0; k < n; ++k) {
    const auto& [dl, lower, upper, rest, per_excess, step, open] = iterates[k];
    found.dl[k] = select(open, dl, found.dl[k]);
    found.stress[k] = select(open, curves[k].series(dl).c0, found.stress[k]);
  }
  return found;
}

/// The root of q - G3 dl = sigma(dl). The guess is that of a stress that stays what it was: the change of q over G3.
template <class Curve, class T>
T find_increment(const Curve& curve, const T& q, double G3, const T& change) {
  const T at_rest = curve.at_rest();
  const auto yields = q > at_rest;
  if (!any(yields)) return T(0.0);
  const T most = q * (1.0 / G3), per_q = 1.0 / q, excess = q - at_rest;
  const T guess = select(change > 1e-3 * excess, min(change, excess), excess) * (1.0 / G3);
  std::array<Curve, 1> curves{curve};
  const std::array<Search<T>, 1> search{{{yields, select(yields, guess, most), per_q * at_rest, most}}};
  const auto measure = [&](std::size_t, const LogSeries<T>& stress, const T& dl) {
    return per_q * (stress + LogSeries<T>::proportional(G3 * dl));
  };
  return find_increments<1, T>(curves, search, measure).dl[0];
}

}  // namespace detail

}  // namespace strike
