#include <cmath>

#include <strike/material/eos/cubic.hpp>
#include <strike/material/eos/eos.hpp>

#include "support/catch.hpp"
#include "support/shock.hpp"

using namespace strike;
using testing::shock;

static_assert(EquationOfState<CubicEos> && !ThermalEquationOfState<CubicEos>);

namespace {

struct {
} nothing;

/// From a shock velocity U = c + k u.
CubicEos from_shock_velocity(double density, double c, double k) {
  const double C1 = density * c * c;
  return {.density = density, .C1 = C1, .C2 = (2 * k - 1) * C1, .C3 = (k - 1) * (3 * k - 1) * C1};
}

void check_state(const CubicEos& eos, double v, double mu, double p, double U) {
  const auto s = shock(eos, v);
  CHECK(std::abs(s.mu - mu) < 5e-6);  // half a unit of the last digit printed
  CHECK(s.pressure == Approx(p).epsilon(4e-6));
  CHECK(s.speed == Approx(U).epsilon(1e-5));
  CHECK(s.pressure == Approx(eos.density * s.speed * v).epsilon(1e-12));  // momentum
}

}  // namespace

TEST_CASE("cubic EOS: p = C1 mu + C2 mu^2 + C3 mu^3, without C2 in tension, and its slope") {
  const CubicEos eos{.density = 938, .C1 = 2, .C2 = 6, .C3 = 10};
  CHECK(eos.A(0.5) == 2 * 0.5 + 6 * 0.25 + 10 * 0.125);
  CHECK(eos.A(-0.5) == -2 * 0.5 - 10 * 0.125);
  for (const double J : {0.6, 0.95, 1.05, 1.6})
    CHECK(bulk_modulus(eos, nothing, J, eos.A(1 / J - 1)) ==
          Approx(testing::isentropic_bulk_modulus(eos, J, 0)).epsilon(1e-8));
}

TEST_CASE("cubic EOS: no pressure below the cut-off") {
  const CubicEos eos{.density = 938, .C1 = 2e9, .C2 = 6e9, .C3 = 10e9, .pressure_cutoff = -1e5};
  CHECK(advance_pressure(eos, nothing, 1.5, 0.1, 0.0, 0.0) == -1e5);
  CHECK(advance_pressure(eos, nothing, 1 + 1e-5, 0.0, 0.0, 0.0) == Approx(-2e4).epsilon(1e-4));
  CHECK(advance_pressure(eos, nothing, 0.9, 0.0, 0.0, 0.0) > 0);
}

TEST_CASE("cubic EOS: shock states of the bird of X3D") {
  const CubicEos bird{.density = 938, .C1 = 2.06e9, .C2 = 6.19e9, .C3 = 10.3e9};
  check_state(bird, 100, .063253, 157.674e6, 1680.95);
  check_state(bird, 180.0556, .108681, 310.219e6, 1836.79);  // 350 knots
  check_state(bird, 225, .132542, 405.760e6, 1922.58);
  const CubicEos denser{.density = 950, .C1 = 2.06e9, .C2 = 6.19e9, .C3 = 10.3e9};
  check_state(denser, 180.0556, .109304, 312.572e6, 1827.34);
}

TEST_CASE("cubic EOS: the coefficients of the bird are those of U = 1483 + 2 u") {
  const CubicEos bird = from_shock_velocity(938, 1483, 2);
  CHECK(bird.C1 == Approx(2.06e9).epsilon(2.5e-3));  // printed to three digits
  CHECK(bird.C2 == Approx(6.19e9).epsilon(1e-3));
  CHECK(bird.C3 == Approx(10.3e9).epsilon(2e-3));
}

TEST_CASE("cubic EOS: shock states of water") {
  const CubicEos water = from_shock_velocity(1000, 1480, 1.92);
  check_state(water, 180.0556, .109722, 327.895e6, 1821.08);
  check_state(water, 1000, .455524, 3195.27e6, 3195.27);
}

TEST_CASE("cubic EOS: shock states of copper, and how far three terms stand from the line U = c + s u") {
  const CubicEos copper = from_shock_velocity(8930, 3940, 1.489);
  check_state(copper, 500, .11959, 20901.0e6, 4681.1);
  check_state(copper, 1000, .22684, 48297.5e6, 5408.5);
  const auto line = [](double u) { return 8930 * (3940 + 1.489 * u) * u; };
  CHECK(shock(copper, 500).pressure / line(500) == Approx(.99927).epsilon(5e-6));
  CHECK(shock(copper, 1000).pressure / line(1000) == Approx(.99622).epsilon(5e-6));
}
