#pragma once
#include <algorithm>
#include <cstddef>

#include <strike/range.hpp>

#ifdef _OPENMP
#include <omp.h>
#endif

namespace strike {

/// The threads of OpenMP: `Explicit run{scene, {}, OpenMP{.threads = 4}}`. Results are the same, bit for bit, for any
/// number of them. Programs that use it link the target strike::openmp.
struct OpenMP {
  int threads = 0;  ///< 0: as many as OpenMP gives, one per core or OMP_NUM_THREADS

  void ranges(const auto& number) const { number("threads", threads, range::not_negative); }

#ifdef _OPENMP
  static constexpr bool is_available = true;
#else
  static constexpr bool is_available = false;
#endif

  template <class F>
  void for_each(std::size_t n, const F& f) const {
#ifdef _OPENMP
#pragma omp parallel for schedule(static) num_threads(team(n)) if (n > 1)
#endif
    for (std::size_t k = 0; k < n; ++k) f(k);
  }
  /// The same for calls that take unlike times: a thread takes the next when it has done one.
  template <class F>
  void for_each_unlike(std::size_t n, const F& f) const {
#ifdef _OPENMP
#pragma omp parallel for schedule(dynamic) num_threads(team(n)) if (n > 1)
#endif
    for (std::size_t k = 0; k < n; ++k) f(k);
  }

#ifdef _OPENMP

 private:
  int team(std::size_t n) const {
    return static_cast<int>(std::min(static_cast<std::size_t>(threads > 0 ? threads : omp_get_max_threads()), n));
  }
#endif
};

}  // namespace strike
