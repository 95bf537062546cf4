// D24 at one point: rates near the least number, and all stresses scaled by 1e-30. (What it costs: bench/material.)
// D25 at one point: stresses scaled by 1e30.
#include <cmath>
#include <vector>

#include <strike/material.hpp>
#include <strike/verify/material_point.hpp>

#include "support/catch.hpp"

using namespace strike;
using namespace strike::verify;

namespace {

/// The materials of this test with every stress and density times `scale`.
template <class F>
void each_material(double scale, F f) {
  const LinearEos linear{.density = 8930 * scale, .bulk_modulus = 130e9 * scale};
  const double G = 43.3e9 * scale, Y = 400e6 * scale;
  f(Elastic{.density = 8930 * scale, .youngs_modulus = 117e9 * scale, .poissons_ratio = .35});
  f(Solid{linear, VonMises{.shear_modulus = G, .yield_stress = Y, .hardening_modulus = 0.1 * Y}});
  f(Solid{linear, RateVonMises{.shear_modulus = G, .yield_stress = Y, .rate_factor = .1, .rate_exponent = .25}});
  f(Solid{GruneisenEos{.density = 8930 * scale, .sound_speed = 3940, .S1 = 1.489, .gamma = 1.99},
          JohnsonCook{.shear_modulus = G,
                      .A = 90e6 * scale,
                      .B = 292e6 * scale,
                      .n = .31,
                      .C = .025,
                      .m = 1.09,
                      .initial_temperature = 294,
                      .melting_temperature = 1356,
                      .heating = 2.6e-7 / scale},
          UltimateStress{.ultimate_stress = 1e99 * scale}});
  f(Fluid{PolynomialEos{.density = 1000 * scale,
                        .C1 = 2.19e9 * scale,
                        .C2 = 9.224e9 * scale,
                        .C3 = 8.767e9 * scale,
                        .C4 = .4934,
                        .C5 = 1.3937},
          Newtonian{.viscosity = 1e-3 * scale}});
  f(Fluid{IdealGas{.density = 1.2 * scale, .gamma = 1.4, .initial_energy = 2.5e5 * scale}});
}

template <class M>
SymmetricTensor<double> after_a_path(const M& material) {
  MaterialPoint point{material};
  const double rate = 1e4;
  point.run(uniaxial_strain({.strain = -0.1, .rate = rate}) + simple_shear({.strain = 0.5, .rate = rate}) +
                hydrostatic({.strain = 0.2, .rate = rate}),
            [](const auto&) {});
  return point.now().stress;
}

}  // namespace

TEST_CASE("D24: rates of strain near the least number leave nothing, in double and in lanes") {
  each_material(1, [](const auto& material) {
    using M = std::remove_cvref_t<decltype(material)>;
    const auto check = [&](auto zero) {
      using T = decltype(zero);
      typename M::template State<T> state;
      if constexpr (requires { material.begin(state); }) material.begin(state);
      const T still = material.stress(std::as_const(state)).xx;
      const T tiny = T(std::numeric_limits<RealOf<T>>::denorm_min()) * T(3.0);
      for (int i = 0; i < 1000; ++i) {
        const auto sigma = material.stress(state, {{tiny, -tiny, tiny, tiny, -tiny, tiny}, T(1.0)}, 1e-6);
        const double change = std::abs(double(lane(sigma.xx, 0)) - double(lane(still, 0)));
        REQUIRE(change <= 1e-12 * std::abs(double(lane(still, 0))) + 1e-30);
        REQUIRE(std::abs(double(lane(sigma.xy, 0))) < 1e-30);
      }
    };
    check(double{});
    check(Pack<double, 8>{});
    check(Pack<float, 16>{});
  });
}

TEST_CASE("D24, D25: stresses scaled by 1e-30 and 1e30 give the same dimensionless answers") {
  std::vector<SymmetricTensor<double>> plain;
  each_material(1, [&](const auto& material) { plain.push_back(after_a_path(material)); });
  for (const double scale : {1e-30, 1e30}) {
    std::size_t i = 0;
    each_material(scale, [&](const auto& material) {
      CAPTURE(scale, i);
      const auto sigma = (1 / scale) * after_a_path(material);
      CHECK((sigma - plain[i]).matrix().norm() < 1e-10 * plain[i].matrix().norm());  // 300 steps of rounding
      ++i;
    });
  }
}
