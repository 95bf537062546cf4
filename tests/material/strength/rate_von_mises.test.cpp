#include <cmath>
#include <vector>

#include <strike/material/strength/rate_von_mises.hpp>
#include <strike/material/strength/strength.hpp>

#include "support/catch.hpp"

using namespace strike;

static_assert(FlowLaw<RateVonMises> && RateDependentFlow<RateVonMises> && !RateIndependentFlow<RateVonMises>);

namespace {

constexpr double G = 80e9, Y = 300e6;

/// Cowper and Symonds: 1 + (r/D)^(1/p).
RateVonMises cowper_symonds(double D, double p, double H = 0) {
  return {.shear_modulus = G,
          .yield_stress = Y,
          .hardening_modulus = H,
          .rate_factor = std::pow(D, -1 / p),
          .rate_exponent = 1 / p};
}

/// Makes the trial stress whose exact answer is the plastic increment r dt, and asks for it. The stress must be exact
/// to 16 roundings, the increment to what they are over the slope of the residual, which is at least 3 G.
void check_exact(const RateVonMises& law, double e, double rate, double dt) {
  CAPTURE(law.rate_exponent, law.hardening_modulus, e, rate, dt);
  const double dl = rate * dt,
               sigma =
                   (Y + law.hardening_modulus * (e + dl)) * (1 + law.rate_factor * std::pow(rate, law.rate_exponent)),
               q = sigma + 3 * G * dl, found = law.plastic_increment(q, e, dt);
  CHECK(std::isfinite(found));
  CHECK(found >= 0);
  CHECK(std::abs(found - dl) <= 32 * 2.3e-16 * q / (3 * G));
  const double residual = q - 3 * G * found - law.flow_stress(e + found, found / dt);
  CHECK(std::abs(residual) < 1e-10 * Y + 32 * 2.3e-16 * q);
}

}  // namespace

TEST_CASE("rate von Mises: Cowper-Symonds factors") {
  const RateVonMises steel = cowper_symonds(40.4, 5);
  CHECK(steel.flow_stress(0.0, 0.0) == Y);
  CHECK(steel.flow_stress(0.0, 1e-300) == Y);
  CHECK(steel.flow_stress(0.0, 40.4) == Approx(2 * Y).epsilon(1e-14));
  CHECK(steel.flow_stress(0.0, 1e12) / Y == Approx(120.874).epsilon(4e-6));  // six digits printed
}

TEST_CASE("rate von Mises: the increment is the exact one over all rates, exponents and hardening") {
  std::vector<double> rates{0, 1e-300};
  for (int decade = -30; decade <= 12; ++decade) rates.push_back(std::pow(10, decade));
  for (const double H : {0.0, 100e6, 20e9})
    for (const double e : {0.0, 0.3})
      for (const double dt : {1e-12, 1e-7, 1e-3})
        for (const double rate : rates) {
          if (rate * dt > 10) continue;
          check_exact(cowper_symonds(40.4, 5, H), e, rate, dt);       // n < 1
          check_exact(cowper_symonds(6500, 4, H), e, rate, dt);       // n < 1
          check_exact(cowper_symonds(1e4, 1, H), e, rate, dt);        // n = 1
          check_exact(cowper_symonds(1e6, 1 / 1.7, H), e, rate, dt);  // n > 1
          check_exact(cowper_symonds(1e3, 20, H), e, rate, dt);       // n << 1
        }
}

TEST_CASE("rate von Mises: no effect of the rate without a factor, and none in a step without time") {
  RateVonMises law = cowper_symonds(40.4, 5, 1e9);
  const double q = 500e6, static_increment = (q - Y) / (3 * G + 1e9);
  CHECK(law.plastic_increment(q, 0.0, 0.0) == Approx(static_increment).epsilon(1e-15));
  law.rate_factor = 0;
  CHECK(law.plastic_increment(q, 0.0, 1e-7) == Approx(static_increment).epsilon(1e-15));
  CHECK(law.plastic_increment(Y, 0.0, 1e-7) == 0);
}

TEST_CASE("rate von Mises: the hardening is scaled by the rate too") {
  // sigma = (Y + H e) (1 + C r^n). Without hardening it is the additive law Y + C' r^n with C' = Y C.
  const RateVonMises law = cowper_symonds(40.4, 5, 1e9);
  const double factor = law.flow_stress(0.0, 1e3) / Y, additive = Y * law.rate_factor * std::pow(1e3, 0.2);
  CHECK(law.flow_stress(0.0, 1e3) == Approx(Y + additive).epsilon(1e-14));
  CHECK(law.flow_stress(0.5, 1e3) - law.flow_stress(0.0, 1e3) == Approx(0.5 * 1e9 * factor).epsilon(1e-14));
}

TEST_CASE("rate von Mises: lanes whose rates differ by hundreds of decades, in double and float") {
  const RateVonMises law = cowper_symonds(40.4, 5, 1e8);
  const auto check = [&](auto pack, double rounding) {
    using P = decltype(pack);
    const double dt = 1e-9;
    const P q = P::generate([](std::size_t i) { return Y * (1 + (i == 0 ? -0.5 : std::pow(10, 2 - 2. * double(i)))); });
    const P dl = law.plastic_increment(q, P(0.01), dt);
    for (std::size_t i = 0; i < lanes<P>; ++i) {
      CAPTURE(i);
      const double alone = law.plastic_increment(double(q[i]), 0.01, dt);
      CHECK(std::abs(dl[i] - alone) <= rounding * double(q[i]) / (3 * G));
    }
  };
  check(Pack<double, 8>{}, 32 * 2.3e-16);
  check(Pack<float, 8>{}, 32 * 1.2e-7);
}
