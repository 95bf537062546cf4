#pragma once
#include <array>
#include <cmath>

#include <Eigen/Core>

#include <strike/mesh/sheet.hpp>

// The scene of plates whose step is measured.
namespace bench {

inline constexpr double sheet_thickness = 3e-4;  ///< [m]

/// Squares of a millimetre.
inline strike::Mesh sheet(const std::array<strike::Index, 2>& cells) {
  const double h = 1e-3;
  return strike::rectangle({.size = {h * cells[0], h * cells[1]}, .cells = cells});
}

/// Begins as a sheet that is stretched and bent into waves of 20 mm, z = A cos(k x), by half as much at its faces, so
/// that every point yields.
struct Stretch {
  double rate = 3e3;  ///< [1/s]

  template <class N>
  void begin(N& nodes) const {
    const double k = 2 * 3.14159265358979 / 20e-3, A = rate / (k * k * sheet_thickness);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const Eigen::Vector3d x = nodes.x(i);
      nodes.set_velocity(i, {rate * x.x(), -0.3 * rate * x.y(), A * std::cos(k * x.x())});
      nodes.set_angular_velocity(i, {0, k * A * std::sin(k * x.x()), 0});
    }
  }
};

}  // namespace bench
