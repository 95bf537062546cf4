#pragma once
#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <strike/scalar/pack.hpp>

#include "clock.hpp"

// What one core of this machine can do at best.
namespace bench {

/// What is written here has to be computed.
inline volatile double sink;
/// What is read here the compiler does not know.
inline volatile double source = 1;

/// The quickest of some repetitions [s of CPU]: others on the machine only ever add to the time.
template <class Action>
double quickest(Action action) {
  double best = cpu_seconds(action);
  for (int repeat = 0; repeat < 9; ++repeat) best = std::min(best, cpu_seconds(action));
  return best;
}

/// How often one core does `next` to a number [1/s]. Several independent chains hide its latency.
template <class T, class Next>
double rate(Next next) {
  using Numbers = strike::Pack<T>;
  constexpr int chains = 10, length = 1 << 23;
  const double seconds = quickest([&] {
    [&]<int... k>(std::integer_sequence<int, k...>) {
      Numbers a[chains] = {Numbers(source + k)...};
      for (int i = 0; i < length; ++i) ((a[k] = next(a[k])), ...);
      sink = static_cast<double>((a[k] + ...)[0]);
    }(std::make_integer_sequence<int, chains>{});
  });
  return double(chains) * double(length) * double(Numbers::size()) / seconds;
}

/// Products and sums, fused [flop/s].
template <class T>
double peak() {
  const strike::Pack<T> b = 0.5 * source, c = double(source);
  return 2 * rate<T>([b, c](strike::Pack<T> a) {
           a.native(0) = a.native(0) * b.native(0) + c.native(0);  // in one formula, or clang does not fuse them
           return a;
         });
}
/// [1/s]
template <class T>
double quotients() {
  const strike::Pack<T> b = double(source);
  return rate<T>([b](const auto& a) { return b / a; });
}
/// [1/s]
template <class T>
double roots() {
  return rate<T>([](const auto& a) { return sqrt(a); });
}

/// a = b + s c over three arrays of so many bytes together: McCalpin's triad (1995), which counts what is read and
/// written [B/s].
inline double triad(double bytes) {
  using Numbers = strike::Pack<double>;
  const auto n = static_cast<std::size_t>(bytes / (3 * sizeof(Numbers)));
  std::vector<Numbers> a(n, 0.0), b(n, source), c(n, source);
  const auto passes = static_cast<std::size_t>(std::max(1.0, 2e8 / bytes));
  const double seconds = quickest([&] {
    for (std::size_t pass = 0; pass < passes; ++pass) {
      const Numbers s = static_cast<double>(pass) + source;
      for (std::size_t i = 0; i < n; ++i) a[i] = b[i] + s * c[i];
    }
    sink = a[n / 2][0];
  });
  return static_cast<double>(passes) * static_cast<double>(3 * n * sizeof(Numbers)) / seconds;
}

}  // namespace bench
