// Moments of a run outside the usual sequence: steps after the end, ends that are past, errors of observers.
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <strike/dynamics/every.hpp>
#include <strike/dynamics/explicit.hpp>
#include <strike/dynamics/stop_when.hpp>
#include <strike/element/hex8.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/mesh/box.hpp>

#include "support/catch.hpp"

using namespace strike;
using Catch::Matchers::ContainsSubstring;

namespace {

/// A cube that swings.
auto swinging(ExplicitOptions options = {}) {
  const Mesh mesh = box({.size = {1, 1, 1}, .cells = {2, 2, 2}});
  const Elastic rubber{.density = 1, .youngs_modulus = 1000, .poissons_ratio = 0.3};
  const auto stretch = [](const Eigen::Vector3d& x) { return Eigen::Vector3d(0.1 * x.x(), 0, 0); };
  return Explicit{Scene{mesh.nodes, Part{Hex8{}, rubber, mesh.hexahedra}, InitialVelocityField{stretch}}, options,
                  in<double>};
}

/// An observer whose `last` fails or counts.
struct Witness {
  bool fails;
  int seen = 0;
  void operator()() const {}
  template <class Run>
  void last(const Run&) {
    ++seen;
    if (fails) throw Error("strike: the disk is full.");
  }
};

}  // namespace

TEST_CASE("steps after an end go on as before it") {
  auto run = swinging();
  run.until(1);
  REQUIRE(run.time() == 1);
  const double stable = run.stable_step().dt;
  for (int i = 0; i < 4; ++i) {
    const double before = run.time();
    run.step();
    CHECK(run.time() > before);
    CHECK(run.dt() > 0.8 * stable);
  }
  CHECK(run.end() == 1);
  auto stopped = swinging();
  stopped.until(1, StopWhen{[&] { return stopped.time() > 0.5; }});
  while (stopped.time() < 1) stopped.step();
  CHECK(stopped.time() > 1);  // no step aims at an end that until has left
}

TEST_CASE("an end that is past or no time is refused, and the present one does nothing") {
  auto run = swinging();
  run.until(1);
  const std::size_t steps = run.steps();
  CHECK_THROWS_WITH(run.until(0.5),
                    "strike: the run is at t = 1 and cannot go until 0.5, which is past; give a later end.");
  CHECK_THROWS_WITH(run.until(std::nan("")), "strike: the end of a run is nan; give until a time.");
  CHECK_THROWS_AS(run.until(-std::numeric_limits<double>::infinity()), Error);
  int seen = 0;
  run.until(1, [&] { ++seen; });
  CHECK(run.steps() == steps);
  CHECK(seen == 0);
  run.until(1.5);
  CHECK(run.time() == 1.5);
  auto fresh = swinging();
  fresh.until(0, [&] { ++seen; });  // the state at the start
  CHECK(seen == 1);
  CHECK(fresh.steps() == 0);
}

TEST_CASE("until within an observer is refused, and the run can go on") {
  auto run = swinging();
  CHECK_THROWS_WITH(run.until(1, [&] { run.until(2); }), ContainsSubstring("has been called by an observer"));
  CHECK(run.time() == 0);
  run.until(0.1);
  CHECK(run.time() == 0.1);
}

TEST_CASE("the last 50 steps are a little shorter, all alike") {
  for (const double end : {0.25, 0.2515, 0.2535, 0.2555, 0.2595}) {
    auto run = swinging({.largest_step = 0.005});
    double before = 0.005, least = 0.005, change = 0;
    run.until(end, [&] {
      if (run.steps() > 0) change = std::max(change, std::abs(run.dt() / before - 1)), before = run.dt();
      least = std::min(least, before);
    });
    CHECK(run.time() == end);
    CHECK(change < 1.0 / 49);
    CHECK(least > 0.005 * 49 / 50);
    CHECK(run.steps() == static_cast<std::size_t>(std::ceil(end / 0.005 - 1e-6)));
  }
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK(detail::step_to_end(1, 20) == 1);
  CHECK(detail::step_to_end(1, 19.5) == 19.5 / 20);
  CHECK(detail::step_to_end(1, 50.5) == 1);
  CHECK(detail::step_to_end(1, 1.4) == 0.7);
  CHECK(detail::step_to_end(1, 0.3) == 0.3);
  CHECK(detail::step_to_end(1, infinity) == 1);
}

TEST_CASE("an end costs little balance, wherever it lies between two steps") {
  double most = 0;
  auto longer = swinging();
  longer.until(2, [&] { most = std::max(most, longer.time() < 1.1 ? std::abs(longer.energy().imbalance()) : 0.0); });
  for (const double end : {1.0, 1.002, 1.004, 1.006}) {
    double error = 0;
    auto run = swinging();
    run.until(end, [&] { error = std::max(error, std::abs(run.energy().imbalance())); });
    CHECK(error < 2 * most);  // with two steps of half the length 25 times
  }
}

TEST_CASE("an error of an observer's last hides neither why the run was given up nor the run from the others") {
  auto run = swinging();
  Witness failing{.fails = true}, other{.fails = false};
  const auto gives_up = [&] {
    if (run.steps() == 3) throw Error("strike: the law has no answer.");
  };
  CHECK_THROWS_WITH(run.until(1, failing, other, gives_up),
                    "strike: the law has no answer. Then an observer has failed too: strike: the disk is full.");
  CHECK(failing.seen == 1);
  CHECK(other.seen == 1);
  auto again = swinging();
  CHECK_THROWS_WITH(again.until(1, other, [&] { throw Error("strike: no."); }), "strike: no.");
}
