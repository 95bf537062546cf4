#pragma once
// A steel bar of 20 hexahedra that strikes a rigid wall: the linear wave in one direction, whose exact solution is
// -rho c v behind the front until the release returns from the free end at 2 L/c (d'Alembert).
#include <algorithm>
#include <cmath>
#include <vector>

#include <strike/contact/rigid_wall.hpp>
#include <strike/element/hex8.hpp>
#include <strike/load/initial_velocity.hpp>

#include "problems/column.hpp"

namespace strike::struck_bar {

inline constexpr Index cells = 20;
inline constexpr double L = 1, h = L / cells, E = 200e9, rho = 7850;  // [m, Pa, kg/m3]
inline const double c = std::sqrt(E / rho);

/// The bar with the speed `v` towards the wall at x = 0. With v << c its length does not change.
inline auto bar(double v, const ExplicitOptions& options) {
  const Mesh mesh = column(cells, L, h);
  return Explicit{Scene{mesh.nodes,
                        Part{Hex8{NoHourglass{}, HughesWinget{}, NoBulkViscosity{}},
                             Elastic{.density = rho, .youngs_modulus = E}, mesh.hexahedra},
                        InitialVelocity{{-v, 0, 0}}, RigidWall{{0, 0, 0}, {1, 0, 0}}},
                  options, in<double>};
}

/// Steps of exactly h/c, whatever the element says.
inline ExplicitOptions exact_steps() { return {.step_factor = 2, .largest_step = h / c}; }

/// Axial stress in units of rho c v, element by element from the wall.
template <class Run>
std::vector<double> stress(const Run& run, double v) {
  return run.template part<0>().field([&](const auto& state) { return state.stress.xx / (rho * c * v); });
}

}  // namespace strike::struck_bar
