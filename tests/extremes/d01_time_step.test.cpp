#include "problems/struck_bar.hpp"
#include "support/catch.hpp"

using namespace strike;
using namespace strike::struck_bar;

TEST_CASE("D1: at 0.99 of the critical step a wave without any damping stays bounded") {
  const double v = 1;
  auto run = bar(v, {.step_factor = 0.99});
  double worst = 0;
  while (run.steps() < 5000) {
    run.step();
    for (const double s : stress(run, v)) worst = std::max(worst, std::abs(s));
  }
  CHECK(worst < 1.4);
}

TEST_CASE("D1: 1.01 of the critical step is detected within 60 steps") {
  for (const double v : {1e-6, 1.0, 100.0}) {  // growth by 1.3266 a step (Nyquist mode), from whatever amplitude
    auto run = bar(v, {.step_factor = 2, .largest_step = 1.01 * bar(v, {}).stable_step().dt});
    CHECK_THROWS_WITH(run.until(1), Catch::Matchers::ContainsSubstring("use a smaller step factor"));
    CHECK(run.steps() < 60);
    for (const auto& x : run.positions()) CHECK(x.allFinite());
  }
}
