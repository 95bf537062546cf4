#pragma once
#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <strike/contact/concepts.hpp>
#include <strike/contact/contact_nodes.hpp>
#include <strike/contact/touch.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/motion/step.hpp>

namespace strike::detail {

/// Nodes that may touch a rigid body given by a formula, and the pairs of each step; they need no search.
template <RigidBody Body>
class RigidApproach {
 public:
  /// `depth` is half the thickness of the nodes' plate, 0 of solids [length].
  RigidApproach(std::vector<Index> nodes, Body body, double depth)
      : nodes_(std::move(nodes)), body_(std::move(body)), depth_(depth), touches_(nodes_.size()) {}

  void begin(const ContactNodes& all, InitialPenetration& inside) {
    for (std::size_t s = 0; s < nodes_.size(); ++s) {
      const Index i = nodes_[s];
      largest_inverse_mass_ = std::max(largest_inverse_mass_, all.inverse_mass(i));
      const double gap = body_.clearance(all.x[i]).gap - depth_;
      if (!(gap < 0)) continue;
      touches_[s].initial_depth = -gap;
      if (-gap > 1e-9 * all.x[i].norm()) inside.add(all.number(i), all.x[i], -gap);
    }
  }

  void find(const ContactNodes& all, const Step& step, std::vector<ContactPair>& pairs) {
    for (std::size_t s = 0; s < nodes_.size(); ++s) {
      const Index i = nodes_[s];
      const auto [distance, normal] = body_.clearance(all.x[i]);
      const double height = distance - depth_;
      Touch& touch = touches_[s];
      touch.initial_depth = std::clamp(-height, 0.0, touch.initial_depth);
      const double gap = height + touch.initial_depth;
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
  /// The node meets the body on its way, along which it may always go as far as it is away (sphere tracing, Hart 1996).
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

}  // namespace strike::detail
