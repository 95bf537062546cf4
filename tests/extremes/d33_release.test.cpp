#include "problems/struck_bar.hpp"
#include "support/catch.hpp"

using namespace strike;
using namespace strike::struck_bar;

TEST_CASE("D33: a bar leaves the wall at 2 L/c, and the wall never pulls") {
  const double v = 1;
  for (const double factor : {0.5, 0.9}) {
    auto run = bar(v, {.step_factor = factor});
    double least = 0, last_touch = 0;
    run.until(5 * L / c, [&] {
      const double force = run.item<2>().force().x();
      least = std::min(least, force);
      if (force > 0.5 * rho * c * v * h * h) last_touch = run.time();
    });
    CHECK(least == 0);
    CHECK(last_touch == Approx(2 * L / c).margin(h / c));
    const double m = rho * L * h * h;
    CHECK(run.item<2>().impulse().x() == Approx(2 * m * v).epsilon(0.03));
    CHECK(run.momentum().x() == Approx(run.item<2>().impulse().x() - m * v).epsilon(1e-12));
  }
}
