#include <cmath>

#include <strike/material/eos/linear.hpp>
#include <strike/material/failure/failure.hpp>
#include <strike/material/solid.hpp>
#include <strike/material/strength/kinematic_hardening.hpp>
#include <strike/material/strength/von_mises.hpp>
#include <strike/verify/material_point.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {

constexpr double G = 80e9, K = 170e9, Y = 300e6, H = 10e9, E = 9 * K * G / (3 * K + G);
constexpr LinearEos eos{.density = 7850, .bulk_modulus = K};

auto metal(double share) {
  return Solid{
      eos, KinematicHardening{.shear_modulus = G, .yield_stress = Y, .hardening_modulus = H, .isotropic_share = share}};
}

}  // namespace

static_assert(StrengthWithMemory<KinematicHardening> && !FlowLaw<KinematicHardening>);
static_assert(sizeof(StrengthState<KinematicHardening, double>) == 7 * sizeof(double));

TEST_CASE("kinematic hardening: under a cycle of tension and compression the elastic range is 2 (Y + b H e)") {
  // one stress alone: it yields at Y + H e, then |sigma - 3/2 a| = Y + b H e and 3/2 a = (1 - b) H e_xx
  for (const double b : {0.0, .3, 1.0}) {
    MaterialPoint point{metal(b)};
    double peak = 0, strain_before = 0, range = 0;
    const double amplitude = .02;
    const Path quarter = uniaxial_stress({.strain = amplitude, .steps = 400});
    for (int half = 0; half < 6; ++half) {
      const Path path = half == 0 ? quarter : half % 2 == 1 ? back(quarter) + back(quarter) : quarter + quarter;
      point.run(path, [&](const auto& now) {
        const double e = now.state.equivalent_plastic_strain, sigma = now.stress.xx;
        if (half > 0 && strain_before == e) range = std::abs(sigma - peak);  // still elastic
        if (half > 0 && strain_before < e && range > 0) {
          CHECK(range == Approx(2 * (Y + b * H * strain_before)).margin(1.1 * E * 5e-5));  // a step more or less
          range = -1;
        }
        const double centre = 1.5 * now.state.back_stress.xx;
        if (e > strain_before) CHECK(std::abs(sigma - centre) == Approx(Y + b * H * e).epsilon(1e-9));
        if (half == 0 && e > 0) CHECK(sigma == Approx(Y + H * e).epsilon(1e-9));
        strain_before = e;
      });
      peak = point.now().stress.xx, range = 0;
      // plastic strain is what is left of the total, and b = 0 hardens no more from loop to loop
      if (b == 0) {
        const double plastic = (half % 2 ? -1 : 1) * amplitude - peak / E;
        CHECK(peak == Approx((half % 2 ? -1 : 1) * Y + H * plastic).epsilon(1e-3));  // p is not linear in ln J
      }
    }
  }
}

TEST_CASE(
    "kinematic hardening: a share of 1 is VonMises, and without it a loop takes 2 Y times the swing of plastic "
    "strain") {
  MaterialPoint mixed{metal(1)};
  MaterialPoint isotropic{Solid{eos, VonMises{.shear_modulus = G, .yield_stress = Y, .hardening_modulus = H}}};
  const Path path = simple_shear({.strain = .2, .steps = 50}) + uniaxial_strain({.strain = -.1, .steps = 50});
  const auto a = mixed.run(path);
  const auto b = isotropic.run(path);
  for (std::size_t i = 0; i < a.size(); ++i) CHECK((a[i].stress - b[i].stress).matrix().norm() < 1e-12 * G);

  // the work of a closed loop: a parallelogram, 2 Y high, as wide as the plastic strain swings
  MaterialPoint point{metal(0)};
  const Path quarter = uniaxial_stress({.strain = .01, .steps = 1000});
  point.run(quarter);
  const double before = point.now().work, sigma = point.now().stress.xx;
  point.run(back(quarter) + back(quarter) + quarter + quarter);
  CHECK(point.now().stress.xx == Approx(sigma).epsilon(1e-6));
  const double swing = 2 * (.01 - sigma / E);
  CHECK(point.now().work - before == Approx(2 * Y * swing).epsilon(2e-3));  // Cauchy's stress on the volume that it has
}
