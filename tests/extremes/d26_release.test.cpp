// D26: strong release and tension.
#include <cmath>

#include <strike/material/eos/gruneisen.hpp>
#include <strike/material/eos/ideal_gas.hpp>
#include <strike/material/eos/polynomial.hpp>
#include <strike/material/fluid.hpp>
#include <strike/verify/material_point.hpp>

#include "support/catch.hpp"

using namespace strike;
using namespace strike::verify;

namespace {
constexpr PolynomialEos water{
    .density = 1000, .C1 = 2.19e9, .C2 = 9.224e9, .C3 = 8.767e9, .C4 = .4934, .C5 = 1.3937, .pressure_cutoff = -1e5};
}

TEST_CASE("D26: released to mu = -.99 and beyond, the spall pressure is held and the sound speed stays real") {
  MaterialPoint point{Fluid{water}};
  const double least = 1e-6 * 2.19e9;
  point.run(uniaxial_strain({.strain = std::log(150.0), .rate = 1e4, .steps = 400}), [&](const auto& now) {
    CHECK(-now.stress.xx == Approx(-1e5));  // from the first step on
    CHECK(point.moduli().bulk >= least);
    CHECK(std::isfinite(now.state.internal_energy));
  });
  CHECK(1 / point.now().relative_volume() - 1 < -.99);
  // work against the held tension alone
  CHECK(point.now().state.internal_energy == Approx(1e5 * (point.now().relative_volume() - 1)).epsilon(1e-3));

  // and closed again it bears pressure as before, hotter by that work
  point.run(uniaxial_strain({.strain = std::log(0.9 / point.now().relative_volume()), .rate = 1e4, .steps = 4000}));
  const double mu = 1 / point.now().relative_volume() - 1;
  CHECK(-point.now().stress.xx == Approx(water.A(mu) + water.B(mu) * point.now().state.internal_energy).epsilon(1e-12));
}

TEST_CASE("D26: released with much energy it stays real and energy is spent, but for the held tension") {
  for (const double energy : {1e8, 1e10, 1e12}) {
    PolynomialEos hot = water;
    hot.initial_energy = energy;
    MaterialPoint point{Fluid{hot}};
    double last = energy;
    point.run(uniaxial_strain({.strain = std::log(100.0), .rate = 1e4, .steps = 1000}), [&](const auto& now) {
      CHECK(point.moduli().bulk > 0);
      CHECK(-now.stress.xx >= -1e5);
      if (-now.stress.xx > 0) CHECK(now.state.internal_energy < last);
      last = now.state.internal_energy;
    });
    CHECK(last < energy + 1e5 * point.now().relative_volume());
  }
}

TEST_CASE("D26: a step that more than halves the volume of a gas is still answered by a positive pressure") {
  const IdealGas gas{.density = 1, .gamma = 3, .initial_energy = 1};
  EosState<IdealGas, double> state;
  const double p0 = begin_eos(gas, state), p = advance_pressure(gas, state, 0.25, -0.75, p0, 0.0);
  CHECK(1 + 0.5 * gas.B(1 / 0.25 - 1) * -0.75 < 0);  // what stands in the denominator unguarded
  CHECK(p > 0);
  CHECK(std::isfinite(p));
  CHECK(state.internal_energy > 1);
}

TEST_CASE("D26: a vacuum of gas has no pressure, no stiffness and no NaN") {
  const IdealGas gas{.density = 1, .gamma = 1.4, .initial_energy = 1e-30};  // none at all has no step
  MaterialPoint point{Fluid{gas}};
  point.run(uniaxial_strain({.strain = -2, .steps = 10}) + uniaxial_strain({.strain = 4, .steps = 10}));
  CHECK(std::abs(point.now().stress.xx) < 1e-29);
  CHECK(point.moduli().wave() < 1e-29);
}
