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
  CHECK_THROWS_AS(Curve({}), Error);
  CHECK_THROWS_AS(Curve({{1, 0}, {1, 2}}), Error);
}
