#pragma once
#include <utility>
#include <vector>

#include <strike/mesh/nodes.hpp>
#include <strike/mesh/select.hpp>

namespace strike {

/// Nodes that do not move along a direction: those in a plane of symmetry along its normal, or any that slide. Planes
/// may meet at any angle.
class Symmetry {
 public:
  Symmetry(const Eigen::Vector3d& normal, std::vector<Index> nodes)
      : normals_(nodes.size(), normal.normalized()), nodes_(std::move(nodes)) {}
  Symmetry(Axis axis, std::vector<Index> nodes) : Symmetry(unit(axis), std::move(nodes)) {}

  template <class N>
  void begin(N& nodes) {
    for (std::size_t k = 0; k < nodes_.size(); ++k) normals_[k] = nodes.hold(nodes_[k], normals_[k]);
  }

  template <class N, class Ledger>
  void constrain(N& nodes, const Step& step, Ledger& ledger) const {
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
      const Index i = nodes_[k];
      const Eigen::Vector3d &normal = normals_[k], velocity = nodes.v(i);
      const double v = velocity.dot(normal), m = nodes.mass(i);
      const double before = v - step.kick() / m * nodes.f(i).dot(normal);
      nodes.set_velocity(i, velocity - v * normal);
      ledger.contact.book_impulse(m * v * before, 0);  // not zero only where a node strikes the plane
    }
  }

 private:
  std::vector<Eigen::Vector3d> normals_;  // of each node, less what another plane holds already
  std::vector<Index> nodes_;
};

}  // namespace strike
