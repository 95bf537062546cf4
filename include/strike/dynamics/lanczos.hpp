#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include <strike/mesh/mesh.hpp>
#include <strike/motion/execution.hpp>
#include <strike/scalar/bisect.hpp>
#include <strike/scalar/scalar.hpp>

namespace strike::detail {

/// The largest eigenvalue of the symmetric tridiagonal matrix of these diagonals, from above to rounding: no pivot of T
/// - x I is positive for x above it (Sturm).
inline double largest_eigenvalue(const std::vector<double>& diagonal, const std::vector<double>& beside) {
  const std::size_t n = diagonal.size();
  double lower = 0, upper = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double row = (i > 0 ? std::abs(beside[i - 1]) : 0) + (i + 1 < n ? std::abs(beside[i]) : 0);
    lower = std::max(lower, diagonal[i]), upper = std::max(upper, diagonal[i] + row);
  }
  const auto is_above = [&](double x) {
    double pivot = -1;
    for (std::size_t i = 0; i < n && pivot < 0; ++i)
      pivot = diagonal[i] - x - (i > 0 ? beside[i - 1] * beside[i - 1] / pivot : 0);
    return pivot < 0;
  };
  const auto is_wide = [](const auto& bracket) { return bracket.upper - bracket.lower > 1e-12 * bracket.upper; };
  return bisect(
             Bracket<double>{lower, upper}, [&](double x) { return !is_above(x); }, is_wide)
      .upper;
}

/// Number k of a sequence of independent numbers in (0, 1) (Steele, Lea and Flood 2014: splitmix64).
inline double random_number(std::uint64_t k) {
  std::uint64_t z = (k + 1) * 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return (static_cast<double>((z ^ (z >> 31)) >> 11) + 0.5) * 0x1p-53;
}
/// The same, normally distributed (Box and Muller 1958).
inline double random_normal(std::uint64_t k) {
  return std::sqrt(-2 * std::log(random_number(2 * k))) * std::cos(2 * std::numbers::pi * random_number(2 * k + 1));
}

/// The number that the largest eigenvalue of a positive matrix of n rows exceeds with a probability of at most
/// `failure`, from Lanczos's iteration that began in a random direction. `diagonal` and `beside` are those of its
/// tridiagonal matrix, `beside` with the norm of the next vector as its last. The polynomials p of the iteration have
/// sum_i g_i^2 p(mu_i)^2 = 1, g_i being the components of the direction, so that p(mu) <= 1/|g| for the largest mu (van
/// Dorsselaer, Hochstenbach and van der Vorst 2000); and |g| < d has a probability of at most d sqrt(2 n/pi).
inline double eigenvalue_bound(const std::vector<double>& diagonal, const std::vector<double>& beside, std::size_t n,
                               double failure) {
  const double theta = largest_eigenvalue(diagonal, {beside.begin(), beside.end() - 1});
  const double limit = std::log(std::sqrt(2 * static_cast<double>(n) / std::numbers::pi) / failure);
  const auto log_p = [&](double x) {
    double ratio = 1, sum = 0;  // p_k/p_(k-1)
    for (std::size_t k = 0; k < diagonal.size(); ++k) {
      ratio = (x - diagonal[k] - (k > 0 ? beside[k - 1] / ratio : 0)) / beside[k];
      if (!(ratio > 0)) return -limit;
      sum += std::log(ratio);
    }
    return sum;
  };
  if (!(beside.back() > 1e-14 * theta)) return theta;  // the iteration has found all that it can
  double upper = 2 * theta;
  while (log_p(upper) < limit) upper *= 2;
  const auto is_wide = [](const auto& bracket) { return bracket.upper - bracket.lower > 1e-4 * bracket.upper; };
  return bisect(
             Bracket<double>{theta, upper}, [&](double x) { return log_p(x) < limit; }, is_wide)
      .upper;
}

