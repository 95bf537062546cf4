#include "problems/free_cubes.hpp"
#include "support/catch.hpp"

using namespace strike;

TEST_CASE("D2: free cubes at nu = 0.4999 are stable at 0.9 of the step") {
  auto run = free_cubes::cubes();
  CHECK(free_cubes::drift(run, 3000) < 1e-6);  // 100000 in bench/verification
  CHECK(run.energy().kinetic < run.energy().initial);
}

TEST_CASE("D2: 0.9 h/c is beyond stability there, and the driver says so") {
  auto run = free_cubes::cubes({.step_factor = 1e9, .largest_step = 0.9 * free_cubes::h / free_cubes::wave_speed()});
  CHECK_THROWS_WITH(run.until(1), Catch::Matchers::ContainsSubstring("the step is beyond stability"));
  CHECK(run.steps() < 200);
}
