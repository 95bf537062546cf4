#pragma once
#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include <strike/mesh/mesh.hpp>
#include <strike/motion/step.hpp>
#include <strike/scalar/scalar.hpp>

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
    if (everywhere_) {
      places_.resize(nodes.size());
      std::iota(places_.begin(), places_.end(), Index{0});
    } else {
      for (const Index i : nodes_) nodes.check_number(i), places_.push_back(nodes.place(i));
    }
  }

  template <class N, class Ledger>
  void resolve_contact(N& nodes, const Step& step, Ledger& ledger) {
    using Number = typename N::Number;
    using Vector = typename N::Vector;
    Eigen::Vector3d impulse = Eigen::Vector3d::Zero();
    for (const Index place : places_) {
      const Vector x = N::told(nodes.position()[place]), v = N::told(nodes.velocity()[place]);
      const Number approach = normal_.dot(v), excess = normal_.dot(point_ - x) - step.dt * approach;
      if (!(excess > 0)) continue;
      const Index i = nodes.number(place);
      const Eigen::Vector3d away = nodes.free(i, normal_);
      const double inverse_effective_mass =
          away.dot(normal_);  // 1 where the node is free to move along the normal, 0 where it is not
      if (!(inverse_effective_mass > 1e-6)) continue;
      const double mass = nodes.mass(i);
      const Number push = mass * (excess / step.dt) / inverse_effective_mass;
      const Vector sliding = nodes.free(i, Vector(v - approach * normal_));
      const Number speed = sliding.norm();
      const Number drag = friction_ > 0 && speed > 0 ? min(friction_ * push / speed, Number(mass)) : Number(0.0);
      const Vector given = push * away - drag * sliding;
      const Vector before = v - (step.kick() / mass) * nodes.f(i);
      const Vector after = v + (1 / mass) * given;
      nodes.set_velocity(i, after);
      ledger.contact.book_impulse(static_cast<double>(-push * away.dot(before)),
                                  static_cast<double>(-push * away.dot(after)));
      ledger.friction.book_impulse(static_cast<double>(drag * sliding.dot(before)),
                                   static_cast<double>(drag * sliding.dot(after)));
      impulse += given.template cast<double>();
    }
    impulse_ += impulse;
    force_ = impulse / step.kick();
  }

  /// The force of the wall on the nodes in the last step.
  const Eigen::Vector3d& force() const { return force_; }
  /// Its impulse since the start.
  const Eigen::Vector3d& impulse() const { return impulse_; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(force_, impulse_);
  }

 private:
  Eigen::Vector3d point_, normal_;
  double friction_;
  bool everywhere_ = false;
  std::vector<Index> nodes_, places_;
  Eigen::Vector3d force_ = Eigen::Vector3d::Zero(), impulse_ = Eigen::Vector3d::Zero();
};

}  // namespace strike