/// Lanczos's iteration (1950) for the largest eigenvalue of A q = mu m q. `Vector` is a vector at a node, padded, of
/// which three components count; of `kinds` there are one, displacements, or two, rotations after them.
template <class Vector, std::size_t kinds>
class Lanczos {
  using Real = RealOf<Vector>;

 public:
  using Fields = std::array<std::vector<Vector>, kinds>;
  /// Nodes that take part, place by place: the mass of each, of rotations the moment of inertia, zero elsewhere.
  using Masses = std::array<std::vector<Real>, kinds>;

  /// Iterates from random direction number `seed` until `is_enough(diagonal, beside)`, asked after each step, or there
  /// are no more directions; see eigenvalue_bound. The fields have `places` numbers each; subtract_product(q, f) is
  /// f -= A q, where f is zero before. With the vectors q over the masses:
  ///   b q_next = A q/m - a q - b_before q_before,  a = q.A q,  |q| = 1.
  template <class Execution, class Operator, class IsEnough>
  void iterate(std::uint64_t seed, std::size_t places, const Masses& masses, const Execution& execution,
               const Operator& subtract_product, const IsEnough& is_enough) {
    std::size_t size = 0;
    for (std::size_t kind = 0; kind < kinds; ++kind) {
      for (Fields* fields : {&q_, &q_before_, &product_}) (*fields)[kind].assign(places, Vector(0));
      active_[kind].clear();
      for (std::size_t i = 0; i < masses[kind].size(); ++i)
        if (masses[kind][i] > 0) active_[kind].push_back(static_cast<Index>(i));
      size += 3 * active_[kind].size();
      for (const Index i : active_[kind])
        for (std::size_t c = 0; c < 3; ++c)
          q_[kind][i].set(c, static_cast<Real>(random_normal((seed << 40) + 3 * (places * kind + i) + c) /
                                               std::sqrt(static_cast<double>(masses[kind][i]))));
    }

    std::vector<double> diagonal, beside;
    double norm = std::sqrt(
        sum(execution, [&](std::size_t kind, Index i) { return masses[kind][i] * dot(q_[kind][i], q_[kind][i]); }));
    for (std::size_t k = 0; k < size && norm > 0; ++k) {
      const Vector b = k > 0 ? static_cast<Real>(norm) : 0, per_norm = static_cast<Real>(1 / norm);
      sum(execution, [&](std::size_t kind, Index i) {
        q_[kind][i] *= per_norm;
        product_[kind][i] = 0;
        return Real(0);
      });
      subtract_product(q_, product_);
      diagonal.push_back(
          -sum(execution, [&](std::size_t kind, Index i) { return dot(q_[kind][i], product_[kind][i]); }));
      const Vector a = static_cast<Real>(diagonal.back());
      norm = std::sqrt(sum(execution, [&](std::size_t kind, Index i) {
        const Real m = masses[kind][i];
        Vector& before = q_before_[kind][i];
        before = -(a * q_[kind][i] + b * before + Vector(1 / m) * product_[kind][i]);
        return m * dot(before, before);
      }));
      std::swap(q_, q_before_);
      beside.push_back(norm);
      if (is_enough(diagonal, beside)) return;
    }
  }

 private:
  static Real dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

  /// The sum of f(kind, i) over the active places, in an order that does not depend on the threads.
  template <class Execution, class F>
  double sum(const Execution& execution, const F& f) {
    double all = 0;
    for (std::size_t kind = 0; kind < kinds; ++kind) {
      const std::vector<Index>& active = active_[kind];
      sums_.resize(chunks(active.size()));
      for_each_chunk(execution, active.size(), [&](std::size_t k, std::size_t first, std::size_t last) {
        double mine = 0;
        for (std::size_t j = first; j < last; ++j) mine += static_cast<double>(f(kind, active[j]));
        sums_[k] = mine;
      });
      all = std::accumulate(sums_.begin(), sums_.end(), all);
    }
    return all;
  }

  Fields q_, q_before_, product_;
  std::array<std::vector<Index>, kinds> active_;
  std::vector<double> sums_;
};

}  // namespace strike::detail
