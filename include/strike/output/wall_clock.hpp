#pragma once
#include <ctime>

#include <strike/cxx20.hpp>

namespace strike::detail {

/// Time on a clock that never goes back [s]. (<chrono> takes ten times as long to compile.)
inline double wall_clock() {
  std::timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace strike::detail
