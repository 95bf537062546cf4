#include <strike/contact/rigid_wall.hpp>
#include <strike/element/tet4.hpp>
#include <strike/mesh/tetrahedra.hpp>

#include "conformance/element.hpp"
#include "problems/taylor_bar.hpp"

using namespace strike;
using testing::conforms;
using testing::FiniteRotations;

namespace {

Nodal<double, 4> corner() {
  Nodal<double, 4> x;
  x << 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1;
  return x;
}

/// The radius of the foot of a Taylor bar of six tetrahedra a hexahedron [mm].
template <class Element>
double taylor_radius(const Element& element, Index cells, Index layers) {
  const auto& data = taylor::mm_ms_kg;
  const Mesh bar =
      tetrahedralized(cylinder({.radius = data.radius, .length = data.length, .cells = cells, .layers = layers}));
  const auto on = [&](Axis axis) { return nodes_where(bar.nodes, on_plane(axis, 0)); };
  Explicit run{Scene{bar.nodes, Part{element, taylor::copper(data), bar.tetrahedra},
                     InitialVelocity{{0, 0, -data.speed}}, Symmetry{Axis::x, on(Axis::x)},
                     Symmetry{Axis::y, on(Axis::y)}, Symmetry{Axis::z, on(Axis::z)}}};
  run.until(data.end);
  CHECK(std::abs(run.energy().error()) < 1e-3);
  return taylor::radius(run);
}

}  // namespace

TEST_CASE("conformance: Tet4 with its own pressure") {
  conforms(Tet4{ElementPressure{}}, FiniteRotations::exact, corner());
}

// Standard tetrahedra lock; the mean over nodes is that of Bonet and Burton (1998). Other codes' hexahedra: 7.03
// to 7.13.
TEST_CASE("a Taylor bar of tetrahedra locks with their own pressure and spreads as others with that of their nodes") {
  CHECK(taylor_radius(Tet4{ElementPressure{}}, 2, 24) < 5.5);
  CHECK(taylor_radius(Tet4{NodalPressure{1.0}}, 3, 36) == Approx(7.1).margin(0.1));
}
