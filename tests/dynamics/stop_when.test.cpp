#include <strike/strike.hpp>

#include "support/catch.hpp"

using namespace strike;

TEST_CASE("a run ends when its condition is met, at its end otherwise") {
  const Mesh mesh = box({.size = {1, 1, 1}, .cells = {1, 1, 1}});
  const Elastic rubber{.density = 1000, .youngs_modulus = 1e6};
  Explicit run{Scene{mesh.nodes, Part{Hex8{}, rubber, mesh.hexahedra}, InitialVelocity{{1, 0, 0}}}, {}, in<double>};
  std::vector<double> times;
  run.until(1.0, StopWhen{[](const auto& r) { return r.steps() == 7; }}, [&] { times.push_back(run.time()); });
  CHECK(run.steps() == 7);
  CHECK(times.size() == 8);  // before the first step and after each
  run.until(1.0, StopWhen{[] { return false; }});
  CHECK(run.time() == 1.0);
}
