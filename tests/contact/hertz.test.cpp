#include "problems/hertz.hpp"

#include "support/catch.hpp"

using namespace strike;

TEST_CASE("a ball that strikes a plane approaches Hertz' force, time and approach as its mesh is refined") {
  const hertz::Impact coarse = hertz::strike_plane(6, 6), fine = hertz::strike_plane(9, 12);
  for (const auto& [impact, tolerance] : {std::pair{coarse, 0.4}, std::pair{fine, 0.1}}) {
    CHECK(impact.force == Approx(1).epsilon(tolerance));
    CHECK(impact.time == Approx(1).epsilon(tolerance));
    CHECK(impact.approach == Approx(1).epsilon(tolerance));
    CHECK(impact.rebound == Approx(1).epsilon(tolerance / 2));
    CHECK(impact.lost < 1e-3);
  }
}
