// Taylor's copper cylinder, 3.2 mm x 32.4 mm, strikes a rigid wall at 227 m/s.
#include <algorithm>
#include <cmath>

#include <strike/load/initial_velocity.hpp>
#include <strike/load/support.hpp>
#include <strike/material/eos/linear.hpp>
#include <strike/material/solid.hpp>
#include <strike/material/strength/von_mises.hpp>
#include <strike/mesh/cylinder.hpp>
#include <strike/mesh/select.hpp>

#include "policies.hpp"

namespace trade {

namespace {

// Millimetres, milliseconds, kilograms; so kN, GPa and J.
constexpr double radius = 3.2, length = 32.4, speed = 227, end = 0.08;
constexpr double youngs_modulus = 117, poissons_ratio = 0.35;
constexpr double final_length = 21.42, final_radius = 7.22;  // of ever finer meshes (docs/verification.md)

constexpr CylinderShape meshes[] = {
    {radius, length, 2, 33}, {radius, length, 3, 50}, {radius, length, 4, 67}, {radius, length, 6, 100}};

constexpr auto strike_wall = [](const auto& element, auto numbers, const Setting& setting) -> Outcome {
  const Solid copper{
      LinearEos{.density = 8.93e-6, .bulk_modulus = youngs_modulus / (3 * (1 - 2 * poissons_ratio))},
      VonMises{
          .shear_modulus = youngs_modulus / (2 * (1 + poissons_ratio)), .yield_stress = 0.4, .hardening_modulus = 0.1}};
  Mesh bar = cylinder(meshes[setting.mesh]);
  const double o = setting.distance;
  for (Eigen::Vector3d& x : bar.nodes) x.array() += o;
  Explicit run{Scene{bar.nodes,                                                        //
                     Part{element, copper, bar.hexahedra},                             //
                     InitialVelocity{{0, 0, -speed}},                                  //
                     Symmetry{Axis::x, nodes_where(bar.nodes, on_plane(Axis::x, o))},  //
                     Symmetry{Axis::y, nodes_where(bar.nodes, on_plane(Axis::y, o))},  //
                     Symmetry{Axis::z, nodes_where(bar.nodes, on_plane(Axis::z, o))}},
               setting.options, numbers};
  const double seconds = cpu_seconds([&] { run.until(end); });

  double L = 0, R = 0;
  for (const Eigen::Vector3d& x : run.positions())
    L = std::max(L, x.z() - o), R = std::max(R, std::hypot(x.x() - o, x.y() - o));
  return {.error = std::max(std::abs(L / final_length - 1), std::abs(R / final_radius - 1)),
          .seconds = seconds,
          .steps = run.steps(),
          .elements = bar.hexahedra.size()};
};

}  // namespace

Problem taylor() {
  return problem({.name = "taylor",
                  .title = "Taylor cylinder",
                  .error = "final length against 21.42 mm or foot radius against 7.22 mm, whichever is further off",
                  .uncertainty = 0.002,
                  .meshes = {"2 x 33", "3 x 50", "4 x 67", "6 x 100"}},
                 strike_wall, usual, elements, numbers, distances, step_factors, hourglass_controls, rotations,
                 bulk_viscosities);
}

}  // namespace trade
