#include <cmath>

#include <strike/material/strength/johnson_cook.hpp>
#include <strike/material/strength/strength.hpp>

#include "support/catch.hpp"

using namespace strike;
using State = StrengthState<JohnsonCook, double>;
using Tensor = SymmetricTensor<double>;

static_assert(FlowLaw<JohnsonCook> && ThermalFlow<JohnsonCook> && !RateDependentFlow<JohnsonCook>);

namespace {

/// OFHC copper of Johnson and Cook (1983).
constexpr JohnsonCook copper{.shear_modulus = 46e9,
                             .A = 90e6,
                             .B = 292e6,
                             .n = .31,
                             .C = .025,
                             .reference_rate = 1,
                             .m = 1.09,
                             .initial_temperature = 294,
                             .melting_temperature = 1356,
                             .heating = 0.9 / (8960 * 383)};

}  // namespace

TEST_CASE("Johnson-Cook: the formula") {
  CHECK(copper.flow_stress(0.0, 0.0, 294.0) == 90e6);
  CHECK(copper.flow_stress(1.0, 1.0, 294.0) == Approx(382e6).epsilon(1e-15));
  CHECK(copper.flow_stress(1.0, 1e-9, 200.0) == Approx(382e6).epsilon(1e-15));  // slow and cold change nothing
  CHECK(copper.flow_stress(1.0, std::exp(4), 294.0) == Approx(382e6 * 1.1).epsilon(1e-14));
  CHECK(copper.flow_stress(0.2, 1e4, 600.0) == Approx((90e6 + 292e6 * std::pow(.2, .31)) * (1 + .025 * std::log(1e4)) *
                                                      (1 - std::pow((600. - 294) / (1356 - 294), 1.09)))
                                                   .epsilon(1e-14));
  CHECK(copper.flow_stress(1.0, 1e4, 1356.0) == 0);
  CHECK(copper.flow_stress(1.0, 1e4, 5000.0) == 0);
}

TEST_CASE("Johnson-Cook: each step ends on the formula, at its own rate and the temperature of its start") {
  State state;
  Tensor s;
  const double dt = 1e-8, gamma_rate = 1e5;
  for (int i = 0; i < 1000; ++i) {
    const State before = state;
    s = advance_deviator(copper, state, s, {.xy = 0.5 * gamma_rate * dt}, dt);
    const double dl = state.equivalent_plastic_strain - before.equivalent_plastic_strain;
    if (dl == 0) continue;
    const double sigma = copper.flow_stress(state.equivalent_plastic_strain, dl / dt, 294 + before.temperature_rise);
    CHECK(equivalent_stress(s) == Approx(sigma).epsilon(1e-10));  // dl is a difference of strains: 1e-16/dl of it
    CHECK(state.temperature_rise - before.temperature_rise == Approx(copper.heating * sigma * dl).epsilon(1e-9));
  }
  CHECK(state.equivalent_plastic_strain > 0.5);
}

TEST_CASE("Johnson-Cook: adiabatic shear of sigma = A (1 - T*) decays as exp(-e A heating/(Tm - T0))") {
  // d sigma/de = -A/(Tm - T0) dT/de and dT/de = heating sigma
  JohnsonCook law{.shear_modulus = 1e12, .A = 1e9, .B = 0, .n = 1};
  law.initial_temperature = 300, law.melting_temperature = 1300, law.heating = 1e-6;
  State state;
  Tensor s;
  for (int i = 0; i < 4000; ++i) s = advance_deviator(law, state, s, {.xy = 1e-3}, 1e-6);
  const double e = state.equivalent_plastic_strain, decay = 1e9 * 1e-6 / 1000;
  REQUIRE(e * decay > 2);
  // the temperature lags a step behind: de decay = 1.2e-3 of a change of e decay, half on average
  CHECK(equivalent_stress(s) == Approx(1e9 * std::exp(-e * decay)).epsilon(2e-3));
  CHECK(state.temperature_rise == Approx(1000 * (1 - std::exp(-e * decay))).epsilon(1e-3));
}

TEST_CASE("Johnson-Cook: below the reference rate it is rate-independent, and pow(e, n) starts with infinite slope") {
  State state;
  const double G3 = 3 * copper.shear_modulus;
  for (const double excess : {1e-12, 1e-6, 1e-3, 1.0, 100.0}) {
    const double q = 90e6 * (1 + excess), dl = plastic_increment<JohnsonCook, double>(copper, state, q, 1e6);
    CHECK(std::abs(q - G3 * dl - (90e6 + 292e6 * std::pow(dl, .31))) < 1e-13 * q);
    CHECK(dl > 0);
  }
}
