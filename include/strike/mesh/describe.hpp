#pragma once
#include <string>

#include <Eigen/Core>

#include <strike/text.hpp>

namespace strike::detail {

/// A position as a message shows it: (x, y, z).
inline std::string text(const Eigen::Vector3d& x) {
  return joined({"(", text(x[0]), ", ", text(x[1]), ", ", text(x[2]), ")"});
}

}  // namespace strike::detail
