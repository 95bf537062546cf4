#include <cmath>
#include <numbers>

#include <strike/material/eos/linear.hpp>
#include <strike/material/failure/johnson_cook_failure.hpp>
#include <strike/material/plane_stress.hpp>
#include <strike/material/solid.hpp>
#include <strike/material/strength/von_mises.hpp>
#include <strike/verify/material_point.hpp>

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

/// The plastic strain that is there when it has failed.
template <class M>
double strain_at_failure(const M& material, const Path& path) {
  MaterialPoint point{material};
  point.run(path);
  REQUIRE(point.now().state.intact == 0);
  return point.now().state.equivalent_plastic_strain;
}

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

TEST_CASE("Johnson-Cook failure: at a constant triaxiality and rate it breaks at that strain, in solids and plates") {
  // perfectly plastic, so that all strain but the first 0.3 % is plastic; a step strains it by a five hundredth
  const Solid solid{eos, perfect, copper};
  for (const double rate : {1.0, 1e4}) {
    const double by_rate = 1 + .014 * std::log(rate), tension = (.54 + 4.89 * std::exp(-1.01)) * by_rate;
    const Path pull = uniaxial_stress({.strain = 1.01 * tension, .rate = rate, .steps = 500});
    CHECK(strain_at_failure(solid, pull) == Approx(tension).epsilon(2.1e-3));
    CHECK(strain_at_failure(PlaneStress{solid}, pull) == Approx(tension).epsilon(2.1e-3));
    const Path shear =
        simple_shear({.strain = 1.01 * 5.43 * by_rate * std::numbers::sqrt3, .rate = rate, .steps = 5000});
    const double slower = by_rate + .014 * std::log(1 / std::numbers::sqrt3) * (rate > 1);  // of gamma/sqrt 3
    CHECK(strain_at_failure(solid, shear) == Approx(5.43 * slower).epsilon(4e-4));
  }
  MaterialPoint pressed{solid};
  pressed.run(uniaxial_strain({.strain = -2, .steps = 100}));  // under high pressure it holds
  CHECK(pressed.now().state.intact == 1);
  CHECK(pressed.now().state.damage < 1e-3);
}

TEST_CASE("Johnson-Cook failure: damage of several rates adds up, and heat delays it") {
  MaterialPoint point{Solid{eos, perfect, copper}};
  const double slow = .54 + 4.89 * std::exp(-1.01), fast = slow * (1 + .014 * std::log(1e4));
  point.run(uniaxial_stress({.strain = .5 * slow, .rate = 1, .steps = 500}));
  CHECK(point.now().state.damage == Approx(.5).epsilon(6e-3));  // the elastic strain
  const double before = point.now().state.damage, strain = point.now().state.equivalent_plastic_strain;
  point.run(uniaxial_stress({.strain = .25 * fast, .rate = 1e4, .steps = 500}));
  CHECK(point.now().state.damage - before ==
        Approx((point.now().state.equivalent_plastic_strain - strain) / fast).epsilon(1e-6));

  struct {
    double damage = 0, temperature_rise = 531;
    SymmetricTensor<double> stress{.xx = 3e8};
  } hot;
  copper.accumulate(hot, 3e8, .1, .1);
  CHECK(hot.damage == Approx(.1 / (slow * 1.56)).epsilon(1e-14));
}
