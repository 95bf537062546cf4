#include <cmath>

#include <strike/material/eos/linear.hpp>
#include <strike/material/solid.hpp>
#include <strike/material/strength/power_hardening.hpp>
#include <strike/material/strength/strength.hpp>
#include <strike/verify/material_point.hpp>

#include "support/catch.hpp"

using namespace strike;

static_assert(RateIndependentFlow<PowerHardening>);

TEST_CASE("power hardening: the formula, and a tension test to the strain at which its force is largest") {
  // mild steel; force/area0 = sigma exp(-e) is largest at d sigma/de = sigma, e = n - e0 (Considere 1885)
  const double K = 600e6, n = .2, e0 = .01, G = 80e9, B = 170e9, E = 9 * B * G / (3 * B + G);
  const PowerHardening steel{.shear_modulus = G, .coefficient = K, .exponent = n, .initial_strain = e0};
  CHECK(steel.flow_stress(0.0) == Approx(K * std::pow(e0, n)).epsilon(1e-15));
  CHECK(steel.flow_stress(.99) == Approx(K).epsilon(1e-15));

  MaterialPoint point{Solid{LinearEos{.density = 1, .bulk_modulus = B}, steel}};
  double largest = 0, there = 0;
  point.run(uniaxial_stress({.strain = .4, .steps = 400}), [&](const auto& now) {
    const double e = now.state.equivalent_plastic_strain, strain = now.strain().xx, sigma = now.stress.xx;
    if (e > 0) CHECK(sigma == Approx(K * std::pow(e0 + e, n)).epsilon(1e-10));
    CHECK(strain == Approx(e + sigma / E).epsilon(1e-4));  // p is not linear in ln J, by 1e-3 of the elastic part
    if (sigma * std::exp(-strain) > largest) largest = sigma * std::exp(-strain), there = e;
  });
  CHECK(there == Approx(n - e0).margin(2e-3));  // two steps; the elastic strain too is of that size
}
