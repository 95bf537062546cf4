#pragma once
// A cube that is stretched once and then turned about z, its nodes on the exact circle.
#include <numbers>
#include <vector>

#include <Eigen/Geometry>

#include <strike/verify/single_element.hpp>

namespace strike::revolutions {

using namespace strike::verify;

inline constexpr double E = 1;
inline constexpr Elastic unit_solid{.density = 1, .youngs_modulus = E};  // stress = E strain in every direction

/// Stretches the unit cube, then turns it `revolutions` times about z in equal steps. Returns what the stress is in the
/// end, in axes that turn along.
template <class Element>
SymmetricTensor<double> spin(const Element& element, double stretch, int revolutions, int steps_per_revolution) {
  SingleElement cube{element, unit_solid, unit_cube()};
  const Eigen::Matrix3d L = Eigen::Vector3d(stretch, 0, 0).asDiagonal();
  if (stretch > 0) cube.run(motion::homogeneous(L), 1.0, 1);
  const Nodal<double, 8> X = cube.now().x;
  std::vector<Nodal<double, 8>> circle;
  for (int i = 0; i < steps_per_revolution; ++i) {
    const double angle = 2 * std::numbers::pi * i / steps_per_revolution;
    circle.push_back(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix() * X);
  }
  circle.push_back(X);
  for (int r = 0; r < revolutions; ++r)
    for (std::size_t i = 1; i < circle.size(); ++i) cube.step(circle[i] - circle[i - 1], 1.0);
  return cube.now().stress;
}

inline double norm(const SymmetricTensor<double>& a) { return a.matrix().norm(); }

}  // namespace strike::revolutions
