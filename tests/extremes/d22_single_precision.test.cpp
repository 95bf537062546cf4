#include "problems/taylor_bar.hpp"
#include "support/catch.hpp"

using namespace strike;

TEST_CASE("D22: the Taylor bar in single precision differs by less than 0.1 %") {
  auto run = taylor::bar(taylor::mm_ms_kg, 3, 50, in<Pack<float>>);
  double drift = 0;
  run.until(taylor::mm_ms_kg.end, [&] { drift = std::max(drift, std::abs(run.energy().error())); });
  CHECK(taylor::length(run) == Approx(21.473).epsilon(1e-3));  // in double, see problems/taylor.test.cpp
  CHECK(taylor::radius(run) == Approx(7.190).epsilon(1e-3));
  CHECK(drift < 5e-3);
}
