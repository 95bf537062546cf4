#include <cmath>

#include <strike/material/eos/linear.hpp>
#include <strike/material/failure/johnson_cook_failure.hpp>
#include <strike/material/solid.hpp>
#include <strike/material/strength/von_mises.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {

/// OFHC copper and Armco iron of Johnson and Cook (1985).
constexpr JohnsonCookFailure copper{.D1 = .54,
                                    .D2 = 4.89,
                                    .D3 = -3.03,
                                    .D4 = .014,
                                    .D5 = 1.12,
                                    .initial_temperature = 294,
                                    .melting_temperature = 1356};
constexpr JohnsonCookFailure iron{.D1 = -2.2, .D2 = 5.43, .D3 = -.47, .D4 = .016, .D5 = .63};

constexpr LinearEos eos{.density = 8930, .bulk_modulus = 130e9};
constexpr VonMises perfect{.shear_modulus = 43.3e9, .yield_stress = 400e6};

/// A point that is stretched at the rate of deformation diag(1, -1/2, -1/2) r under a mean stress of `triaxiality`
/// times its yield stress, which its volume makes.
struct Point {
  double triaxiality;
  Solid<LinearEos, VonMises, JohnsonCookFailure> solid{eos, perfect, copper};
  decltype(solid)::State<double> state{};

  void stretch(double strain, double rate) {
    const double J = 1 / (1 - triaxiality * perfect.yield_stress / eos.bulk_modulus);
    solid.stress(state, {{rate, -.5 * rate, -.5 * rate}, J}, strain / rate);
  }
};

}  // namespace

TEST_CASE("Johnson-Cook failure: the strain at fracture") {
  CHECK(copper.strain_at_fracture(0.0, 1.0, 0.0) == Approx(5.43).epsilon(1e-15));
  CHECK(copper.strain_at_fracture(1 / 3., std::exp(10), 531.0) ==
        Approx((.54 + 4.89 * std::exp(-1.01)) * 1.14 * 1.56).epsilon(1e-14));
  CHECK(copper.strain_at_fracture(2.0, 1e-3, 0.0) == Approx(.54 + 4.89 * std::exp(-4.545)).epsilon(1e-14));
  CHECK(copper.strain_at_fracture(-1e300, 1.0, 0.0) > 1e30);
  CHECK(iron.strain_at_fracture(1.5, 1.0, 0.0) == Approx(-2.2 + 5.43 * std::exp(-.705)).epsilon(1e-13));
  JohnsonCookFailure brittle = iron;
  brittle.D2 = 2.2;
  CHECK(brittle.strain_at_fracture(.5, 1.0, 0.0) == 1e-6);
}

TEST_CASE(
    "Johnson-Cook failure: at a constant triaxiality and rate it breaks at that strain, in the step that reaches it") {
  const double step = 1e-3;
  for (const double triaxiality : {-.3, 0.0, 1 / 3., 1.2})
    for (const double rate : {1.0, 1e4}) {
      const double at_fracture = (.54 + 4.89 * std::exp(-3.03 * triaxiality)) * (1 + .014 * std::log(rate));
      Point point{triaxiality};
      while (point.state.equivalent_plastic_strain == 0) point.stretch(step, rate);
      while (point.state.intact == 1 && point.state.equivalent_plastic_strain < 2 * at_fracture) {
        CHECK(trace(point.state.stress) / 3 == Approx(triaxiality * 400e6).margin(1.0));
        CHECK(point.state.equivalent_plastic_strain < at_fracture * (1 + 1e-9));
        point.stretch(step, rate);
      }
      CHECK(point.state.intact == 0);
      // in the step in which it yielded it flowed more slowly
      CHECK(point.state.equivalent_plastic_strain == Approx(at_fracture).margin(1.01 * step));
    }
  Point pressed{-10};
  for (int i = 0; i < 2000; ++i) pressed.stretch(.01, 1);  // under ten times the yield stress it holds
  CHECK(pressed.state.intact == 1);
}

TEST_CASE("Johnson-Cook failure: damage of several rates adds up, and heat delays it") {
  Point point{1 / 3.};
  const double slow = .54 + 4.89 * std::exp(-1.01), fast = slow * (1 + .014 * std::log(1e4));
  for (int i = 0; i < 10; ++i) point.stretch(.01, 1);
  const auto before = point.state;
  for (int i = 0; i < 40; ++i) point.stretch(.01, 1);
  for (int i = 0; i < 30; ++i) point.stretch(.01, 1e4);
  CHECK(point.state.damage - before.damage == Approx(.4 / slow + .3 / fast).epsilon(1e-12));

  struct {
    double damage = 0, temperature_rise = 531;
    SymmetricTensor<double> stress{.xx = 3e8};
  } hot;
  copper.accumulate(hot, 3e8, .1, .1);
  CHECK(hot.damage == Approx(.1 / (slow * 1.56)).epsilon(1e-14));
}
