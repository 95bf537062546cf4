#include "problems/struck_bar.hpp"
#include "support/catch.hpp"

using namespace strike;
using namespace strike::struck_bar;

// At the step h/c lumped central differences carry a linear wave without any error; strains of v/c = 2e-10 and their
// squares are the only difference.
TEST_CASE("a bar on a wall at the step h/c is exact at every node until it leaves") {
  const double v = 1e-6;
  auto run = bar(v, exact_steps());
  const Index N = cells;
  double peak_force = 0;
  for (Index step = 1; step <= 2 * N; ++step) {
    run.step();
    INFO("step " << step);
    const std::vector<double> sigma = stress(run, v);
    double worst = 0;
    for (Index e = 0; e < N; ++e) {  // the front has crossed elements e < step, and unloads from the free end
      const bool loaded = step <= N ? e < step : e < 2 * N - step;
      worst = std::max(worst, std::abs(sigma[e] - (loaded ? -1 : 0)));
    }
    CHECK(worst < 1e-7);
    peak_force = std::max(peak_force, std::abs(run.item<2>().force().x() / (rho * c * v * h * h) - 1));
    CHECK(std::abs(run.energy().error()) < 1e-8);
  }
  CHECK(peak_force < 1e-7);
  for (Index node = 1; node <= N; ++node) CHECK(run.nodes().v(node).x() / v == Approx(1).epsilon(1e-7));
}

TEST_CASE("a rigid wall takes 1/(2 N) of a bar's energy, the kinetic energy of its foot") {
  const double v = 1;
  auto run = bar(v, {});
  double drift = 0;
  while (run.time() < 3 * L / c) {  // in equal steps: a change of the step costs of its own
    run.step();
    drift = std::max(drift, std::abs(run.energy().error()));
  }
  CHECK(run.energy().contact / run.energy().initial == Approx(1.0 / (2 * cells)).epsilon(1e-12));
  CHECK(drift < v / c);  // the share of the work that strains beyond the linear theory do
}
