#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

#include <Eigen/Geometry>

namespace strike::testing {

/// A whole scene that is turned, or mirrored, and moved.
struct Frame {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();

  Eigen::Vector3d operator()(const Eigen::Vector3d& x) const { return turn * x + shift; }
  Eigen::Vector3d back(const Eigen::Vector3d& x) const { return turn.transpose() * (x - shift); }
};

/// Turned about an axis by an angle [rad] and moved.
inline Frame tilted(double angle, const Eigen::Vector3d& axis) {
  return {Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix(), {3, -20, 11}};
}

/// The largest distance of the nodes of a run, brought back from its frame, from other places.
template <class Run>
double off(const Run& run, const std::vector<Eigen::Vector3d>& other, const Frame& frame = {}) {
  double most = 0;
  for (std::size_t i = 0; i < other.size(); ++i)
    most = std::max(most, (frame.back(run.positions()[i]) - other[i]).norm());
  return most;
}

}  // namespace strike::testing
