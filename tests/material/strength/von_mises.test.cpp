#include <cmath>
#include <random>

#include <strike/material/strength/strength.hpp>
#include <strike/material/strength/von_mises.hpp>
#include <strike/tensor/rotation.hpp>

#include "support/catch.hpp"

using namespace strike;
using Tensor = SymmetricTensor<double>;
using State = StrengthState<VonMises, double>;

static_assert(FlowLaw<VonMises> && Strength<VonMises> && !RateDependentFlow<VonMises>);

namespace {

constexpr double G = 43.3e9, Y = 400e6;

Tensor random_deviator(std::mt19937& random) {
  std::uniform_real_distribution<double> component(-1, 1);
  const auto c = [&] { return component(random); };
  return deviator(Tensor{c(), c(), c(), c(), c(), c()});
}

}  // namespace

TEST_CASE("von Mises: below yield it is Hooke's law") {
  std::mt19937 random(1);
  const VonMises law{.shear_modulus = G, .yield_stress = Y};
  for (int i = 0; i < 100; ++i) {
    const Tensor s = 0.2e8 * random_deviator(random), d = 1e-4 * random_deviator(random);
    State state;
    const Tensor next = advance_deviator(law, state, s, d, 1e-6);
    CHECK((next - (s + 2 * G * d)).matrix().norm() < 1e-15 * Y);
    CHECK(state.equivalent_plastic_strain == 0);
  }
}

TEST_CASE("von Mises: radial return in closed form, dl = (q - Y - H e)/(3 G + H), along the trial stress") {
  std::mt19937 random(2);
  for (const double H : {0.0, 100e6, 20e9, -2e9})
    for (int i = 0; i < 100; ++i) {
      const VonMises law{.shear_modulus = G, .yield_stress = Y, .hardening_modulus = H};
      const Tensor s = 1e8 * random_deviator(random), d = 0.05 * random_deviator(random), trial = s + 2 * G * d;
      const double e = 0.01, q = equivalent_stress(trial);
      if (q < Y) continue;
      State state{e};
      const Tensor next = advance_deviator(law, state, s, d, 1e-6);
      const double dl = std::min((q - Y - H * e) / (3 * G + H), q / (3 * G));  // all of it if nothing is left to yield
      CHECK(state.equivalent_plastic_strain == Approx(e + dl).epsilon(1e-14));
      CHECK((next - (1 - 3 * G * dl / q) * trial).matrix().norm() < 1e-14 * q);
      CHECK(std::abs(equivalent_stress(next) - law.flow_stress(e + dl)) < 1e-12 * Y);
    }
}

TEST_CASE("von Mises: softening ends at zero stress, not beyond") {
  const VonMises law{.shear_modulus = G, .yield_stress = Y, .hardening_modulus = -1e9};
  CHECK(law.flow_stress(0.5) == 0);
  State state{0.4};  // just used up
  const Tensor d{.xy = 0.1};
  for (int i = 0; i < 3; ++i) CHECK(equivalent_stress(advance_deviator(law, state, {}, d, 1e-6)) < 1e-15 * G);
}

TEST_CASE("von Mises: half the steps give the same radial path") {
  const VonMises law{.shear_modulus = G, .yield_stress = Y, .hardening_modulus = 1e9};
  State once, often;
  const Tensor d{.xx = 0.02, .yy = -0.01, .zz = -0.01};
  const Tensor s = advance_deviator(law, once, {}, d, 1e-6);
  Tensor r;
  for (int i = 0; i < 100; ++i) r = advance_deviator(law, often, r, 0.01 * d, 1e-8);
  CHECK((s - r).matrix().norm() < 1e-13 * Y);  // a hundred roundings
  CHECK(once.equivalent_plastic_strain == Approx(often.equivalent_plastic_strain).epsilon(1e-13));
}
