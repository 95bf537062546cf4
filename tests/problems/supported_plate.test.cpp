#include <vector>

#include <strike/dynamics/explicit.hpp>
#include <strike/element/plate4.hpp>
#include <strike/load/curve.hpp>
#include <strike/load/pressure.hpp>
#include <strike/load/support.hpp>
#include <strike/material/elastic.hpp>
#include <strike/material/layered.hpp>
#include <strike/material/plane_stress.hpp>
#include <strike/mesh/select.hpp>
#include <strike/mesh/sheet.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {

struct Swing {
  double largest = 0, time = 0;
};

/// A quarter of the simply supported square plate of Belytschko, Lin and Tsay (1984) under a step of pressure [in, lbf,
/// s]: how far its middle goes. A hard support lets no node turn across its edge.
enum class Edges { hard, soft };
template <class Element = Plate4<>>
Swing swing(Index n, double pressure, Edges edges = Edges::hard, const Element& element = {}) {
  constexpr double half = 5;
  const Mesh plate = rectangle({.size = {half, half}, .cells = {n, n}});
  const auto on = [&](Axis axis, double at) { return nodes_where(plate.nodes, on_plane(axis, at)); };
  const Homogeneous section{
      PlaneStress{Elastic{.reference_density = 2.588e-4, .youngs_modulus = 1e7, .poissons_ratio = 0.3}}, 0.5};
  using Axes = std::vector<Eigen::Vector3d>;
  const bool hard = edges == Edges::hard;
  Explicit run{Scene{plate.nodes, Part{element, section, plate.quadrilaterals},
                     Pressure{quadrilateral_surface(plate.quadrilaterals), Constant{pressure}},
                     Symmetry{Axis::x, on(Axis::x, 0)}, Symmetry{Axis::y, on(Axis::y, 0)},
                     Support{on(Axis::x, half), {unit(Axis::z)}, hard ? Axes{unit(Axis::x)} : Axes{}},
                     Support{on(Axis::y, half), {unit(Axis::z)}, hard ? Axes{unit(Axis::y)} : Axes{}}}};
  Swing found;
  run.until(6e-4, [&] {
    if (const double w = -run.nodes().x(0).z(); w > found.largest) found = {w, run.time()};
  });
  return found;
}

}  // namespace

TEST_CASE("a simply supported plate swings under a step of pressure as the sum of Mindlin's modes") {
  const Swing coarse = swing(8, 1), fine = swing(16, 1);
  CHECK(coarse.largest == Approx(7.2110e-4).epsilon(0.01));
  CHECK(fine.largest == Approx(7.2110e-4).epsilon(0.01));
  CHECK(fine.time == Approx(5.138e-4).epsilon(0.01));
}

// Where a plate has tilted, a support about a fixed axis leaves moments about its normal. Nodes that are free to drill
// evade the support by them, the faster the smaller their inertia is; so finer meshes of Belytschko, Lin and Tsay's own
// element go as far as those on soft supports (docs/verification.md).
TEST_CASE("a simply supported plate stiffens as it swings far") {
  const Plate4 plain{PlateHourglass{}, NoWarping{}, ConstantThickness{}, FreeDrilling{}};
  CHECK(swing(8, 300, Edges::hard, plain).largest == Approx(0.2138).epsilon(0.002));  // an independent program of it
  const Swing theirs = swing(16, 300, Edges::hard, plain);
  CHECK(theirs.largest == Approx(0.2155).epsilon(0.002));
  CHECK(theirs.time == Approx(5.18e-4).epsilon(0.005));

  const Swing coarse = swing(8, 300), fine = swing(16, 300);
  CHECK(fine.largest == Approx(0.2155).epsilon(0.02));
  CHECK(fine.largest == Approx(coarse.largest).epsilon(0.001));
  const double soft = swing(16, 300, Edges::soft).largest;
  CHECK(soft > 1.02 * fine.largest);
  CHECK(swing(16, 300, Edges::soft, plain).largest == Approx(soft).epsilon(0.0005));  // nothing to evade
}
