#pragma once
// A quarter of a bird of 4 lb of water without strength, of tetrahedra, on a rigid plate at 180 m/s. mm, ms, kg.
#include <strike/contact/rigid_wall.hpp>
#include <strike/dynamics/explicit.hpp>
#include <strike/element/tet4.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/load/support.hpp>
#include <strike/material/eos/cubic.hpp>
#include <strike/material/fluid.hpp>
#include <strike/mesh/bird.hpp>
#include <strike/mesh/select.hpp>
#include <strike/mesh/tetrahedra.hpp>

namespace strike::water_bird {

template <class E, class Removal = NoErosion>
auto on_plate(const E& element, Index cells, const Removal& removal = {}) {
  const Mesh mesh =
      tetrahedralized(bird({.mass = 1.81436948, .density = 0.95e-6, .cells = cells, .layers = 8 * cells}));
  const auto on = [&](Axis axis) { return nodes_where(mesh.nodes, on_plane(axis, 0)); };
  return Explicit{Scene{
      mesh.nodes,
      Part{element, Fluid{CubicEos{.density = 0.95e-6, .C1 = 2.06, .C2 = 6.19, .C3 = 10.3}}, mesh.tetrahedra, removal},
      InitialVelocity{{0, 0, -180.0556}}, Symmetry{Axis::x, on(Axis::x)}, Symmetry{Axis::y, on(Axis::y)},
      RigidWall{{0, 0, 0}, {0, 0, 1}}}};
}

}  // namespace strike::water_bird
