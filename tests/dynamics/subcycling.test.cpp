#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include <strike/dynamics/explicit.hpp>
#include <strike/dynamics/stop_when.hpp>
#include <strike/element/hex8.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/mesh/transform.hpp>
#include <strike/motion/openmp.hpp>
#include <strike/output/checkpoint.hpp>

#include "output/scratch.hpp"
#include "problems/column.hpp"
#include "support/catch.hpp"

using namespace strike;

namespace {

/// Counts how often it is asked for its stress, in steps that have a length.
struct Asked : Elastic {
  static inline std::atomic<std::size_t> times = 0;

  template <class T>
  auto stress(Elastic::State<T>& state, const SolidKinematics::Rate<T>& rate, double dt) const {
    times += dt > 0 ? 1 : 0;
    return Elastic::stress(state, rate, dt);
  }
  using Elastic::stress;
};

/// A bar along x of `fine` elements that a wave crosses in the time 1 and of `coarse` that it crosses in `ratio`, of
/// two materials, much wider than long: its waves have one direction. Its first quarter flies against the rest.
struct GradedBar {
  static constexpr double Z1 = 1, c1 = 1, Z2 = 2 * std::numbers::sqrt2, c2 = std::numbers::sqrt2, v = 1e-6;

  Index fine, coarse;
  double ratio;
  BulkViscosity viscosity{};

  Mesh mesh() const {
    return transformed(column(fine + coarse, fine + coarse, 1000), [&](const Eigen::Vector3d& x) {
      const double k = std::round(x[0]), n = fine;
      return Eigen::Vector3d(c1 * std::min(k, n) + c2 * ratio * std::max(k - n, 0.0), x[1], x[2]);
    });
  }
  template <class... Policies>
  auto run(const ExplicitOptions& options, const Policies&... policies) const {
    const Mesh bar = mesh();
    const auto middle = bar.hexahedra.begin() + fine;
    const Hex8 element{NoHourglass{}, HughesWinget{}, viscosity};
    const auto moving = nodes_where(bar.nodes, [&](const auto& x) { return x[0] < 0.25 * c1 * fine; });
    return Explicit{Scene{bar.nodes,
                          Part{element, Asked{{.density = Z1 / c1, .youngs_modulus = Z1 * c1}},
                               Cells<8>(bar.hexahedra.begin(), middle)},
                          Part{element, Asked{{.density = Z2 / c2, .youngs_modulus = Z2 * c2}},
                               Cells<8>(middle, bar.hexahedra.end())},
                          InitialVelocity{{v, 0, 0}, moving}},
                    options, in<double>, policies...};
  }
};

constexpr BulkViscosity none{.quadratic = 0, .linear = 0};

}  // namespace

TEST_CASE("subcycling: a part is advanced once in as many steps as its own allows, but near a faster one") {
  const std::size_t steps = 240;
  const auto asked = [&](double ratio, const Subcycling& policy) {
    auto run = GradedBar{.fine = 10, .coarse = 30, .ratio = ratio}.run({.energy_tolerance = 1}, policy);
    Asked::times = 0;
    for (std::size_t i = 0; i < steps; ++i) run.step();
    return Asked::times.load();
  };
  CHECK(asked(4.1, {}) == (10 + 2) * steps + 28 * steps / 4);
  CHECK(asked(4.1, {.layers = 0}) == 10 * steps + 30 * steps / 4);
  CHECK(asked(4.1, {.largest = 3}) == (10 + 2) * steps + 28 * steps / 3);
  CHECK(asked(3.9, {}) == (10 + 2) * steps + 28 * steps / 3);
  CHECK(asked(20, {}) == (10 + 2) * steps + 28 * steps / 8);
  CHECK(asked(1.9, {}) == 40 * steps);

  const auto run = GradedBar{.fine = 10, .coarse = 30, .ratio = 4}.run({}, Subcycling{});
  CHECK(run.warnings() == std::vector<std::string>{"part 1 is advanced once in 4 steps, but for 2 of its 30 elements, "
                                                   "which are near faster ones."});
}

