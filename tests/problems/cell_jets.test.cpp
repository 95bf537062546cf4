// Birds of hexahedra and tetrahedra, of water without tension, against closed forms: a plane shock and the steady jet.
#include <algorithm>
#include <cmath>

#include <strike/element/hex8.hpp>
#include <strike/element/tet4.hpp>
#include <strike/mesh/box.hpp>

#include "problems/cell_jet.hpp"
#include "problems/plane_shock.hpp"
#include "support/catch.hpp"

using namespace strike;
using namespace strike::cell_jet;

namespace {

const Hex8 hexahedron{ViscousHourglass{}};
const Tet4 tetrahedron{NodalPressure{0.5}};

/// Pressure in the fluid and on the wall, and the speed of the front, of a column one cell across.
template <class E, class Cells>
void check_column(const E& element, const Mesh& mesh, const Cells& cells, double pressure, double speed) {
  const std::vector<Index> all = all_nodes(mesh.nodes);
  for (const double v : {100.0, 180.0, 300.0}) {
    INFO(E::nodes << " nodes, " << v << " m/s");
    Explicit run{Scene{mesh.nodes, Part{element, Fluid{water}, cells, Erosion{.volume = 0.1}},
                       InitialVelocity{{0, 0, -v}}, Symmetry{Axis::x, all}, Symmetry{Axis::y, all},
                       RigidWall{{0, 0, 0}, {0, 0, 1}}}};
    const plane_shock::Found found = plane_shock::found(run, plane_shock::Layers(mesh.nodes, cells, 40), v);
    CHECK(found.pressure == Approx(1).epsilon(pressure));
    CHECK(found.speed == Approx(1).epsilon(speed));
    CHECK(run.template item<4>().impulse().z() / run.time() == Approx(plane_shock::stopping(v).pressure).epsilon(0.01));
    CHECK(std::abs(run.energy().error()) < 6e-3);
  }
}

/// Force, tail and balance of a jet so long that its rear has no say.
template <class E, class Cells>
void check_jet(const E& element, const Mesh& mesh, const Cells& cells, const Jet& jet, double area) {
  auto run = cell_jet::on_wall(jet, mesh, Part{element, Fluid{water}, cells, erosion(jet, 2)});
  Gauge gauge(jet, 0.5, 0.75);
  const auto last = std::max_element(mesh.nodes.begin(), mesh.nodes.end(),
                                     [](const auto& a, const auto& b) { return a.z() < b.z(); });
  const auto tail = static_cast<std::size_t>(last - mesh.nodes.begin());
  double lag = 0, drift = 0;
  run.until(0.76 * jet.length() / jet.speed, [&] {
    gauge.see(run);
    if (run.time() < 0.5 * jet.length() / jet.speed)  // two widths are left
      lag = std::max(lag, std::abs(run.nodes().x(tail).z() - (last->z() - jet.speed * run.time())));
    drift = std::max(drift, std::abs(run.energy().error()));
  });
  CHECK(gauge.force() * jet.area() / (4 * area) == Approx(1).epsilon(0.02));
  CHECK(lag < 1e-3 * jet.length());
  CHECK(drift < 6e-3);
}

}  // namespace

// The wall gives the front a sixth of a layer of 26 too little as it forms. The pressures of the six tetrahedra of a
// cell differ by a seventh, for they share each node's with others: their mean over a layer is that of the shock, to
// what the ringing behind the front leaves in 15 layers. The front is known to a fortieth of a layer in 14.
TEST_CASE("birds of cells: a plane shock has the pressure and the speed of the jump conditions") {
  const Mesh column = box({.size = {1, 1, 40}, .cells = {1, 1, 40}});
  check_column(hexahedron, column, column.hexahedra, 0.002, 0.005);
  const Mesh split = tetrahedralized(column);
  check_column(tetrahedron, split, split.tetrahedra, 0.01, 0.015);
}

// The water that leaves has no momentum along the axis, so that the force is rho A v^2 whatever the pressure in the
// fluid. It is not the pressure about the axis, which cells that stay there raise (docs/verification.md).
TEST_CASE("birds of cells: a jet with a round nose gives rho A v^2, and its tail does not know") {
  const Jet jet{.across = 8, .aspect = 4, .has_round_nose = true};
  const Mesh quarter = hexahedra(jet, 2), split = tetrahedra(jet, 2);
  const double area = section(jet, quarter);
  check_jet(hexahedron, quarter, quarter.hexahedra, jet, area);
  check_jet(tetrahedron, split, split.tetrahedra, jet, area);
}

// A cylinder flows for a short time: the pressure about the axis within 15 %, as coarse birds have it, and m v.
TEST_CASE("birds of cells: hexahedra on a rigid plate, stagnation pressure and impulse m v") {
  const Jet jet{.across = 8};
  const Mesh quarter = hexahedra(jet, 2);
  auto run = cell_jet::on_wall(jet, quarter, Part{hexahedron, Fluid{water}, quarter.hexahedra, erosion(jet, 2)});
  Gauge gauge(jet, 0.2, 0.5);
  run.until(1.6 * jet.length() / jet.speed, [&] { gauge.see(run); });
  CHECK(gauge.centre() == Approx(1).epsilon(0.15));
  CHECK(4 * run.item<4>().impulse().z() == Approx(jet.mass * jet.speed).epsilon(0.02));
}
