#pragma once
#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include <strike/motion/nodes.hpp>

namespace strike::testing {

/// Velocities of all nodes at the start, an item of a scene.
struct Velocities {
  std::vector<Eigen::Vector3d> v;

  template <class Archive>
  void serialize(Archive&) {}
  template <class N>
  void begin(N& nodes) const {
    for (std::size_t i = 0; i < nodes.size(); ++i) nodes.set_velocity(i, v[i]);
  }
};

}  // namespace strike::testing
