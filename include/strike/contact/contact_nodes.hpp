#pragma once
#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <strike/error.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/text.hpp>

namespace strike {

/// The nodes that take part in a contact, and the points of rigid surfaces, counted anew: nodes in the order of their
/// numbers in the scene, so that nothing depends on how these lie in memory. Positions x at the time n and velocities v
/// after it, which impulses change; directions that conditions hold do not yield.
class ContactNodes {
 public:
  std::vector<Eigen::Vector3d> x, v;
  /// What the forces of this step have done to the velocities, of nodes in pairs.
  std::vector<Eigen::Vector3d> kicked;
  /// The impulses of this step, along the normals and of friction.
  std::vector<Eigen::Vector3d> pushed, dragged;

  /// Those with these numbers, in ascending order, and points that never move.
  template <class N>
  void begin(const N& nodes, std::vector<Index> numbers, const std::vector<Eigen::Vector3d>& points) {
    if (!numbers.empty() && numbers.back() >= nodes.size())
      throw Error(detail::joined({"strike: a contact names node ", std::to_string(numbers.back()), ", but there are ",
                                  std::to_string(nodes.size()), " nodes; count them from 0."}));
    number_ = std::move(numbers);
    for (const Index i : number_) place_.push_back(nodes.place(i));
    x.resize(number_.size());
    x.insert(x.end(), points.begin(), points.end());
    v.assign(x.size(), Eigen::Vector3d::Zero());
    kicked = pushed = dragged = v;
    is_touched_.assign(x.size(), 0), held_.assign(x.size(), -1), inverse_mass_.assign(x.size(), 0.0);
    for (std::size_t i = 0; i < number_.size(); ++i) inverse_mass_[i] = 1 / nodes.mass(number_[i]);
    gather(nodes);
  }

  /// Takes positions and velocities from the scene.
  template <class N>
  void gather(const N& nodes) {
    for (std::size_t i = 0; i < place_.size(); ++i) {
      x[i] = N::told(nodes.position()[place_[i]]);
      v[i] = N::told(nodes.velocity()[place_[i]]);
    }
    for (const Index i : touched_) is_touched_[i] = 0, pushed[i].setZero(), dragged[i].setZero();
    touched_.clear();
  }

  /// Takes what the pairs need to know of the forces.
  template <class N, class Pairs>
  void gather_forces(const N& nodes, Pairs& pairs, double kick) {
    const auto of = [&](Index i) {
      if (i < number_.size()) kicked[i] = (inverse_mass_[i] * kick) * free(i, N::told(nodes.force()[place_[i]]));
    };
    for (auto& pair : pairs) {
      of(pair.node);
      for (unsigned k = 0; k < pair.count; ++k) of(pair.corners[k]);
      pair.inverse_effective_mass = pair.inverse_effective_mass_along(*this, pair.normal);
    }
  }

  /// Learns which directions of the nodes are held, once all things of the scene have begun.
  template <class N>
  void learn_what_is_held(const N& nodes) {
    if (knows_held_) return;
    knows_held_ = true;
    for (std::size_t i = 0; i < number_.size(); ++i) {
      Eigen::Matrix3d free;
      for (int a = 0; a < 3; ++a) free.col(a) = nodes.free(number_[i], Eigen::Vector3d::Unit(a));
      if (free.isIdentity(0)) continue;
      held_[i] = static_cast<int>(free_.size());
      free_.push_back(free);
    }
  }

  /// Gives the velocities back and books the work of the impulses.
  template <class N, class Ledger>
  void give_back(N& nodes, Ledger& ledger) const {
    double before[2] = {0, 0}, after[2] = {0, 0};
    for (const Index i : touched_) {
      nodes.set_velocity(number_[i], v[i]);
      const Eigen::Vector3d v_before = v[i] - inverse_mass_[i] * (pushed[i] + dragged[i]) - kicked[i];
      before[0] += pushed[i].dot(v_before), after[0] += pushed[i].dot(v[i]);
      before[1] += dragged[i].dot(v_before), after[1] += dragged[i].dot(v[i]);
    }
    ledger.contact.book_impulse(-before[0], -after[0]);
    ledger.friction.book_impulse(-before[1], -after[1]);
  }

  /// The part of a vector along which node i may move.
  Eigen::Vector3d free(Index i, const Eigen::Vector3d& a) const {
    return held_[i] < 0 ? a : Eigen::Vector3d(free_[static_cast<std::size_t>(held_[i])] * a);
  }
  /// What a unit impulse along a unit vector changes of the velocity along it: 1/m of a free node [1/mass].
  double inverse_mass_along(Index i, const Eigen::Vector3d& a) const {
    return held_[i] < 0 ? inverse_mass_[i] : inverse_mass_[i] * free(i, a).dot(a);
  }
  double inverse_mass(Index i) const { return inverse_mass_[i]; }

