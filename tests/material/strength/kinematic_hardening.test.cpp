#include <cmath>

#include <strike/material/strength/kinematic_hardening.hpp>
#include <strike/material/strength/strength.hpp>
#include <strike/material/strength/von_mises.hpp>

#include "support/catch.hpp"

using namespace strike;
using Tensor = SymmetricTensor<double>;

static_assert(StrengthWithMemory<KinematicHardening> && !FlowLaw<KinematicHardening>);
static_assert(sizeof(StrengthState<KinematicHardening, double>) == 7 * sizeof(double));

namespace {

constexpr double G = 80e9, Y = 300e6, H = 10e9;

KinematicHardening metal(double share) {
  return {.shear_modulus = G, .yield_stress = Y, .hardening_modulus = H, .isotropic_share = share};
}

/// A bar without change of volume: sigma = 3/2 s_xx, Young's modulus 3 G.
struct Bar {
  KinematicHardening law;
  KinematicHardening::State<double> state{};
  Tensor s{};
  double work = 0;

  double stress() const { return 1.5 * s.xx; }
  double back_stress() const { return 1.5 * state.back_stress.xx; }
  void pull(double strain) {
    const double before = stress();
    s = advance_deviator(law, state, s, Tensor{strain, -.5 * strain, -.5 * strain}, 1.0);
    work += .5 * (before + stress()) * strain;
  }
};

}  // namespace

TEST_CASE("kinematic hardening: under cycles of tension and compression the elastic range is 2 (Y + b H e)") {
  const double amplitude = .02, step = amplitude / 1000;
  for (const double b : {0.0, .3, 1.0}) {
    Bar bar{metal(b)};
    double plastic = 0;
    for (int half = 0; half < 6; ++half) {
      const double sign = half % 2 == 0 ? 1 : -1, turn = bar.stress(), e_turn = bar.state.equivalent_plastic_strain;
      bool yielded = false;
      for (int i = 0; i < (half == 0 ? 1000 : 2000); ++i) {
        const double e = bar.state.equivalent_plastic_strain;
        bar.pull(sign * step);
        const double dl = bar.state.equivalent_plastic_strain - e;
        plastic += sign * dl;
        if (dl == 0) continue;
        if (!yielded && half > 0)
          CHECK(std::abs(bar.stress() - turn) == Approx(2 * (Y + b * H * e_turn)).margin(3 * G * step));
        yielded = true;
        CHECK(sign * (bar.stress() - bar.back_stress()) == Approx(Y + b * H * (e + dl)).epsilon(1e-12));
        CHECK(bar.back_stress() == Approx((1 - b) * H * plastic).margin(1e-12 * Y));
      }
      CHECK(yielded);
    }
  }
}

TEST_CASE("kinematic hardening: a share of 1 is VonMises, and without it a loop takes 2 Y times its plastic swing") {
  const VonMises isotropic{.shear_modulus = G, .yield_stress = Y, .hardening_modulus = H};
  KinematicHardening::State<double> mixed;
  StrengthState<VonMises, double> state;
  Tensor a, b;
  for (int i = 0; i < 100; ++i) {
    const Tensor d{.xx = 1e-3 * std::sin(i), .yy = -1e-3 * std::sin(i), .xy = 1e-3 * std::cos(2. * i)};
    a = advance_deviator(metal(1), mixed, a, d, 1.0);
    b = advance_deviator(isotropic, state, b, d, 1.0);
    CHECK((a - b).matrix().norm() < 1e-13 * G);
  }

  Bar bar{metal(0)};
  const double amplitude = .01, step = amplitude / 1000;
  const auto pull = [&](double strain) {
    for (int i = 0; i < static_cast<int>(std::lround(std::abs(strain) / step)); ++i)
      bar.pull(std::copysign(step, strain));
  };
  pull(amplitude);
  const double top = bar.stress(), before = bar.work;
  CHECK(top == Approx((Y + H * amplitude) / (1 + H / (3 * G))).epsilon(1e-12));
  pull(-2 * amplitude);
  CHECK(bar.stress() == Approx(-top).epsilon(1e-12));  // at once the loop that stays
  pull(2 * amplitude);
  CHECK(bar.stress() == Approx(top).epsilon(1e-12));
  CHECK(bar.work - before == Approx(2 * Y * 2 * (amplitude - top / (3 * G))).epsilon(1e-4));  // steps over two corners
}
