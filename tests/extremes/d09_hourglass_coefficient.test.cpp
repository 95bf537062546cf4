#include <strike/dynamics/explicit.hpp>
#include <strike/element/hex8.hpp>
#include <strike/mesh/box.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {

const Elastic material{.density = 1, .youngs_modulus = 1};  // c = 1
constexpr Index n = 3;

/// The nodes of a mesh of unit cubes begin in the pattern that every element feels as an hourglass.
struct Zigzag {
  void begin(auto& nodes) const {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const int parity = int(std::lround(nodes.x(i).x() + nodes.x(i).y() + nodes.x(i).z()));
      nodes.set_velocity(i, {parity % 2 == 0 ? 1e-3 : -1e-3, 0, 0});
    }
  }
};

auto cubes(double Q, double tolerance = 0.05) {
  const Mesh mesh = box({.size = {n, n, n}, .cells = {n, n, n}});
  const Hex8 element{ViscousHourglass{Q}, HughesWinget{}, NoBulkViscosity{}};
  return Explicit{Scene{mesh.nodes, Part{element, material, mesh.hexahedra}, Zigzag{}},
                  ExplicitOptions{.energy_tolerance = tolerance}, in<double>};
}

}  // namespace

TEST_CASE("D9: with Q = 0 nothing resists the hourglass pattern") {
  auto run = cubes(0);
  const double v = run.nodes().v(0).x();
  for (int i = 0; i < 100; ++i) run.step();
  CHECK(run.energy().kinetic == Approx(run.energy().initial).epsilon(1e-6));  // bricks of other shapes do feel it
  CHECK(run.nodes().v(0).x() == Approx(v).epsilon(1e-3));
  CHECK(run.energy().hourglass == 0);
}

// Where Q shortens the step, (1 - 1.8) of the velocities is left by each, and with the signs of what lags half a step
// the ledger books less than the pattern loses.
TEST_CASE("D9: from Q = 0.005 to 1 the pattern decays, and the step shrinks by itself where Q needs it") {
  double free_step = 0;
  for (const double Q : {0.005, 0.05, 0.1, 0.125, 0.2, 0.5, 1.0}) {
    auto run = cubes(Q, 100);
    const double step = run.stable_step().dt;
    if (free_step == 0) free_step = step;  // the smallest Q does not matter
    CHECK(step == Approx(std::min(free_step, 1 / (8 * Q))).epsilon(2e-3));
    const double before = run.energy().initial;
    for (int i = 0; i < 400; ++i) run.step();
    CHECK(std::abs(run.energy().kinetic) < 1e-3 * before);
    CHECK(run.energy().hourglass > 0);
    if (const double lag = 8 * Q * step; lag < 0.5) CHECK(std::abs(run.energy().hourglass / before - 1) < lag);
  }
}
