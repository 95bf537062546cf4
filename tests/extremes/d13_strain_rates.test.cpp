// D13: strain rates of 0, 1e-300 ... 1e12 in the whole material, Cowper-Symonds and power laws, in every number.
#include <cmath>
#include <vector>

#include <strike/material/eos/linear.hpp>
#include <strike/material/plane_stress.hpp>
#include <strike/material/solid.hpp>
#include <strike/material/strength/johnson_cook.hpp>
#include <strike/material/strength/rate_von_mises.hpp>
#include <strike/material/zero_normal_stress.hpp>
#include <strike/scalar/pack.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {

constexpr double G = 80e9, Y = 300e6;

/// Three steps of a plane strain at every rate: finite, on the surface of the law at the rate of the last step.
template <class T, class M, class Law>
void check_plane_rates(const M& material, const Law& law, double rounding) {
  std::vector<double> rates{0, 1e-300};
  for (int decade = -12; decade <= 12; decade += 2) rates.push_back(std::pow(10, decade));
  for (const double rate : rates)
    for (const double step_strain : {1e-6, 1e-3, 1e-1})
      for (const double across : {-1.0, -0.5, 0.3, 1.0}) {
        const double dt = rate > 1e-30 ? step_strain / rate : 1;
        typename M::template State<T> state;
        if constexpr (requires { material.begin(state); }) material.begin(state);
        for (int i = 0; i < 3; ++i) {
          const T before = state.equivalent_plastic_strain;
          const T D = T(static_cast<RealOf<T>>(rate)) * T(0.5);
          const auto sigma = material.stress(state, {{D, across * D, 0.3 * D}}, dt);
          const PlaneTensor<double> s{double(lane(sigma.xx, 0)), double(lane(sigma.yy, 0)), double(lane(sigma.xy, 0))};
          const double q = equivalent_stress(s), e = double(lane(state.equivalent_plastic_strain, 0)),
                       dl = e - double(lane(before, 0));
          CAPTURE(rate, dt, across, i, q, e);
          REQUIRE(std::isfinite(q));
          REQUIRE(dl >= 0);
          if (rate < 1e-30) REQUIRE(q == 0);
          if (dl > 1e4 * rounding * e) {  // the rate is then known to 1e-4
            double sigma_y = 0;
            if constexpr (ThermalFlow<Law>)
              sigma_y = law.flow_stress(e, dl / dt, law.initial_temperature);
            else
              sigma_y = law.flow_stress(e, dl / dt);
            CHECK(std::abs(q - sigma_y) < (1e-4 + 100 * rounding * 2 * G * step_strain / sigma_y) * sigma_y);
          }
        }
      }
}

template <class T>
void check_rates(double rate_factor, double exponent, double H, double rounding) {
  const RateVonMises law{.shear_modulus = G,
                         .yield_stress = Y,
                         .hardening_modulus = H,
                         .rate_factor = rate_factor,
                         .rate_exponent = exponent};
  const Solid steel{LinearEos{.density = 7850, .bulk_modulus = 160e9}, law};
  std::vector<double> rates{0, 1e-300};
  for (int decade = -12; decade <= 12; decade += 2) rates.push_back(std::pow(10, decade));
  for (const double rate : rates)
    for (const double step_strain : {1e-6, 1e-3, 1e-1}) {
      const double dt = rate > 1e-30 ? step_strain / rate : 1;
      typename decltype(steel)::template State<T> state;
      for (int i = 0; i < 20; ++i) {
        const T before = state.equivalent_plastic_strain;
        const T D = T(static_cast<RealOf<T>>(rate)) * T(0.5);
        steel.stress(state, {{.xx = D, .yy = -D, .xy = 2.0 * D}, T(1.0)}, dt);
        const double q = double(lane(equivalent_stress(deviator(state.stress)), 0)),
                     e = double(lane(state.equivalent_plastic_strain, 0)), dl = e - double(lane(before, 0));
        CAPTURE(rate, dt, i, q, e);
        REQUIRE(std::isfinite(q));
        REQUIRE(dl >= 0);
        if (rate < 1e-30) REQUIRE(q == 0);
        if (dl > 1e4 * rounding * e) {  // the rate is then known to 1e-4
          const double sigma = law.flow_stress(e, dl / dt);
          CHECK(std::abs(q - sigma) < (1e-4 * exponent + 100 * rounding) * sigma);
        }
      }
    }
}

}  // namespace

TEST_CASE("D13: Cowper-Symonds steel and aluminium, D 40.4 p 5 and D 6500 p 4, over all rates") {
  for (const double H : {0.0, 1e9}) {
    check_rates<double>(std::pow(40.4, -0.2), 0.2, H, 2.3e-16);
    check_rates<double>(std::pow(6500, -0.25), 0.25, H, 2.3e-16);
    check_rates<Pack<double, 8>>(std::pow(40.4, -0.2), 0.2, H, 2.3e-16);
    check_rates<Pack<float, 16>>(std::pow(40.4, -0.2), 0.2, H, 1.2e-7);
  }
}

TEST_CASE("D13: power laws with exponents 1 and 1.5 over all rates") {
  check_rates<double>(1e-6, 1, 1e9, 2.3e-16);
  check_rates<double>(1e-9, 1.5, 1e9, 2.3e-16);
  check_rates<Pack<float, 16>>(1e-6, 1, 1e9, 1.2e-7);
}

TEST_CASE("D13: the factor at 1e12 is 120.874, at 0 and 1e-300 it is 1, and the residual is below 1e-10 Y") {
  const RateVonMises steel{
      .shear_modulus = G, .yield_stress = Y, .rate_factor = std::pow(40.4, -0.2), .rate_exponent = 0.2};
  CHECK(steel.flow_stress(0.0, 0.0) == Y);
  CHECK(steel.flow_stress(0.0, 1e-300) == Y);
  CHECK(steel.flow_stress(0.0, 1e12) / Y == Approx(120.874).epsilon(4e-6));
  for (const double q : {1.0001 * Y, 2 * Y, 100 * Y, 125 * Y, 1000 * Y})
    for (const double dt : {1e-280, 1e-15, 1e-9, 1e-3, 1e3, 1e300}) {
      const double dl = steel.plastic_increment(q, 0.0, dt);
      REQUIRE(std::isfinite(dl));
      const double residual = q - 3 * G * dl - steel.flow_stress(dl, dl / dt);
      if (dl > 0) CHECK(std::abs(residual) < 1e-10 * Y);
    }
}

TEST_CASE("D13: all rates in plane stress, in closed form and by the strain across") {
  const LinearEos linear{.density = 7850, .bulk_modulus = 160e9};
  const auto check = [&](const auto& law) {
    check_plane_rates<double>(PlaneStress{Solid{linear, law}}, law, 2.3e-16);
    check_plane_rates<Pack<double, 8>>(PlaneStress{Solid{linear, law}}, law, 2.3e-16);
    check_plane_rates<Pack<float, 16>>(PlaneStress{Solid{linear, law}}, law, 1.2e-7);
    check_plane_rates<double>(ZeroNormalStress{Solid{linear, law}}, law, 64 * 2.3e-16);
  };
  for (const double H : {0.0, 1e9}) {
    check(RateVonMises{G, Y, H, std::pow(40.4, -0.2), 0.2});
    check(RateVonMises{G, Y, H, 1e-6, 1});
    check(RateVonMises{G, Y, H, 1e-9, 1.5});
  }
  check(JohnsonCook{.shear_modulus = G, .A = Y, .B = 500e6, .n = 0.3, .C = 0.02});
}
