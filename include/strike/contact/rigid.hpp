#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include <strike/contact/approach.hpp>
#include <strike/contact/contact_nodes.hpp>
#include <strike/error.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/mesh/surface.hpp>
#include <strike/motion/step.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike {

/// How far a point is from a rigid body, negative inside, and the unit vector that leads away from it.
struct Clearance {
  double gap;
  Eigen::Vector3d normal;
};

/// A rigid body at rest that nodes may touch.
/// A model has `clearance(x)`: the signed distance to its surface and its gradient.
template <class B>
concept RigidBody = std::copyable<B> && requires(const B body, const Eigen::Vector3d x) {
  { body.clearance(x) } -> std::same_as<Clearance>;
};

/// The half-space behind a plane; `normal`, of any length, points to where nodes may be.
struct RigidPlane {
  Eigen::Vector3d point, normal;
  Clearance clearance(const Eigen::Vector3d& x) const {
    const Eigen::Vector3d n = normal.normalized();
    return {n.dot(x - point), n};
  }
};

/// A ball that is touched from outside.
struct RigidSphere {
  Eigen::Vector3d centre;
  double radius;  ///< [length]
  Clearance clearance(const Eigen::Vector3d& x) const {
    const Eigen::Vector3d r = x - centre;
    return {r.norm() - radius, r.norm() > 0 ? Eigen::Vector3d(r.normalized()) : Eigen::Vector3d::UnitX()};
  }
};

/// An endless cylinder about the line through `point` along `axis`, of any length, touched from outside.
struct RigidCylinder {
  Eigen::Vector3d point, axis;
  double radius;  ///< [length]
  Clearance clearance(const Eigen::Vector3d& x) const {
    const Eigen::Vector3d a = axis.normalized(), r = x - point;
    return RigidSphere{Eigen::Vector3d::Zero(), radius}.clearance(Eigen::Vector3d(r - a.dot(r) * a));
  }
};

/// Faces between points that do not move, touched from the side from which their corners run counter-clockwise.
struct RigidSurface {
  std::vector<Eigen::Vector3d> points;
  std::vector<Face> faces;
};

namespace detail {

/// Nodes on their way to a rigid body of which there is a formula. They need no search.
template <RigidBody Body>
class RigidApproach {
 public:
  RigidApproach(std::vector<Index> nodes, Body body, double depth)
      : nodes_(std::move(nodes)), body_(std::move(body)), depth_(depth) {
    touches_.resize(nodes_.size());
  }

  void begin(const ContactNodes& all, Beginners& beginners) {
    for (std::size_t s = 0; s < nodes_.size(); ++s) {
      largest_inverse_mass_ = std::max(largest_inverse_mass_, all.inverse_mass(nodes_[s]));
      const double gap = body_.clearance(all.x[nodes_[s]]).gap - depth_;
      if (!(gap < 0)) continue;
      touches_[s].given_away = -gap;
      if (-gap > 1e-9 * all.x[nodes_[s]].norm()) beginners.take(all.number(nodes_[s]), -gap);
    }
  }

  void find(const ContactNodes& all, const Step& step, std::vector<ContactPair>& pairs) {
    for (std::size_t s = 0; s < nodes_.size(); ++s) {
      const Index i = nodes_[s];
      const auto [distance, normal] = body_.clearance(all.x[i]);
      const double height = distance - depth_;
      Touch& touch = touches_[s];
      touch.given_away = std::clamp(-height, 0.0, touch.given_away);
      const double gap = height + touch.given_away;
      if (gap > 0 && (gap + step.dt * normal.dot(all.v[i]) >= 0 || !meets(all.x[i], gap, step.dt * all.v[i]))) {
        touch.stored = 0;
        continue;
      }
      pairs.push_back({.node = i, .normal = normal, .gap = gap, .stored = &touch.stored});
    }
  }
  void moved(const ContactNodes&, double) {}
  double largest_inverse_mass() const { return largest_inverse_mass_; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(touches_);
  }

 private:
  /// Whether the node meets the body on its way: it may always go as far as it is away (sphere tracing, Hart 1996).
  bool meets(const Eigen::Vector3d& x, double gap, const Eigen::Vector3d& way) const {
    const double length = way.norm();
    double gone = 0;
    for (int i = 0; i < 50 && gone <= length; ++i) {
      if (gap < 1e-3 * length) return true;
      gone += gap;
      gap = body_.clearance(x + (gone / length) * way).gap - depth_;
    }
    return gone <= length;
  }

  std::vector<Index> nodes_;
  Body body_;
  double depth_;
  std::vector<Touch> touches_;
  double largest_inverse_mass_ = 0;
};

}  // namespace detail

}  // namespace strike
