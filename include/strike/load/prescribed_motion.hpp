#pragma once
#include <utility>
#include <vector>

#include <strike/load/curve.hpp>
#include <strike/mesh/select.hpp>
#include <strike/motion/held_directions.hpp>
#include <strike/motion/nodes.hpp>
#include <strike/motion/step.hpp>

namespace strike {

namespace detail {

/// Nodes whose velocity along a direction is given for each step; the work of the forces that it takes is external.
class PrescribedMotion {
 public:
  PrescribedMotion(const Eigen::Vector3d& direction, std::vector<Index> nodes)
      : direction_(direction.normalized()), nodes_(std::move(nodes)) {}

  template <class N>
  void begin(N& nodes) const {
    for (const Index i : nodes_) nodes.hold(i, direction_, Held::moved);
  }

  template <class Archive>
  void serialize(Archive&) {}

  template <class N, class Ledger>
  void impose(double velocity, N& nodes, const Step& step, Ledger& ledger) const {
    for (const Index i : nodes_) {
      const typename N::Vector v = nodes.v(i);
      const double m = nodes.mass(i);
      const typename N::Number free = v.dot(direction_), before = free - step.kick() / m * nodes.f(i).dot(direction_);
      nodes.set_velocity(i, v + (velocity - free) * direction_);
      const typename N::Number impulse = m * (velocity - free);
      ledger.external.book_impulse(static_cast<double>(impulse * before), static_cast<double>(impulse * velocity));
    }
  }

 private:
  Eigen::Vector3d direction_;
  std::vector<Index> nodes_;
};

}  // namespace detail

/// Nodes that move along a direction with a given history of velocity, v(t).
template <class History>
class PrescribedVelocity : detail::PrescribedMotion {
 public:
  using PrescribedMotion::begin;
  using PrescribedMotion::serialize;

  PrescribedVelocity(const Eigen::Vector3d& direction, std::vector<Index> nodes, History history)
      : PrescribedMotion(direction, std::move(nodes)), history_(std::move(history)) {}
  PrescribedVelocity(Axis axis, std::vector<Index> nodes, History history)
      : PrescribedVelocity(unit(axis), std::move(nodes), std::move(history)) {}

  template <class N, class Ledger>
  void constrain(N& nodes, const Step& step, Ledger& ledger) const {
    this->impose(history_(step.time + 0.5 * step.dt), nodes, step, ledger);
  }

 private:
  History history_;
};

/// Nodes that move along a direction with a given history of displacement, u(t), exactly at every step.
template <class History>
class PrescribedDisplacement : detail::PrescribedMotion {
 public:
  using PrescribedMotion::begin;
  using PrescribedMotion::serialize;

  PrescribedDisplacement(const Eigen::Vector3d& direction, std::vector<Index> nodes, History history)
      : PrescribedMotion(direction, std::move(nodes)), history_(std::move(history)) {}
  PrescribedDisplacement(Axis axis, std::vector<Index> nodes, History history)
      : PrescribedDisplacement(unit(axis), std::move(nodes), std::move(history)) {}

  template <class N, class Ledger>
  void constrain(N& nodes, const Step& step, Ledger& ledger) const {
    this->impose((history_(step.time + step.dt) - history_(step.time)) / step.dt, nodes, step, ledger);
  }

 private:
  History history_;
};

}  // namespace strike
