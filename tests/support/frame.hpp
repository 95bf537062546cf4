#pragma once
#include <Eigen/Core>

namespace strike::testing {

/// A whole scene that is turned, or mirrored, and moved.
struct Frame {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();

  Eigen::Vector3d operator()(const Eigen::Vector3d& x) const { return turn * x + shift; }
  Eigen::Vector3d back(const Eigen::Vector3d& x) const { return turn.transpose() * (x - shift); }
};

}  // namespace strike::testing
