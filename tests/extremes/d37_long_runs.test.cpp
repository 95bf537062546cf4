#include <cmath>

#include <strike/dynamics/explicit.hpp>
#include <strike/element/hex8.hpp>
#include <strike/mesh/box.hpp>
#include <strike/motion/clock.hpp>

#include "support/catch.hpp"

using namespace strike;

TEST_CASE("D37: 1e8 steps of 1e-9 from the time 1 on end at 1.1, where a plain sum is 8 steps off") {
  Clock clock;
  clock.set(1);
  volatile double plain = 1;
  for (int i = 0; i < 100000000; ++i) {
    clock.advance(1e-9);
    plain = plain + 1e-9;
  }
  CHECK(clock.time() == 1.1);
  CHECK(std::abs(plain - 1.1) > 8e-9);
}

TEST_CASE("D37: the time of a run is the number of its steps times their length") {
  const Mesh mesh = box({.size = {1, 1, 1}});
  const Elastic rubber{.density = 1000, .youngs_modulus = 1e8};
  Explicit run{Scene{mesh.nodes, Part{Hex8{}, rubber, mesh.hexahedra}}, ExplicitOptions{.largest_step = 1e-9},
               in<double>};
  for (int i = 0; i < 100000; ++i) run.step();
  CHECK(run.time() == 1e-4);
}
