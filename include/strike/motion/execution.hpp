#pragma once
#include <algorithm>
#include <concepts>
#include <cstddef>

#include <strike/cxx20.hpp>

namespace strike {

/// A way to carry out the loops of a run.
/// Law: `for_each(n, f)` calls f(0), ..., f(n - 1) once each, in any order or in parallel, and returns when all are
/// done. The driver's work does not throw, and its results do not depend on the order. `for_each_unlike(n, f)`,
/// optional, does the same for calls that take unlike times.
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

/// The loop of an execution for calls that take unlike times, if it has one.
template <class E, class F>
void for_each_unlike(const E& execution, std::size_t n, const F& f) {
  if constexpr (requires { execution.for_each_unlike(n, f); })
    execution.for_each_unlike(n, f);
  else
    execution.for_each(n, f);
}

}  // namespace detail

}  // namespace strike
