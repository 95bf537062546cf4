#include <limits>

#include "problems/taylor_bar.hpp"
#include "support/catch.hpp"

using namespace strike;

namespace {

taylor::Data with_speed(double v) {
  taylor::Data data = taylor::mm_ms_kg;
  data.speed = v;
  return data;
}

}  // namespace

TEST_CASE("D24: a bar at velocities down to the smallest numbers, and at rest") {
  for (const double v : {0.0, 1e-320, 1e-310, 1e-160, 1e-20}) {
    INFO("v = " << v);
    auto run = taylor::bar(with_speed(v), 2, 4, in<Pack<double>>);
    while (run.steps() < 2000) run.step();
    CHECK(taylor::length(run) == taylor::mm_ms_kg.length);  // bit for bit: what moves is below the spacing of numbers
    CHECK(taylor::plastic_strain(run) == 0);
    for (std::size_t i = 0; i < run.nodes().size(); ++i) {
      CHECK(run.nodes().v(i).norm() < 1e-9);  // rounding of the volumes: eps c = 1e-12 m/s, and ten times that
      CHECK(run.nodes().f(i).allFinite());
    }
  }
}
