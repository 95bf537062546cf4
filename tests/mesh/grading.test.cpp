#include <strike/mesh/grading.hpp>

#include "support/catch.hpp"

using namespace strike;

TEST_CASE("graded: lengths form a geometric series whose last over first is the grading") {
  for (const double grading : {1.0, 3.0, 1.0 / 3, 1e3}) {
    const auto x = graded(-1, 4, 20, grading);
    REQUIRE(x.size() == 21);
    CHECK(x.front() == -1);
    CHECK(x.back() == 4);
    // The difference of neighbouring positions carries an error of eps * 4 in the smallest cell, 5e-3: 2e-13.
    CHECK((x[20] - x[19]) / (x[1] - x[0]) == Approx(grading).epsilon(1e-12));
    for (std::size_t i = 1; i < 20; ++i)
      CHECK((x[i + 1] - x[i]) / (x[i] - x[i - 1]) == Approx(std::pow(grading, 1.0 / 19)).epsilon(1e-12));
  }
}
