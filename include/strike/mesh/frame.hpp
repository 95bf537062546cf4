#pragma once
#include <cmath>
#include <vector>

#include <strike/mesh/mesh.hpp>

namespace strike {

/// Four nodes that do not lie in a plane, by which something is known that moves with a rigid body.
struct Frame {
  std::vector<Index> nodes;
};

/// Appends a frame to the nodes of a scene, the corners of a regular tetrahedron at this distance from its centre
/// [length]: the nodes of a RigidBody that has no cells.
inline Frame add_frame(std::vector<Eigen::Vector3d>& nodes, const Eigen::Vector3d& centre, double distance) {
  Frame frame;
  const double d = distance / std::sqrt(3.0);
  for (const Eigen::Vector3d& way : {Eigen::Vector3d(d, d, d), {d, -d, -d}, {-d, d, -d}, {-d, -d, d}}) {
    frame.nodes.push_back(static_cast<Index>(nodes.size()));
    nodes.push_back(centre + way);
  }
  return frame;
}

}  // namespace strike
