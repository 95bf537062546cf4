#include "problems/supported_plate.hpp"

#include "support/catch.hpp"

using namespace strike;
using namespace strike::supported_plate;

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
  CHECK(swing(16, 300, Edges::soft, plain).largest == Approx(soft).epsilon(0.005));  // nothing to evade
}