TEST_CASE("subcycling: where all parts allow the same step, not a bit of the run changes") {
  const GradedBar bar{.fine = 10, .coarse = 30, .ratio = 1.5};
  auto usual = bar.run({});
  auto cycled = bar.run({}, Subcycling{});
  usual.until(300), cycled.until(300);
  CHECK(cycled.cycle().multiple() == 1);
  CHECK(cycled.steps() == usual.steps());
  CHECK(cycled.positions() == usual.positions());
  CHECK(cycled.energy().imbalance() == usual.energy().imbalance());
}

// What flies and its reflection from the free end run to the right as one pulse twice as long, of the velocity v/2. Of
// its stress s passes s 2 Z2/(Z1 + Z2), Z = rho c.
TEST_CASE("subcycling: a wave passes from a fast part into a slow one as 2 Z2/(Z1 + Z2)") {
  const GradedBar bar{.fine = 200, .coarse = 50, .ratio = 4};
  const double s = -bar.Z1 * bar.v / 2 * 2 * bar.Z2 / (bar.Z1 + bar.Z2);
  const auto plateau = [&](auto run) {
    run.until(290);  // the pulse fills the coarse elements 10 to 35
    const auto stress = run.template item<1>().field([](const auto& state) { return state.stress.xx; });
    return std::accumulate(stress.begin() + 16, stress.begin() + 30, 0.0) / 14;
  };
  CHECK(plateau(bar.run({})) == Approx(s).epsilon(5e-3));                // ripples, seen: 3.7e-3
  CHECK(plateau(bar.run({}, Subcycling{})) == Approx(s).epsilon(5e-3));  // seen: 1.4e-3
}

// All energy is in waves of a few elements, of which a kinetic energy m v-.v+/2 shows sin(w T)/(w T) of what a small
// step would, and crosses between the parts again and again: the balance swings, but nothing grows. Without layers
// between the parts the fast one is in resonance with the impulses of the slow one.
TEST_CASE("subcycling: momentum is kept, and energy for thousands of cycles without any viscosity") {
  const GradedBar bar{.fine = 10, .coarse = 30, .ratio = 4.5, .viscosity = none};
  auto run = bar.run({.energy_tolerance = 1}, Subcycling{});
  const double p = run.momentum().x(), end = 7200;
  double early = 0, late = 0;
  run.until(end, [&] {
    double& worst = run.time() < end / 4 ? early : late;
    worst = std::max(worst, std::abs(run.energy().error()));
  });
  CHECK(run.steps() > 4 * 2000);
  CHECK(run.momentum().x() == Approx(p).epsilon(1e-12));  // rounding of 8000 steps
  CHECK(early < 0.1);                                     // seen: 0.067
  CHECK(late < 1.1 * early);

  auto bare = bar.run({.energy_tolerance = 1}, Subcycling{.layers = 0});
  CHECK_THROWS_WITH(bare.until(end), Catch::Matchers::ContainsSubstring("the energy balance is off"));
}

TEST_CASE("subcycling: the same bits in threads, and from a checkpoint within a cycle") {
  const GradedBar bar{.fine = 200, .coarse = 300, .ratio = 4};
  const double end = 67.8;
  auto whole = bar.run({}, Subcycling{});
  whole.until(end);
  CHECK(whole.time() == end);
  CHECK(whole.steps() % 4 == 0);

  auto threads = bar.run({}, Subcycling{}, OpenMP{.threads = 2});
  threads.until(end);
  CHECK(threads.positions() == whole.positions());
  CHECK(threads.energy().imbalance() == whole.energy().imbalance());

  const ScratchFolder folder("subcycling");
  auto first = bar.run({}, Subcycling{}), second = bar.run({}, Subcycling{});
  first.until(end, StopWhen{[&] { return first.steps() == 42; }});
  write_checkpoint(folder / "half", first);
  read_checkpoint(folder / "half", second);
  second.until(end);
  CHECK(second.steps() == whole.steps());
  CHECK(second.positions() == whole.positions());
  CHECK(second.energy().imbalance() == whole.energy().imbalance());
}