  void push(Index i, const Eigen::Vector3d& impulse) { give(i, impulse, pushed); }
  void drag(Index i, const Eigen::Vector3d& impulse) { give(i, impulse, dragged); }

  /// Those that an impulse has reached in this step.
  const std::vector<Index>& touched() const { return touched_; }
  std::size_t size() const { return x.size(); }
  /// The number in the scene.
  Index number(Index i) const { return number_[i]; }
  /// From a number in the scene; the number must be there.
  Index local(Index number) const {
    return static_cast<Index>(std::lower_bound(number_.begin(), number_.end(), number) - number_.begin());
  }
  /// Of the first point that never moves.
  Index first_point() const { return static_cast<Index>(number_.size()); }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(pushed, dragged, touched_, is_touched_);
  }

 private:
  void give(Index i, const Eigen::Vector3d& impulse, std::vector<Eigen::Vector3d>& to) {
    if (!(inverse_mass_[i] > 0)) return;
    if (!is_touched_[i]) is_touched_[i] = 1, touched_.push_back(i);
    const Eigen::Vector3d given = free(i, impulse);
    to[i] += given;
    v[i] += inverse_mass_[i] * given;
  }

  std::vector<Index> number_, place_, touched_;
  std::vector<unsigned char> is_touched_;
  std::vector<double> inverse_mass_;
  std::vector<int> held_;  // which of free_, or -1
  std::vector<Eigen::Matrix3d> free_;
  bool knows_held_ = false;
};

/// A node that touches: x_s - sum of N_I x_I = (gap less what was given away at the start) along the normal. Impulses J
/// on the node and -N_I J on the corners along the line through both points keep momentum and its moment.
struct ContactPair {
  Index node = 0;
  std::array<Index, 4> corners{};
  std::array<double, 4> N{};
  unsigned count = 0;                                ///< how many corners; 0: something rigid that has none
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< towards where the node may be
  double gap = 0;                                    ///< negative where it has entered [length]
  double stiffness = 0;                              ///< what a law of springs gives it [force/length]
  double* stored = nullptr;  ///< the energy that the law has taken while the node touches, less what it gave back
  double inverse_effective_mass = 0;  ///< 1/m* along the normal; 0 if all its nodes are held [1/mass]
  double impulse = 0;                 ///< what the law has given in this step [force time]

  /// But for `stored`, which the next step gives it.
  template <class Archive>
  void serialize(Archive& archive) {
    archive(node, corners, N, count, normal, gap, stiffness, inverse_effective_mass, impulse);
  }

  /// Velocity of the node relative to the point that it touches.
  Eigen::Vector3d velocity(const ContactNodes& nodes) const {
    Eigen::Vector3d v = nodes.v[node];
    for (unsigned i = 0; i < count; ++i) v -= N[i] * nodes.v[corners[i]];
    return v;
  }
  /// What the forces of this step have done to it.
  Eigen::Vector3d kicked(const ContactNodes& nodes) const {
    Eigen::Vector3d v = nodes.kicked[node];
    for (unsigned i = 0; i < count; ++i) v -= N[i] * nodes.kicked[corners[i]];
    return v;
  }
  /// 1/m* along a unit vector, 1/m_s + sum of N_I^2/m_I; 0 if it cannot be moved, for all its nodes are held.
  double inverse_effective_mass_along(const ContactNodes& nodes, const Eigen::Vector3d& a) const {
    double w = nodes.inverse_mass_along(node, a), free = nodes.inverse_mass(node);
    for (unsigned i = 0; i < count; ++i) {
      const double share = N[i] * N[i];
      w += share * nodes.inverse_mass_along(corners[i], a), free += share * nodes.inverse_mass(corners[i]);
    }
    return w > 1e-6 * free ? w : 0;
  }
  void push(ContactNodes& nodes, double J) {
    impulse += J;
    nodes.push(node, J * normal);
    for (unsigned i = 0; i < count; ++i) nodes.push(corners[i], (-N[i] * J) * normal);
  }
  void drag(ContactNodes& nodes, const Eigen::Vector3d& J) const {
    nodes.drag(node, J);
    for (unsigned i = 0; i < count; ++i) nodes.drag(corners[i], -N[i] * J);
  }
};

}  // namespace strike
