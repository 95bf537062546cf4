// The pressure of the nodes alone in a fluid without strength, of tetrahedra.
#include <algorithm>
#include <cmath>

#include "problems/water_bird.hpp"
#include "support/catch.hpp"

using namespace strike;

namespace {

/// The least step on the way to 0.5 ms [ms].
template <class Run>
double least_step(Run& run) {
  double least = run.stable_step().dt;
  run.until(0.5, [&] { least = std::min(least, run.stable_step().dt); });
  CHECK(std::abs(run.energy().error()) < 2e-3);
  return least;
}

}  // namespace

TEST_CASE("D7: water of tetrahedra with a blend of pressures finishes, its step never below 1 % of the first") {
  auto run = water_bird::on_plate(Tet4{}, 2);
  const double first = run.stable_step().dt;
  CHECK(least_step(run) > 0.01 * first);
}

// On a mesh of 4 x 32 the step falls to a millionth after 0.44 ms (the bench verification).
TEST_CASE("D7: with the pressure of the nodes alone what collapses is deleted, with a warning") {
  auto run = water_bird::on_plate(Tet4{NodalPressure{1.0}}, 2, Erosion{.step = 2e-4});  // an eighth of the first
  CHECK(least_step(run) >= 2e-4);
  const auto& part = run.part<0>();
  CHECK(part.deleted() > 0);
  CHECK(part.deleted() < part.size() / 10);
  CHECK(run.warnings().size() == 1);
}
