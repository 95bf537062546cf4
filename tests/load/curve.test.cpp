#include <strike/load/curve.hpp>

#include "support/catch.hpp"

using namespace strike;

TEST_CASE("a curve is straight between its points and level outside") {
  const Curve curve{{{1, 10}, {2, 30}, {4, -10}}};
  CHECK(curve(0) == 10);
  CHECK(curve(1) == 10);
  CHECK(curve(1.5) == 20);
  CHECK(curve(2) == 30);
  CHECK(curve(3) == 10);
  CHECK(curve(4) == -10);
  CHECK(curve(9) == -10);
}

TEST_CASE("a curve without points or with times that do not increase is refused") {
  CHECK_THROWS_WITH(Curve({}), "strike: a Curve has no points; give it at least one.");
  CHECK_THROWS_WITH(Curve({{1, 0}, {1, 2}}),
                    "strike: point 1 of a Curve is at time 1, not after the one before at 1; sort the points by time.");
}
