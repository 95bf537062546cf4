#include <strike/material/eos/eos.hpp>
#include <strike/material/eos/ideal_gas.hpp>
#include <strike/material/eos/polynomial.hpp>
#include <strike/material/fluid.hpp>
#include <strike/verify/material_point.hpp>

#include "support/catch.hpp"
#include "support/shock.hpp"

using namespace strike;
using namespace strike::verify;

static_assert(ThermalEquationOfState<IdealGas>);

namespace {
constexpr double p0 = 1e5, heats = 1.4;
constexpr IdealGas air{.density = 1.2, .gamma = heats, .initial_energy = p0 / (heats - 1)};
}  // namespace

TEST_CASE("ideal gas: begins at p0, and rho c^2 is gamma p") {
  EosState<IdealGas, double> state;
  CHECK(begin_eos(air, state) == Approx(p0).epsilon(1e-15));
  for (const double J : {0.1, 1.0, 10.0}) {
    state.internal_energy = 3 * p0;
    const double p = (heats - 1) * 3 * p0 / J;
    CHECK(bulk_modulus(air, state, J, p) == Approx(heats * p).epsilon(1e-14));
    CHECK(bulk_modulus(air, state, J, p) == Approx(testing::isentropic_bulk_modulus(air, J, 3 * p0)).epsilon(1e-8));
  }
}

TEST_CASE("ideal gas: isentropic compression to half the volume, p/p0 = 2^gamma = 2.639016") {
  MaterialPoint point{Fluid{air}};
  point.run(uniaxial_strain({.strain = std::log(0.5), .steps = 1000}));
  const auto& end = point.now();
  // the trapezoidal energy errs by (ln 2/1000)^2, the strain by a twelfth of that
  CHECK(-end.stress.xx / p0 == Approx(2.639016).epsilon(1e-6));
  CHECK(end.relative_volume() == Approx(0.5).epsilon(1e-7));
  // the heat of the gas is the work done on it
  CHECK(end.state.internal_energy - air.initial_energy == Approx(end.work).epsilon(1e-12));
}

TEST_CASE("ideal gas: a strong shock compresses it (gamma + 1)/(gamma - 1) times, however strong") {
  const double mu = 2 / (heats - 1), E = 7;  // E = p mu/(2 (1 + mu)) and p = B E hold at this mu for every E
  CHECK(air.B(mu) * E * mu / (2 * (1 + mu)) == Approx(E).epsilon(1e-14));
}

TEST_CASE("ideal gas: it is the polynomial with C4 = C5 = gamma - 1") {
  const PolynomialEos polynomial{
      .density = 1.2, .C4 = heats - 1, .C5 = heats - 1, .initial_energy = air.initial_energy};
  MaterialPoint a{Fluid{air}};
  MaterialPoint b{Fluid{polynomial}};
  const Path path = cyclic(uniaxial_strain({.strain = -1, .steps = 10}));
  a.run(path), b.run(path);
  CHECK(a.now().stress.xx == Approx(b.now().stress.xx).epsilon(1e-14));
}
