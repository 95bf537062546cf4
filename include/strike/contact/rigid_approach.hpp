#pragma once
#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <strike/contact/carried.hpp>
#include <strike/contact/concepts.hpp>
#include <strike/contact/contact_nodes.hpp>
#include <strike/contact/spacing.hpp>
#include <strike/contact/touch.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/motion/step.hpp>

namespace strike::detail {

/// Nodes that may touch a rigid body given by a formula, and the pairs of each step; they need no search.
template <RigidObstacle Body>
class RigidApproach {
 public:
  /// `depth` is half the thickness of the nodes' plate, 0 of solids [length].
  RigidApproach(std::vector<Index> nodes, Body body, double depth)
      : nodes_(std::move(nodes)), body_(std::move(body)), depth_(depth) {}

  void begin(const ContactNodes& all, InitialPenetration& inside) {
    body_.begin(all);
    std::erase_if(nodes_, [&](Index i) { return body_.is_of(all, i); });
    touches_.resize(nodes_.size());
    std::vector<Eigen::Vector3d> x;
    for (const Index i : nodes_) x.push_back(all.x[i]);
    cells_ = spacing(x);
    for (std::size_t s = 0; s < nodes_.size(); ++s) {
      const Index i = nodes_[s];
      largest_inverse_mass_ =
          std::max(largest_inverse_mass_, all.largest_inverse_mass(i) + body_.inverse_mass(all, all.x[i]));
      const auto [distance, normal] = body_.clearance(all, all.x[i]);
      const double gap = distance - depth_;
      if (!(gap < 0)) continue;
      touches_[s].initial_depth = -gap;
      if (!(-gap > depth_of_rounding(all.x[i], 0))) continue;
      ContactPair pair(normal, gap);
      pair.add(i, 1);
      inside.add(all, pair, 1e-9 * all.x[i].norm());
    }
  }

  void find(const ContactNodes& all, const Step& step, std::vector<ContactPair>& pairs) {
    for (std::size_t s = 0; s < nodes_.size(); ++s) {
      const Index i = nodes_[s];
      const auto [distance, normal] = body_.clearance(all, all.x[i]);
      const double height = distance - depth_;
      RigidTouch& touch = touches_[s];
      touch.initial_depth = std::clamp(-height, 0.0, touch.initial_depth);
      const double gap = height + touch.initial_depth;
      check_depth(all.number(i), all.x[i], -gap, cells_[s]);
      const Eigen::Vector3d v = all.v[i] - body_.velocity(all, all.x[i]);
      if (gap > 0 && (gap + step.dt * normal.dot(v) >= 0 || !meets(all, all.x[i], gap, step.dt * v))) {
        touch.stored = 0, touch.friction.setZero();
        continue;
      }
      pairs.emplace_back(normal, gap);
      pairs.back().add(i, 1), body_.add_to(pairs.back(), all, all.x[i]), remember(pairs.back(), touch);
    }
  }
  double closing_step(const ContactNodes& all, double moved, double dt) const {
    double step = dt;
    for (std::size_t s = 0; s < nodes_.size(); ++s) {
      const Eigen::Vector3d x = all.x[nodes_[s]] + moved * all.v[nodes_[s]];  // the obstacle has moved already
      const Eigen::Vector3d v = all.v[nodes_[s]] - body_.velocity(all, x);
      if (!(dt * v.norm() > closing_share * cells_[s])) continue;
      const auto [distance, normal] = body_.clearance(all, x);
      const double gap = distance - depth_, closing = -normal.dot(v);
      if (closing > 0 && closing * dt > gap &&
          (gap < 0 || meets(all, x, gap, dt * v)))  // inside, springs let it deeper
        step = std::min(step, detail::closing_step(gap, closing, cells_[s]));
    }
    return step;
  }
  double largest_inverse_mass() const { return largest_inverse_mass_; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(touches_);
  }

 private:
  /// True if the node meets the body on its way, followed by steps of the distance (sphere tracing, Hart 1996).
  bool meets(const ContactNodes& all, const Eigen::Vector3d& x, double gap, const Eigen::Vector3d& way) const {
    const double length = way.norm();
    double gone = 0;
    for (int i = 0; i < 50 && gone <= length; ++i) {
      if (gap < 1e-3 * length) return true;
      gone += gap;
      gap = body_.clearance(all, x + (gone / length) * way).gap - depth_;
    }
    return gone <= length;
  }

  /// The touch of a node, kept from step to step: its initial penetration [length], and the energy that the law has
  /// taken and not given back.
  struct RigidTouch {
    double initial_depth = 0, stored = 0;
    Eigen::Vector3d friction = Eigen::Vector3d::Zero();

    template <class Archive>
    void serialize(Archive& archive) {
      archive(initial_depth, stored, friction);
    }
  };

  std::vector<Index> nodes_;
  ObstacleInMotion<Body> body_;
  double depth_;
  std::vector<RigidTouch> touches_;
  std::vector<double> cells_;  // their size at each node [length]
  double largest_inverse_mass_ = 0;
};

}  // namespace strike::detail
