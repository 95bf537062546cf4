#pragma once
#include <cstdio>
#include <string>

#include <Eigen/Core>

namespace strike::detail {

/// A number as a message shows it: six significant digits.
inline std::string text(double number) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%g", number);
  return buffer;
}

/// A place as a message shows it: (x, y, z).
inline std::string text(const Eigen::Vector3d& x) {
  return "(" + text(x[0]) + ", " + text(x[1]) + ", " + text(x[2]) + ")";
}

}  // namespace strike::detail
