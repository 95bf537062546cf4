#include <cmath>
#include <utility>

#include <strike/material/eos/linear.hpp>
#include <strike/material/failure/tuler_butcher.hpp>
#include <strike/material/plane_stress.hpp>
#include <strike/material/solid.hpp>

#include "support/catch.hpp"

using namespace strike;

TEST_CASE(
    "Tuler-Butcher: the time under a constant stress and the stress at a constant rate, of glass and of a metal") {
  const double E = 72e9, nu = .2, S = 60e6, t0 = 1e-3;
  const LinearEos eos{.density = 2500, .bulk_modulus = E / (3 * (1 - 2 * nu))};
  const ElasticStrength elastic{.shear_modulus = E / (2 * (1 + nu))};
  for (const auto& [s0, k] : {std::pair{0.0, 16.0}, std::pair{30e6, 2.0}}) {
    const PlaneStress sheet{
        Solid{eos, elastic, TulerButcher{.threshold = s0, .strength = S, .duration = t0, .exponent = k}}};
    using State = decltype(sheet)::State<double>;
    const auto pull = [&](State& state, double stress, double dt) {  // by so much along x, and not along y
      const double rate = stress / E / dt;
      sheet.stress(state, {{rate, -nu * rate, 0}}, dt);
    };
    for (const double rate : {1e10, 1e12}) {  // [stress/time]
      const double expected = s0 + std::pow((k + 1) * std::pow(S, k) * t0 * rate, 1 / (k + 1));
      State state;
      double stress = 0, step = 1e-3 * expected;
      for (; state.intact > 0 && stress < 2 * expected; stress += step) pull(state, step, step / rate);
      CHECK(state.intact == 0);
      CHECK(stress == Approx(expected).epsilon(1.5e-3));  // a step, and half of one for the stress of its end
    }
    for (const double share : {.7, 1.0, 1.2}) {
      const double expected = t0 * std::pow(share, -k), dt = 1e-3 * expected;
      State state;
      pull(state, s0 + share * S, 1e-9 * dt);
      double time = 0;
      for (; state.intact > 0 && time < 2 * expected; time += dt) pull(state, 0, dt);
      CHECK(state.intact == 0);
      CHECK(time == Approx(expected).epsilon(1.1e-3));  // a step
    }
    State pressed;
    pull(pressed, -20 * S, t0);
    CHECK(pressed.damage == 0);
  }
}
