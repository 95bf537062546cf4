#include <cmath>
#include <utility>

#include <strike/material/eos/linear.hpp>
#include <strike/material/failure/tuler_butcher.hpp>
#include <strike/material/plane_stress.hpp>
#include <strike/material/solid.hpp>
#include <strike/verify/material_point.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {

/// When it fails, and the largest principal stress of the step before.
template <class M>
std::pair<double, double> failure(const M& material, const Path& path) {
  MaterialPoint point{material};
  double time = 0, stress = 0;
  point.run(path, [&](const auto& now) {
    if (now.state.intact > 0) time = now.time, stress = now.stress.xx;
  });
  REQUIRE(point.now().state.intact == 0);
  return {time, stress};
}

}  // namespace

TEST_CASE(
    "Tuler-Butcher: the time under a constant stress and the stress at a constant rate, of glass and of a metal") {
  const double E = 70e9, S = 60e6, t0 = 1e-3;
  const LinearEos eos{.density = 2500, .bulk_modulus = E / 1.5};
  const ElasticStrength elastic{.shear_modulus = E / 2.5};
  for (const auto& [s0, k] : {std::pair{0.0, 16.0}, std::pair{30e6, 2.0}}) {
    const Solid solid{eos, elastic, TulerButcher{.threshold = s0, .strength = S, .duration = t0, .exponent = k}};
    for (const double rate : {1e10, 1e12}) {  // [stress/time]
      const double expected = s0 + std::pow((k + 1) * std::pow(S, k) * t0 * rate, 1 / (k + 1));
      const Path pull = uniaxial_stress({.strain = 1.02 * expected / E, .rate = rate / E, .steps = 2000});
      // a step raises it by a two thousandth, and sums the stress of its end
      CHECK(failure(solid, pull).second == Approx(expected).epsilon(1.5e-3));
      CHECK(failure(PlaneStress{solid}, pull).second == Approx(expected).epsilon(1.5e-3));
    }
    for (const double share : {.7, 1.0, 1.2}) {
      const double time = t0 * std::pow(share, -k);
      const Path jump = uniaxial_stress({.strain = (s0 + share * S) / E, .rate = 1e3, .steps = 10});
      Segment wait{.duration = 1.01 * time, .steps = 1000, .stress = {.yy = 0, .zz = 0}};
      CHECK(failure(solid, jump + Path{{wait}}).first == Approx(time).epsilon(2e-2));  // the stress is not linear in ln
    }
  }
}
