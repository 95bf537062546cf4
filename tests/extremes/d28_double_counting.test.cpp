// D28: copper at 2 km/s. Coefficients that were fitted to the Hugoniot hold the heat of the shock already; Gruneisen's
// term on top of them counts it twice.
#include <strike/material/eos/gruneisen.hpp>
#include <strike/material/eos/polynomial.hpp>

#include "support/catch.hpp"
#include "support/shock.hpp"

using namespace strike;

namespace {

constexpr double rho = 8930, c = 3940, k = 1.489, gruneisen = 1.99;
constexpr double C1 = rho * c * c, C2 = (2 * k - 1) * C1, C3 = (k - 1) * (3 * k - 1) * C1;

/// Pressure over that of the Hugoniot rho (c + k u) u.
template <class Eos>
double ratio(const Eos& eos, double u) {
  return testing::shock(eos, u).pressure / (rho * (c + k * u) * u);
}

}  // namespace

TEST_CASE("D28: Hugoniot coefficients with Gruneisen's term exceed by 1.2, 5.1, 8.4, 12.3 %") {
  const PolynomialEos twice{.density = rho, .C1 = C1, .C2 = C2, .C3 = C3, .C4 = gruneisen, .C5 = gruneisen};
  CHECK(ratio(twice, 100) == Approx(1.012).margin(5e-4));  // digits printed
  CHECK(ratio(twice, 500) == Approx(1.051).margin(5e-4));
  CHECK(ratio(twice, 1000) == Approx(1.084).margin(5e-4));
  CHECK(ratio(twice, 2000) == Approx(1.123).margin(5e-4));
}

TEST_CASE("D28: C2 - Gamma C1/2 and C3 - Gamma C2/2 correct it: 1.0000, 1.0004, 1.0021, 1.0103") {
  const PolynomialEos once{.density = rho,
                           .C1 = C1,
                           .C2 = C2 - gruneisen * C1 / 2,
                           .C3 = C3 - gruneisen * C2 / 2,
                           .C4 = gruneisen,
                           .C5 = gruneisen};
  CHECK(ratio(once, 100) == Approx(1.0000).margin(5e-5));
  CHECK(ratio(once, 500) == Approx(1.0004).margin(5e-5));
  CHECK(ratio(once, 1000) == Approx(1.0021).margin(5e-5));
  CHECK(ratio(once, 2000) == Approx(1.0103).margin(5e-5));
}

TEST_CASE("D28: the equation of Mie and Gruneisen is exact at any speed") {
  const GruneisenEos exact{.density = rho, .sound_speed = c, .S1 = k, .gamma = gruneisen};
  for (const double u : {100.0, 500.0, 1000.0, 2000.0}) CHECK(ratio(exact, u) == Approx(1).epsilon(1e-12));
}
