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

using Points = std::vector<Eigen::Vector3d>;

/// The places of the nodes of a run, brought back from its frame.
template <class Run>
Points positions(const Run& run, const Frame& frame = {}) {
  Points x;
  for (const auto& point : run.positions()) x.push_back(frame.back(point));
  return x;
}
/// The largest distance between points of the same number; there may be more in b than in a.
inline double difference(const Points& a, const Points& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, (a[i] - b[i]).norm());
  return largest;
}
/// The largest distance of the nodes of a run, brought back from its frame, from other places.
template <class Run>
double off(const Run& run, const Points& other, const Frame& frame = {}) {
  return difference(other, positions(run, frame));
}

}  // namespace strike::testing
