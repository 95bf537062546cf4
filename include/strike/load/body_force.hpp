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
    using Vector = typename N::Vector;
    now_ = history_(time) * acceleration_;
    const Vector a = now_.cast<typename Vector::Scalar>();
    for (std::size_t i = 0; i < nodes.size(); ++i) nodes.f(i) += nodes.mass(i) * a;
  }
  template <class N>
  double power(const N& nodes) const {
    Eigen::Vector3d momentum = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < nodes.size(); ++i) momentum += (nodes.mass(i) * nodes.v(i)).template cast<double>();
    return momentum.dot(now_);
  }

 private:
  Eigen::Vector3d acceleration_, now_ = Eigen::Vector3d::Zero();
  History history_;
};

}  // namespace strike
