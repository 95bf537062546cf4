#include <algorithm>

#include <strike/element/hex8.hpp>

#include "conformance/element.hpp"

using namespace strike;
using testing::conforms;
using testing::Degenerate;
using testing::FiniteRotations;
using testing::unit_pyramid;
using testing::unit_wedge;

TEST_CASE("conformance: wedges of Hex8") { conforms(Degenerate<Hex8<>, 6>{}, FiniteRotations::exact, unit_wedge()); }
TEST_CASE("conformance: wedges of Hex8 with viscous hourglass control") {
  conforms(Degenerate<Hex8<ViscousHourglass>, 6>{}, FiniteRotations::exact, unit_wedge());
}
TEST_CASE("conformance: pyramids of Hex8") {
  conforms(Degenerate<Hex8<>, 5>{}, FiniteRotations::exact, unit_pyramid());
}
TEST_CASE("conformance: pyramids of Hex8 with stiffness hourglass control, of Jaumann") {
  conforms(Degenerate<Hex8<StiffnessHourglass, Jaumann>, 5>{}, FiniteRotations::exact, unit_pyramid());
}

static_assert(Element<Degenerate<Hex8<>, 6>> && Element<Degenerate<Hex8<>, 5>>);

namespace {

/// Modes of the stiffness and the damping together that have none, and the ratio of the exact step to the claimed.
template <class E>
void study(const E& element, const Nodal<double, E::nodes>& corners, double most_unused) {
  testing::Shapes<E::nodes> shapes(3, corners);
  double least = 10, regular = 0;
  for (int trial = 0; trial < 40; ++trial) {
    const Nodal<double, E::nodes> x = trial == 0 ? corners : shapes();
    const verify::SingleElement single{element, Elastic{1, 1, 0.3}, x};
    auto vibration = testing::vibration_of(single);
    const double exact = vibration.critical_step(), ratio = exact / single.now().stable_step;
    if (trial == 0) regular = ratio;
    least = std::min(least, ratio);
    vibration.stiffness += vibration.damping / exact;
    const Eigen::VectorXd w = vibration.frequencies() / vibration.frequencies().maxCoeff();
    CHECK(w(5) < 2e-5);  // the root of the rounding 1e-16 in steps of 1e-6
    CHECK(w(6) > 1e-3);  // in shapes whose edges differ by up to 7.4 times
  }
  CHECK(least >= 1);
  CHECK(regular <= most_unused);
}

}  // namespace

// Of a cube the claimed step is 1.137 times too small for nu = 0.3, which is that of the bound of the vibrations.
TEST_CASE(
    "wedges and pyramids of Hex8: only rigid motions are without resistance, and the step is as sharp as cubes'") {
  study(Degenerate<Hex8<>, 6>{}, unit_wedge(), 1.2);
  study(Degenerate<Hex8<ViscousHourglass>, 6>{}, unit_wedge(), 1.2);
  study(Degenerate<Hex8<>, 5>{}, unit_pyramid(), 1.2);
  study(Degenerate<Hex8<StiffnessHourglass, Jaumann>, 5>{}, unit_pyramid(), 1.2);
}

TEST_CASE("wedges and pyramids: a hexahedron in the lanes of others keeps its step") {
  using P = Pack<double, 4>;
  testing::Shapes<8> shapes(5);
  const Nodal<P, 8> x = shapes().cast<P>(), v = shapes.nodal().cast<P>();
  const Hex8<> element;
  typename Hex8<>::State<std::decay_t<decltype(testing::metal)>, P> state;
  element.begin(state, testing::metal, x);
  VibrationSources<P> sources;
  const auto response = element.advance(state, testing::metal, x, v, 1e-3, &sources);
  const P rate = element.merged_rate(state, testing::metal, {MergedCorners<P>{}, x}, response.volume, sources);
  for (std::size_t l = 0; l < 4; ++l) CHECK(lane(rate, l) == Approx(lane(response.critical_rate, l)).epsilon(1e-13));
}
