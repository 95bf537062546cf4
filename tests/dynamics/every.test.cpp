#include <vector>

#include <strike/dynamics/every.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {
struct Ticks {
  double now;
  double time() const { return now; }
};
}  // namespace

TEST_CASE("an Every acts at the start and at the first step past each multiple of its interval") {
  std::vector<double> acted;
  Every every{1.0, [&](const Ticks& clock) { acted.push_back(clock.now); }};
  for (const double t : {0.0, 0.4, 0.8, 1.2, 1.6, 2.0, 5.5, 5.9, 6.0}) every(Ticks{t});
  CHECK(acted == std::vector{0.0, 1.2, 2.0, 5.5, 6.0});
}

TEST_CASE("an Every whose multiples are not exact in binary acts once for each") {
  int count = 0;
  Every every{0.1, [&] { ++count; }};
  for (int i = 0; i <= 1000; ++i) every(Ticks{0.001 * i});
  CHECK(count == 11);
}

TEST_CASE("an Every acts once more at the end of a run that was given up") {
  int count = 0;
  Every every{1.0, [&] { ++count; }};
  every(Ticks{0.0});
  every(Ticks{0.5});
  every.last(Ticks{0.6});
  CHECK(count == 2);
}

TEST_CASE("an interval that is not positive is refused") {
  CHECK_THROWS_AS((Every{0.0, [] {}}), Error);
}
