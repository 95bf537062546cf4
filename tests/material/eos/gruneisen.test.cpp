#include <strike/material/eos/eos.hpp>
#include <strike/material/eos/gruneisen.hpp>

#include "support/catch.hpp"
#include "support/shock.hpp"

using namespace strike;
using testing::shock;

static_assert(ThermalEquationOfState<GruneisenEos>);

TEST_CASE("Gruneisen EOS: its Hugoniot is the shock velocity it was made from, whatever gamma is") {
  for (const double gamma : {0.5, 1.99})
    for (const double a : {0.0, 0.47}) {
      const GruneisenEos copper{.density = 8930, .sound_speed = 3940, .S1 = 1.489, .gamma = gamma, .a = a};
      for (const double v : {10.0, 500.0, 2000.0}) {
        const auto s = shock(copper, v, 1.5);
        CHECK(s.speed == Approx(3940 + 1.489 * v).epsilon(1e-12));
        CHECK(s.pressure == Approx(8930 * (3940 + 1.489 * v) * v).epsilon(1e-12));
      }
    }
}

TEST_CASE("Gruneisen EOS: with the curved shock velocity U = c + S1 u + S2 (u/U) u + S3 (u/U)^2 u") {
  const GruneisenEos water{// Steinberg's
                           .density = 1000, .sound_speed = 1480, .S1 = 2.56, .S2 = -1.986, .S3 = 0.2268, .gamma = 0.5};
  for (const double v : {10.0, 300.0, 1000.0}) {
    const double U = shock(water, v).speed, eta = v / U;
    CHECK(U == Approx(1480 + v * (2.56 + eta * (-1.986 + eta * 0.2268))).epsilon(1e-12));
  }
}

TEST_CASE("Gruneisen EOS: a line in tension, and its bulk modulus on both sides") {
  const GruneisenEos eos{.density = 2, .sound_speed = 3, .S1 = 1.5, .S2 = 0.1, .S3 = 0.2, .gamma = 2, .a = 0.5};
  CHECK(eos.A(-0.25) == 2 * 9 * -0.25);
  CHECK(eos.B(-0.25) == 2 - 0.125);
  for (const double J : {0.7, 0.95, 1.05, 1.2})
    for (const double E : {0.0, 3.0}) {
      const double mu = 1 / J - 1;
      CHECK(bulk_modulus(eos, EosState<GruneisenEos, double>{E}, J, eos.A(mu) + eos.B(mu) * E) ==
            Approx(testing::isentropic_bulk_modulus(eos, J, E)).epsilon(1e-7));
    }
}
