#pragma once
#include <array>

#include <Eigen/Core>

#include <strike/mesh/mesh.hpp>

namespace strike {

/// Two points that start inside each other: sum of w_I x_I = -depth n over the nodes I, by their numbers in the scene.
/// The weights w of one side have the sum 1, those of the other -1, or there are none of a rigid body.
struct Overlap {
  std::array<Index, 5> nodes{};
  std::array<double, 5> weights{};
  unsigned count = 0;                                ///< of nodes
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< unit vector, the way out for the first side
  double depth = 0;                                  ///< [length]
};

}  // namespace strike
