// A bird of 4 lb, a cylinder of water with next to no strength, strikes a rigid wall at 350 knots.
#include <algorithm>
#include <cmath>

#include <strike/contact/rigid_wall.hpp>
#include <strike/element/tet4.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/load/support.hpp>
#include <strike/material/eos/cubic.hpp>
#include <strike/material/solid.hpp>
#include <strike/material/strength/von_mises.hpp>
#include <strike/mesh/cylinder.hpp>
#include <strike/mesh/select.hpp>
#include <strike/mesh/tetrahedra.hpp>

#include "policies.hpp"

namespace trade {

namespace {

// Millimetres, milliseconds, kilograms; so kN, GPa and J. A quarter of it.
constexpr double radius = 106.73 / 2, length = 213.46, speed = 180.0556, end = 0.3;
constexpr double final_length =
    0.760 * length;  // of ever finer hexahedra: 0.7534, 0.7557, 0.7567, 0.7577 with 4, 6, 8 and 10 cells
constexpr CylinderShape meshes[] = {
    {radius, length, 2, 16}, {radius, length, 3, 24}, {radius, length, 4, 32}, {radius, length, 6, 48}};

constexpr auto splash = [](const auto& element, auto numbers, const Setting& setting) -> Outcome {
  const Solid flesh{CubicEos{.density = 950e-9, .C1 = 2.06, .C2 = 6.19, .C3 = 10.3},
                    VonMises{.shear_modulus = 2.06e-3, .yield_stress = 2e-5}};
  Mesh bird = cylinder(meshes[setting.mesh]);
  constexpr bool tetrahedra = std::decay_t<decltype(element)>::nodes == 4;
  if constexpr (tetrahedra) bird = tetrahedralized(bird);
  const auto& cells = [&]() -> const auto& {
    if constexpr (tetrahedra)
      return bird.tetrahedra;
    else
      return bird.hexahedra;
  }();
  Explicit run{Scene{bird.nodes,                                                         //
                     Part{element, flesh, cells, Erosion{.volume = 0.1, .step = 1e-4}},  //
                     InitialVelocity{{0, 0, -speed}},                                    //
                     Symmetry{Axis::x, nodes_where(bird.nodes, on_plane(Axis::x, 0))},   //
                     Symmetry{Axis::y, nodes_where(bird.nodes, on_plane(Axis::y, 0))},   //
                     RigidWall{{0, 0, 0}, {0, 0, 1}}},
               setting.options, numbers};
  const double seconds = cpu_seconds([&] { run.until(end); });
  double L = 0;
  for (const Eigen::Vector3d& x : run.positions()) L = std::max(L, x.z());
  return {.error = std::abs(L / final_length - 1), .seconds = seconds, .steps = run.steps(), .elements = cells.size()};
};

constexpr auto soft_bodies = [](auto& cases) {
  cases.add("Hex8", Hex8{});
  cases.add("Hex8, viscous hourglass 0.1", Hex8{ViscousHourglass{}});
  cases.add("Hex8, viscous hourglass 0.05", Hex8{ViscousHourglass{.coefficient = 0.05}});
  cases.add("Tet4, own pressure", Tet4{ElementPressure{}});
  cases.add("Tet4, half of it the nodes'", Tet4{NodalPressure{0.5}});
  cases.add("Tet4, 0.9 of it the nodes'", Tet4{});
  cases.add("Tet4, the nodes' pressure", Tet4{NodalPressure{1.0}});
};

}  // namespace

Problem bird() {
  return problem({.name = "bird",
                  .title = "Bird on a rigid wall",
                  .error = "its length after 0.3 ms against that of ever finer hexahedra, 0.760 of the initial one",
                  .uncertainty = 0.002,
                  .meshes = {"2 x 16", "3 x 24", "4 x 32", "6 x 48"},
                  .elements = "elements"},
                 splash, soft_bodies);
}

}  // namespace trade
