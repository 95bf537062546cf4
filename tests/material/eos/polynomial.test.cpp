#include <strike/material/eos/cubic.hpp>
#include <strike/material/eos/eos.hpp>
#include <strike/material/eos/polynomial.hpp>

#include "support/catch.hpp"
#include "support/shock.hpp"

using namespace strike;

static_assert(ThermalEquationOfState<PolynomialEos>);

namespace {
using State = EosState<PolynomialEos, double>;
}

TEST_CASE("polynomial EOS: seven coefficients, C2 and C6 in compression only") {
  const PolynomialEos eos{
      .density = 1, .C0 = 1, .C1 = 2, .C2 = 3, .C3 = 5, .C4 = 7, .C5 = 11, .C6 = 13};  // primes tell them apart
  CHECK(eos.A(0.5) == 1 + 2 * 0.5 + 3 * 0.25 + 5 * 0.125);
  CHECK(eos.B(0.5) == 7 + 11 * 0.5 + 13 * 0.25);
  CHECK(eos.A(-0.5) == 1 - 2 * 0.5 - 5 * 0.125);
  CHECK(eos.B(-0.5) == 7 - 11 * 0.5);
  for (const double J : {0.6, 0.95, 1.05, 1.6})
    for (const double E : {0.0, 0.3, 4.0}) {
      const double mu = 1 / J - 1;
      CHECK(bulk_modulus(eos, State{E}, J, eos.A(mu) + eos.B(mu) * E) ==
            Approx(testing::isentropic_bulk_modulus(eos, J, E)).epsilon(1e-8));
    }
}

TEST_CASE("polynomial EOS: begins with the pressure of its energy at rest") {
  const PolynomialEos eos{.density = 1000, .C0 = 1e5, .C4 = 0.4, .initial_energy = 2.5e5};
  State state;
  CHECK(begin_eos(eos, state) == 2e5);
  CHECK(state.internal_energy == 2.5e5);
}

TEST_CASE("polynomial EOS: shock states of water with energy (Steinberg's set)") {
  const PolynomialEos water{.density = 1000, .C1 = 2.19e9, .C2 = 9.224e9, .C3 = 8.767e9, .C4 = .4934, .C5 = 1.3937};
  const auto check = [&](double v, double mu, double p, double U) {
    const auto s = testing::shock(water, v);
    CHECK(s.mu == Approx(mu).epsilon(1e-5));  // half a unit of the last digit printed
    CHECK(s.pressure == Approx(p).epsilon(4e-6));
    CHECK(s.speed == Approx(U).epsilon(4e-6));
    CHECK(s.energy == Approx(0.5 * 1000 * v * v).epsilon(1e-12));  // behind a shock as much heat as motion
  };
  check(100, .061187, 173.434e6, 1734.34);
  check(180.0556, .103517, 345.606e6, 1919.44);
  check(1000, .402972, 3481.56e6, 3481.56);
}

TEST_CASE("polynomial EOS: without energy it is the cubic one") {
  const PolynomialEos a{.density = 938, .C1 = 2.06e9, .C2 = 6.19e9, .C3 = 10.3e9};
  const CubicEos b{.density = 938, .C1 = 2.06e9, .C2 = 6.19e9, .C3 = 10.3e9};
  State state{1e9};
  struct {
  } nothing;
  for (const double J : {0.7, 1.0, 1.3})
    CHECK(advance_pressure(a, state, J, -0.1, 1e8, 1e6) ==
          Approx(advance_pressure(b, nothing, J, -0.1, 1e8, 1e6)).epsilon(1e-14));  // sums in another order
}
