// D23 at one point: the same metal in five systems of units.
#include <array>
#include <cmath>
#include <vector>

#include <strike/material/eos/gruneisen.hpp>
#include <strike/material/failure/failure.hpp>
#include <strike/material/solid.hpp>
#include <strike/material/strength/johnson_cook.hpp>
#include <strike/material/strength/rate_von_mises.hpp>
#include <strike/output/units.hpp>
#include <strike/verify/material_point.hpp>

#include "support/catch.hpp"

using namespace strike;
using namespace strike::verify;

namespace {

/// Stress over the yield stress along one path, with every number given in SI and used in these units.
template <class S>
std::array<double, 4> along_the_path(const Units& u, const S& strength, double yield_stress) {
  const GruneisenEos eos{.density = 8930 / u.kilogram_per_cubic_metre(),
                         .sound_speed = 3940 * u.second / u.metre,
                         .S1 = 1.489,
                         .gamma = 1.99};
  MaterialPoint point{Solid{eos, strength, FailureStrain{.failure_strain = 5}}};
  const auto at_rate = [&](double strain) { return Ramp{.strain = strain, .rate = 1e4 * u.second, .steps = 200}; };
  point.run(uniaxial_strain(at_rate(-0.1)) + simple_shear(at_rate(0.7)) + uniaxial_stress(at_rate(0.2)),
            [](const auto&) {});
  const auto& now = point.now();
  return {now.stress.xx / yield_stress, now.stress.xy / yield_stress, now.state.internal_energy / yield_stress,
          now.state.equivalent_plastic_strain};
}

constexpr std::array systems{units::si, units::mm_ms_kg, units::mm_s_t, units::cm_us_g, units::in_s_lbf};
constexpr double rounding = 1e-10;  // of the Newton steps of prescribed stress, in 200 steps

}  // namespace

TEST_CASE("D23: von Mises with rate in five systems of units") {
  const auto in = [](const Units& u) {
    const RateVonMises law{.shear_modulus = 43.3e9 / u.pascal(),
                           .yield_stress = 400e6 / u.pascal(),
                           .hardening_modulus = 100e6 / u.pascal(),
                           .rate_factor = std::pow(6500 * u.second, -0.25),
                           .rate_exponent = 0.25};
    return along_the_path(u, law, law.yield_stress);
  };
  const auto si = in(units::si);
  for (const Units& u : systems) {
    CAPTURE(u.name);
    for (std::size_t i = 0; i < si.size(); ++i) CHECK(in(u)[i] == Approx(si[i]).epsilon(rounding));
  }
}

TEST_CASE("D23: Johnson-Cook in five systems of units") {
  const auto in = [](const Units& u) {
    const JohnsonCook law{.shear_modulus = 46e9 / u.pascal(),
                          .A = 90e6 / u.pascal(),
                          .B = 292e6 / u.pascal(),
                          .n = .31,
                          .C = .025,
                          .reference_rate = 1 * u.second,
                          .m = 1.09,
                          .initial_temperature = 294,
                          .melting_temperature = 1356,
                          .heating = 0.9 / (8930 * 383) * u.pascal()};
    return along_the_path(u, law, law.A);
  };
  const auto si = in(units::si);
  for (const Units& u : systems) {
    CAPTURE(u.name);
    for (std::size_t i = 0; i < si.size(); ++i) CHECK(in(u)[i] == Approx(si[i]).epsilon(rounding));
  }
}
