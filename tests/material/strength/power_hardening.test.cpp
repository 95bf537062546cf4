#include <cmath>

#include <strike/material/strength/power_hardening.hpp>
#include <strike/material/strength/strength.hpp>

#include "support/catch.hpp"

using namespace strike;

static_assert(RateIndependentFlow<PowerHardening>);

TEST_CASE("power hardening: the formula, and a tension test to the strain at which its force is largest") {
  const double K = 600e6, n = .2, e0 = .01, G = 80e9;
  const PowerHardening steel{.shear_modulus = G, .coefficient = K, .exponent = n, .initial_strain = e0};
  CHECK(steel.flow_stress(0.0) == Approx(K * std::pow(e0, n)).epsilon(1e-15));
  CHECK(steel.flow_stress(.99) == Approx(K).epsilon(1e-15));

  // pulled without change of volume, sigma = 3/2 s_xx; the force on the first area is sigma exp(-strain), largest where
  // d sigma/d strain = sigma (Considere 1885), at e = n - e0 but for the elastic strain
  StrengthState<PowerHardening, double> state;
  SymmetricTensor<double> s;
  const double step = 1e-3;
  double largest = 0, there = 0;
  for (int i = 1; i <= 400; ++i) {
    s = advance_deviator(steel, state, s, SymmetricTensor<double>{step, -.5 * step, -.5 * step}, 1.0);
    const double e = state.equivalent_plastic_strain, sigma = 1.5 * s.xx, strain = i * step;
    if (e > 0) CHECK(sigma == Approx(K * std::pow(e0 + e, n)).epsilon(1e-13));
    CHECK(strain == Approx(e + sigma / (3 * G)).epsilon(1e-13));
    if (sigma * std::exp(-strain) > largest) largest = sigma * std::exp(-strain), there = e;
  }
  CHECK(there == Approx(n - e0).margin(2 * step));
}
