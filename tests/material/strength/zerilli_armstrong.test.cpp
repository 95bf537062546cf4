#include <cmath>

#include <strike/material/strength/strength.hpp>
#include <strike/material/strength/zerilli_armstrong.hpp>

#include "support/catch.hpp"

using namespace strike;

static_assert(ThermalFlow<ZerilliArmstrong>);

namespace {

/// Zerilli and Armstrong (1987), table I.
constexpr ZerilliArmstrong copper{
    .shear_modulus = 46e9, .C0 = 65e6, .C2 = 890e6, .C3 = .0028, .C4 = .000115, .heating = 0.9 / (8960 * 383)};
constexpr ZerilliArmstrong iron{.shear_modulus = 80e9,
                                .C0 = 65e6,
                                .C1 = 1033e6,
                                .C3 = .00698,
                                .C4 = .000415,
                                .C5 = 266e6,
                                .n = .289,
                                .heating = 0.9 / (7870 * 452)};

}  // namespace

TEST_CASE("Zerilli-Armstrong: the formulas of both lattices, and their limits") {
  for (const double T : {100.0, 294.0, 600.0})
    for (const double r : {1e-3, 1.0, 1e5})
      for (const double e : {0.0, .1, 1.0}) {
        const double fcc = 65e6 + 890e6 * std::sqrt(e) * std::exp(-.0028 * T + .000115 * T * std::log(r));
        const double bcc =
            65e6 + 1033e6 * std::exp(-.00698 * T + .000415 * T * std::log(r)) + 266e6 * std::pow(e, .289);
        CHECK(copper.flow_stress(e, r, T) == Approx(fcc).epsilon(1e-14));
        CHECK(iron.flow_stress(e, r, T) == Approx(bcc).epsilon(1e-14));
      }
  CHECK(copper.flow_stress(0.0, 1e6, 294.0) == 65e6);       // an annealed fcc yields at any rate as it does slowly
  CHECK(iron.flow_stress(0.0, 1e3, 0.0) == 65e6 + 1033e6);  // no activation without heat
  CHECK(iron.flow_stress(0.0, 0.0, 294.0) == Approx(65e6).epsilon(1e-12));  // nor any barrier without haste
  CHECK(iron.flow_stress(0.0, 1e300, 294.0) > iron.flow_stress(0.0, 1e6, 294.0));
  const ZerilliArmstrong athermal{.shear_modulus = 1, .C0 = 2, .C1 = 3, .C3 = 0, .C4 = 0};
  CHECK(athermal.flow_stress(1.0, 0.0, 300.0) == 5);
}

TEST_CASE("Zerilli-Armstrong: each step ends on the formula, at its own rate and the temperature of its start") {
  for (const ZerilliArmstrong& law : {copper, iron})
    for (const double dt : {1e-9, 1e-3, 1e3}) {
      StrengthState<ZerilliArmstrong, double> state;
      SymmetricTensor<double> s;
      for (int i = 0; i < 200; ++i) {
        const auto before = state;
        s = advance_deviator(law, state, s, SymmetricTensor<double>{.xy = 1e-3}, dt);
        const double dl = state.equivalent_plastic_strain - before.equivalent_plastic_strain;
        if (dl < 1e-6) continue;  // dl is a difference of strains: 1e-16/dl of it
        const double T = 293 + before.temperature_rise;
        const double sigma = law.flow_stress(state.equivalent_plastic_strain, dl / dt, T);
        CHECK(equivalent_stress(s) == Approx(sigma).epsilon(1e-9));
        CHECK(state.temperature_rise - before.temperature_rise == Approx(law.heating * sigma * dl).epsilon(1e-8));
      }
      CHECK(state.equivalent_plastic_strain > .1);
    }
}
