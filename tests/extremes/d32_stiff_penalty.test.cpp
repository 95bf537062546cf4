#include <algorithm>
#include <cmath>

#include "problems/two_bars.hpp"
#include "support/catch.hpp"

using namespace strike;
using namespace strike::two_bars;

namespace {

/// The largest energy of bars that meet through springs of f EA/h, over that at the start.
template <class MakeContact>
double largest_energy(double step_factor, const MakeContact& contact) {
  const Bars bars(20);
  auto run = bars.run(0.5, -0.5, 0, {.step_factor = step_factor, .largest_step = bars.h / c, .energy_tolerance = 1e9},
                      contact(bars));
  double most = 0;
  for (int n = 0; n < 200; ++n) {
    run.step();
    const Energy& e = run.energy();
    most = std::max(most, (e.kinetic + e.internal) / e.initial);
  }
  return most;
}

}  // namespace

TEST_CASE("D32: a penalty that is too stiff for the elements' step lowers it, and adds no energy if it may not") {
  for (const double f : {1.0, 4.0, 10.0}) {
    const auto penalty = [&](const Bars& bars) {
      const Penalty law{.stiffness = f * E * bars.width * bars.width / bars.h / 4};
      return Contact{NodeToSurface{bars.end_nodes(false), Surface{bars.end(true)}}, law};
    };
    const Bars bars(20);
    const double lowered = stable_step_with_contact(1, 4 * f);
    const auto run = bars.run(0.5, -0.5, 0, {}, penalty(bars));
    CHECK(run.stable_step().dt == Approx(lowered * bars.h / c).epsilon(1e-4));
    CHECK(largest_energy(0.9, penalty) < 1.0001);
    CHECK(largest_energy(0.9 / lowered, penalty) < 1.0001);  // 0.9 of the elements' step
  }
}
