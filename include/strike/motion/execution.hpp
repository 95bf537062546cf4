#pragma once
#include <algorithm>
#include <concepts>
#include <cstddef>
#include <numeric>

#include <strike/cxx20.hpp>

namespace strike {

/// A way to carry out the loops of a run.
/// Law: `for_each(n, f)` calls f(0), ..., f(n - 1) once each, in any order or in parallel, and returns when all are
/// done. The driver's work does not throw, and its results do not depend on the order.
template <class E>
concept Execution =
    std::copyable<E> && requires(const E execution, void (*f)(std::size_t)) { execution.for_each(std::size_t{}, f); };

/// Serial execution, the default.
struct Serial {
  template <class F>
  void for_each(std::size_t n, const F& f) const {
    for (std::size_t k = 0; k < n; ++k) f(k);
  }
};

namespace detail {

/// Nodes per chunk: amortises scheduling and fits the cache.
inline constexpr std::size_t chunk = 1024;

inline std::size_t chunks(std::size_t n) { return (n + chunk - 1) / chunk; }

/// f(k, first, last) for the chunks [first, last) of [0, n).
template <class E, class F>
void for_each_chunk(const E& execution, std::size_t n, const F& f) {
  execution.for_each(chunks(n), [&](std::size_t k) { f(k, k * chunk, std::min((k + 1) * chunk, n)); });
}

/// Calls f(0), ..., f(n - 1) in an order that leaps: costly ones that follow each other go to several threads.
template <class E, class F>
void for_each_leaping(const E& execution, std::size_t n, const F& f) {
  std::size_t leap = n * 5 / 8;
  while (std::gcd(leap, n) > 1) ++leap;
  execution.for_each(n, [&](std::size_t k) { f(k * leap % n); });
}

}  // namespace detail

}  // namespace strike
