#include "problems/particle_taylor.hpp"

#include <algorithm>
#include <cmath>

#include "support/catch.hpp"

using namespace strike;

// Particles reach half a spacing beyond the highest node, as below the lowest. Their feet are too wide
// (docs/verification.md), so that the length alone is a reference.
TEST_CASE("particles: Taylor's bar becomes as long as published", "[particles]") {
  auto run = taylor::bar_of_particles(3);
  double drift = 0;
  run.until(taylor::mm_ms_kg.end, [&] { drift = std::max(drift, std::abs(run.energy().error())); });
  CHECK(taylor::length(run) == Approx(21.47).epsilon(0.02));  // four codes' (Brockman and Held 1991)
  CHECK(drift < 6e-3);
}
