#include <cmath>

#include <strike/scalar/bisect.hpp>

#include "support/catch.hpp"

using namespace strike;

static_assert(bisect(
                  Bracket<double>{0, 1}, [](double x) { return x < 0.25; }, 2)
                  .upper == 0.25);

TEST_CASE("bisect halves a bracket as often as it is told, or until it is narrow") {
  const auto below = [](double x) { return x * x < 2; };
  const Bracket<double> often = bisect(Bracket<double>{1, 2}, below, 52);
  CHECK(often.upper - often.lower == std::ldexp(1, -52));
  CHECK(below(often.lower));
  CHECK(!below(often.upper));
  const Bracket<double> narrow =
      bisect(Bracket<double>{1, 2}, below, [](const Bracket<double>& b) { return b.upper - b.lower > 1e-3; });
  CHECK(narrow.upper - narrow.lower == std::ldexp(1, -10));
  CHECK(bisect(
            Bracket<double>{2, 1}, [](double x) { return x > 1.5; }, 1)
            .upper == 1.5);  // a falling one too
}
