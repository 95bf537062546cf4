#pragma once
// A steel ball of R = 10 mm that strikes a rigid plane at 1 m/s: Hertz' force, time and approach (Johnson 1985, 11.24).
#include <algorithm>
#include <cmath>
#include <vector>

#include <strike/contact/contact.hpp>
#include <strike/element/hex8.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/mesh/transform.hpp>

#include "problems/column.hpp"

namespace strike::hertz {

inline constexpr double R = 10, v = 1, E = 200, nu = 0.3, rho = 7.85e-6;  // [mm, ms, kg; so m/s, kN, GPa]
inline constexpr double force = 2.26512, time = 53.408e-3, approach = 18.146e-3;

/// A quarter of the ball, a cube blown up, whose elements are finest at the pole that strikes.
inline Mesh ball(Index cells, double grading) {
  const Mesh cube = box({.lower = {0, 0, -1},
                         .size = {1, 1, 2},
                         .cells = {cells, cells, cells * 4 / 3},
                         .grading = {grading, grading, 1.5 * grading}});
  return transformed(cube, [](const Eigen::Vector3d& x) {
    const double r = x.norm();
    return Eigen::Vector3d(Eigen::Vector3d(0, 0, R) + R * (r > 0 ? x.cwiseAbs().maxCoeff() / r : 0.0) * x);
  });
}

struct Impact {
  double force = 0, time = 0, approach = 0, rebound = 0, lost = 0;  ///< relative to Hertz', to v, to the energy
  std::size_t steps = 0;
};

template <class... Policies>
Impact strike_plane(Index cells, double grading, const Policies&... policies) {
  const Mesh mesh = ball(cells, grading);
  const auto on = [&](Axis axis) { return nodes_where(mesh.nodes, on_plane(axis, 0)); };
  const std::vector<Index> pole = nodes_where(mesh.nodes, [](const Eigen::Vector3d& x) { return x.norm() < 0.2 * R; });
  const Index centre = nearest_node(mesh.nodes, {0, 0, R});
  Explicit run{Scene{mesh.nodes, Part{Hex8{}, Elastic{rho, E, nu}, mesh.hexahedra},
                     Contact{NodeToRigid{pole, RigidPlane{{0, 0, 0}, {0, 0, 1}}}, policies...},
                     Symmetry{Axis::x, on(Axis::x)}, Symmetry{Axis::y, on(Axis::y)}, InitialVelocity{{0, 0, -v}}}};
  Impact impact;
  const double z = run.nodes().x(centre).z();
  double mass = 0, smooth = 0;
  for (std::size_t i = 0; i < run.nodes().size(); ++i) mass += run.nodes().mass(i);
  run.until(1.3 * time, [&] {
    const double f = 4 * run.template item<1>().force().z();
    smooth += std::min(1.0, run.dt() / (0.01 * time)) * (f - smooth);  // over a hundredth of the time
    impact.force = std::max(impact.force, smooth / force);
    if (smooth > 0.005 * force) impact.time = run.time() / time;
    impact.approach = std::max(impact.approach, (z - run.nodes().x(centre).z()) / approach);
  });
  impact.rebound = run.momentum().z() / mass / v;
  impact.lost = run.energy().contact / run.energy().initial;
  impact.steps = run.steps();
  return impact;
}

}  // namespace strike::hertz
