#include <cmath>
#include <random>

#include <strike/dynamics/explicit.hpp>
#include <strike/element/hex8.hpp>
#include <strike/mesh/box.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {

constexpr double E = 1e9, nu = 0.4999, rho = 1000, h = 1.0 / 8;

/// Velocities so small that 1e5 steps of an hourglass do not turn the cubes over.
struct RandomVelocity {
  template <class N>
  void begin(N& nodes) const {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform(-1e-6, 1e-6);
    for (std::size_t i = 0; i < nodes.size(); ++i)
      for (int c = 0; c < 3; ++c) nodes.v(i)(c) = uniform(random);
  }
};

/// 8 x 8 x 8 free cubes without damping of any kind.
auto cubes(const ExplicitOptions& options) {
  const Mesh mesh = box({.size = {1, 1, 1}, .cells = {8, 8, 8}});
  return Explicit{
      Scene{mesh.nodes,
            Part{Hex8{NoHourglass{}, HughesWinget{}, NoBulkViscosity{}},
                 Elastic{.reference_density = rho, .youngs_modulus = E, .poissons_ratio = nu}, mesh.hexahedra},
            RandomVelocity{}},
      options};
}

}  // namespace

TEST_CASE("D2: free cubes at nu = 0.4999 are stable at 0.9 of the step") {
  auto run = cubes({});
  double drift = 0;
  while (run.steps() < 3000) {  // 100000 in bench/verification
    run.step();
    drift = std::max(drift, std::abs(run.energy().error()));
  }
  CHECK(drift < 1e-6);
  CHECK(run.energy().kinetic < run.energy().initial);
}

TEST_CASE("D2: 0.9 h/c is beyond stability there, and the driver says so") {
  const double wave = E * (1 - nu) / ((1 + nu) * (1 - 2 * nu));
  auto run = cubes({.step_factor = 1e9, .largest_step = 0.9 * h / std::sqrt(wave / rho)});
  CHECK_THROWS_WITH(run.until(1), Catch::Matchers::ContainsSubstring("the step is beyond stability"));
  CHECK(run.steps() < 200);
}
