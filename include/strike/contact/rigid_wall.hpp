#pragma once
#include <algorithm>
#include <utility>
#include <vector>

#include <strike/mesh/mesh.hpp>
#include <strike/mesh/nodes.hpp>

namespace strike {

/// A rigid half-space that nodes may touch and leave but not enter, with or without Coulomb friction. A node that would
/// enter gets the normal velocity that brings it to the surface (an inelastic impact, which takes m v^2/2 of it: for a
/// bar of N elements 1/(2 N) of the energy); a pull is never needed, so it leaves by itself.
class RigidWall {
 public:
  /// The plane through `point`; `normal` points to where the nodes may be. All nodes, or those given, see the wall.
  RigidWall(Eigen::Vector3d point, const Eigen::Vector3d& normal, double friction = 0)
      : point_(std::move(point)), normal_(normal.normalized()), friction_(friction), everywhere_(true) {}
  RigidWall(Eigen::Vector3d point, const Eigen::Vector3d& normal, std::vector<Index> nodes, double friction = 0)
      : point_(std::move(point)), normal_(normal.normalized()), friction_(friction), nodes_(std::move(nodes)) {}

  template <class N>
  void begin(const N& nodes) {
    if (!everywhere_) return;
    nodes_.resize(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) nodes_[i] = static_cast<Index>(i);
  }

  template <class N, class Ledger>
  void touch(N& nodes, const Step& step, Ledger& ledger) {
    using Vector = typename N::Vector;
    using Real = typename Vector::Scalar;
    const Vector normal = normal_.cast<Real>(), point = point_.cast<Real>();
    const Real dt = static_cast<Real>(step.dt), kick = static_cast<Real>(step.kick()),
               mu = static_cast<Real>(friction_);
    Eigen::Vector3d impulse = Eigen::Vector3d::Zero();
    for (const Index i : nodes_) {
      const Real gap = normal.dot(nodes.x(i) - point), approach = normal.dot(nodes.v(i));
      const Real excess = -(gap + dt * approach);
      if (!(excess > 0)) continue;
      const Vector away = nodes.free(i, normal_).template cast<Real>();
      const Real yielding = away.dot(normal);  // 1 where the node is free to move along the normal, 0 where it is not
      if (!(yielding > Real(1e-6))) continue;
      const Vector before = nodes.v(i) - kick / nodes.mass(i) * nodes.f(i);
      const Real push = nodes.mass(i) * (excess / dt) / yielding;
      const Vector sliding =
          nodes.free(i, (nodes.v(i) - approach * normal).template cast<double>()).template cast<Real>();
      const Real speed = sliding.norm();
      Vector drag = Vector::Zero();
      if (mu > 0 && speed > 0) drag = -std::min(mu * push / speed, nodes.mass(i)) * sliding;
      nodes.v(i) += (push * away + drag) / nodes.mass(i);
      ledger.contact.book_impulse(-push * away.dot(before), -push * away.dot(nodes.v(i)));
      ledger.friction.book_impulse(-drag.dot(before), -drag.dot(nodes.v(i)));
      impulse += (push * away + drag).template cast<double>();
    }
    impulse_ += impulse;
    force_ = impulse / step.kick();
  }

  /// The force of the wall on the nodes in the last step.
  const Eigen::Vector3d& force() const { return force_; }
  /// Its impulse since the begin.
  const Eigen::Vector3d& impulse() const { return impulse_; }

 private:
  Eigen::Vector3d point_, normal_;
  double friction_;
  bool everywhere_ = false;
  std::vector<Index> nodes_;
  Eigen::Vector3d force_ = Eigen::Vector3d::Zero(), impulse_ = Eigen::Vector3d::Zero();
};

}  // namespace strike
