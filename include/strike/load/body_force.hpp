#pragma once
#include <utility>

#include <strike/load/curve.hpp>
#include <strike/mesh/nodes.hpp>

namespace strike {

/// An acceleration of all nodes, as of gravity, times a history.
template <class History = Constant>
class BodyForce {
 public:
  explicit BodyForce(Eigen::Vector3d acceleration, History history = {})
      : acceleration_(std::move(acceleration)), history_(std::move(history)) {}

  template <class N>
  void push(N& nodes, double time) {
    now_ = history_(time) * acceleration_;
    for (std::size_t i = 0; i < nodes.size(); ++i) nodes.add_force(i, nodes.mass(i) * now_);
  }
  template <class N>
  double power(const N& nodes) const {
    Eigen::Vector3d momentum = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < nodes.size(); ++i) momentum += nodes.mass(i) * nodes.v(i);
    return momentum.dot(now_);
  }

 private:
  Eigen::Vector3d acceleration_, now_ = Eigen::Vector3d::Zero();
  History history_;
};

}  // namespace strike
