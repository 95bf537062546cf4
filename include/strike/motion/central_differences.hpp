#pragma once
#include <cstddef>
#include <numeric>
#include <vector>

#include <Eigen/Core>

#include <strike/motion/execution.hpp>
#include <strike/motion/motion.hpp>
#include <strike/motion/rigid_motion.hpp>
#include <strike/scalar/scalar.hpp>

namespace strike::detail {

/// v += kick f/m of the nodes at the places [first, last), and if they turn w += kick moment/inertia. Returns twice
/// their kinetic energy, the sum of m v-.v+, without the impulses of constraints that follow.
template <class N>
double kick(N& nodes, double duration, std::size_t first, std::size_t last) {
  using Real = std::decay_t<decltype(nodes.position()[0])>;
  const auto kick = static_cast<RealOf<Real>>(duration);
  using Sum = Padded<double>;
  Sum kinetic = 0;
  const auto kicked = [&](auto m, const Real& v, const Real& f) {
    const Real after = v + Real(kick / m) * f;
    kinetic += Sum(Real(m) * v * after);
    return after;
  };
  for (std::size_t i = first; i < last; ++i) {
    auto& v = nodes.velocity()[i];
    v = kicked(nodes.mass()[i], v, nodes.force()[i]);
    if constexpr (N::nodes_turn) {
      auto& w = nodes.angular_velocity()[i];
      w = kicked(nodes.inertia()[i], w, nodes.moment()[i]);
    }
  }
  return kinetic[0] + kinetic[1] + kinetic[2];
}
/// The same of all nodes; the kinetic energy. `sums` has a number for each chunk of nodes.
template <class N, class Execution>
double kick(N& nodes, double duration, const Execution& execution, std::vector<double>& sums) {
  for_each_chunk(execution, nodes.size(), [&](std::size_t k, std::size_t first, std::size_t last) {
    sums[k] = kick(nodes, duration, first, last);
  });
  return 0.5 * std::accumulate(sums.begin(), sums.end(), 0.0);
}

/// x += dt v of the nodes at the places [first, last).
template <class N>
void drift(N& nodes, double step, std::size_t first, std::size_t last) {
  using Real = std::decay_t<decltype(nodes.position()[0])>;
  const auto dt = static_cast<RealOf<Real>>(step);
  for (std::size_t i = first; i < last; ++i) nodes.position()[i] += Real(dt) * nodes.velocity()[i];
}
/// The nodes of rigid bodies, which have moved already, go to their places and have the velocities that brought them
/// there.
template <class N>
void place_bodies(N& nodes) {
  using Number = typename N::Number;
  for (const RigidMotion& body : nodes.bodies())
    for (std::size_t k = 0; k < body.nodes().size(); ++k) {
      nodes.set_position(body.nodes()[k], body.place(k).template cast<Number>());
      nodes.set_velocity(body.nodes()[k], body.way_per_time(k).template cast<Number>());
      if constexpr (N::nodes_turn) nodes.set_angular_velocity(body.nodes()[k], body.mean_angular_velocity());
    }
}

/// x += dt v; the nodes of rigid bodies go to their places.
template <class N, class Execution>
void drift(N& nodes, double step, const Execution& execution) {
  for_each_chunk(execution, nodes.size(),
                 [&](std::size_t, std::size_t first, std::size_t last) { drift(nodes, step, first, last); });
  place_bodies(nodes);
}

/// Gives the nodes of a rigid body the velocities of the body where they are.
template <class N>
void move_with(N& nodes, const RigidMotion& body) {
  using Number = typename N::Number;
  for (const Index i : body.nodes()) {
    nodes.set_velocity(i, body.velocity_at(nodes.x(i).template cast<double>()).template cast<Number>());
    if constexpr (N::nodes_turn) nodes.set_angular_velocity(i, body.angular_velocity());
  }
}
template <class N>
void move_with_bodies(N& nodes) {
  for (const RigidMotion& body : nodes.bodies()) move_with(nodes, body);
}

/// The kinetic energy of the velocities between two times, sum of m v.v/2.
template <class N>
double kinetic_energy(const N& nodes) {
  double energy = 0;
  for (const RigidMotion& body : nodes.bodies()) energy += body.kinetic_energy();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (nodes.is_rigid(i)) continue;
    energy += 0.5 * nodes.mass(i) * nodes.v(i).template cast<double>().squaredNorm();
    if constexpr (N::nodes_turn) energy += 0.5 * nodes.inertia(i) * nodes.w(i).template cast<double>().squaredNorm();
  }
  return energy;
}

/// The power of the forces and moments at the present velocities.
template <class N>
double force_power(const N& nodes) {
  double power = 0;
  for (const RigidMotion& body : nodes.bodies()) power += body.power_beside_nodes();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    power += static_cast<double>(nodes.f(i).dot(nodes.v(i)));
    if constexpr (N::nodes_turn) power += static_cast<double>(nodes.moment(i).dot(nodes.w(i)));
  }
  return power;
}

template <class N>
Eigen::Vector3d momentum(const N& nodes) {
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  for (const RigidMotion& body : nodes.bodies()) p += body.momentum();
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (!nodes.is_rigid(i)) p += nodes.mass(i) * nodes.v(i).template cast<double>();
  return p;
}

/// Stops all nodes.
template <class N>
void stop(N& nodes) {
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    nodes.velocity()[i] = 0;
    if constexpr (N::nodes_turn) nodes.angular_velocity()[i] = 0;
  }
  for (RigidMotion& body : nodes.bodies()) body.stop();
}

}  // namespace strike::detail
