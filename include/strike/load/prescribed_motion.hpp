#pragma once
#include <utility>
#include <vector>

#include <strike/load/curve.hpp>
#include <strike/mesh/select.hpp>
#include <strike/motion/held_directions.hpp>
#include <strike/motion/nodes.hpp>
#include <strike/motion/step.hpp>
#include <strike/range.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike {

namespace detail {

/// The velocity of a step from a history of velocity, v(t + dt/2).
struct FromVelocity {
  template <class History>
  static double velocity(History& v, const Step& step) {
    return v(step.time + 0.5 * step.dt);
  }
};
/// The velocity of a step from a history of displacement, (u(t + dt) - u(t))/dt.
struct FromDisplacement {
  template <class History>
  static double velocity(History& u, const Step& step) {
    return (u(step.time + step.dt) - u(step.time)) / step.dt;
  }
};

/// Nodes that move along a direction with the velocity that a history prescribes for each step; the work of the forces
/// that this takes is external. Errors: no such node; a direction that another condition holds.
template <class History, class Kind>
class PrescribedMotion {
 public:
  using LoadHistory = History;

  PrescribedMotion(const Eigen::Vector3d& direction, std::vector<Index> nodes, History history)
      : given_(direction),
        direction_(detail::direction(direction)),
        nodes_(std::move(nodes)),
        history_(std::move(history)) {}
  PrescribedMotion(Axis axis, std::vector<Index> nodes, History history)
      : PrescribedMotion(unit(axis), std::move(nodes), std::move(history)) {}

  void ranges(const auto& number) const {
    number("direction", given_, range::direction);
    number(history_);
  }

  template <class N>
  void begin(N& nodes) const {
    for (const Index i : nodes_) nodes.hold(i, direction_, Held::moved);
  }

  const std::vector<Index>& nodes_named() const { return nodes_; }

  template <class N, class Ledger>
  void constrain(N& nodes, const Step& step, Ledger& ledger) {
    const double velocity = Kind::velocity(history_, step);
    for (const Index i : nodes_) {
      const typename N::Vector v = nodes.v(i);
      const double m = nodes.mass(i);
      const typename N::Number free = v.dot(direction_), before = free - step.kick() / m * nodes.f(i).dot(direction_);
      nodes.set_velocity(i, v + (velocity - free) * direction_);
      const typename N::Number impulse = m * (velocity - free);
      ledger.external.book_impulse(static_cast<double>(impulse * before), static_cast<double>(impulse * velocity));
    }
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive.same(nodes_);
  }

 private:
  Eigen::Vector3d given_, direction_;  // of any length, and the unit vector
  std::vector<Index> nodes_;
  History history_;
};

}  // namespace detail

/// Nodes that move along a direction with a history of velocity, v(t).
///   PrescribedVelocity{Axis::x, nodes, Curve{{{0, 0}, {1e-3, 5}}}}
template <class History>
class PrescribedVelocity : public detail::PrescribedMotion<History, detail::FromVelocity> {
  using detail::PrescribedMotion<History, detail::FromVelocity>::PrescribedMotion;
};
template <class History>
PrescribedVelocity(Eigen::Vector3d, std::vector<Index>, History) -> PrescribedVelocity<History>;
template <class History>
PrescribedVelocity(Axis, std::vector<Index>, History) -> PrescribedVelocity<History>;

/// Nodes that move along a direction with a history of displacement, u(t), which they have exactly at every step.
template <class History>
class PrescribedDisplacement : public detail::PrescribedMotion<History, detail::FromDisplacement> {
  using detail::PrescribedMotion<History, detail::FromDisplacement>::PrescribedMotion;
};
template <class History>
PrescribedDisplacement(Eigen::Vector3d, std::vector<Index>, History) -> PrescribedDisplacement<History>;
template <class History>
PrescribedDisplacement(Axis, std::vector<Index>, History) -> PrescribedDisplacement<History>;

}  // namespace strike
