// D15: plane stress in single steps of strain up to 0.1, of any sign.
#include <algorithm>
#include <cmath>
#include <cstddef>

#include <strike/material.hpp>

#include "support/catch.hpp"

using namespace strike;
using Rate = PlaneStressKinematics::Rate<double>;

namespace {

constexpr double E = 72.395e9, Y = 303.37e6;

/// A solid that counts how often it is asked.
template <class S>
struct Counted {
  S solid;
  std::size_t* asked;

  using Kinematics = SolidKinematics;
  template <class T>
  struct State : S::template State<T> {};

  double density() const { return density_of(solid); }
  template <class T>
  SymmetricTensor<T> stress(State<T>& state, const SolidKinematics::Rate<T>& rate, double dt) const {
    ++*asked;
    return solid.stress(static_cast<typename S::template State<T>&>(state), rate, dt);
  }
  template <class T>
  SymmetricTensor<T> stress(const State<T>& state) const {
    return solid.stress(state);
  }
  template <class T>
  Moduli<T> moduli(const State<T>& state, const SolidKinematics::Rate<T>& rate) const {
    return solid.moduli(state, rate);
  }
};

/// Calls f(rate) for single steps of all signs.
template <class F>
void each_step(F f) {
  for (const double size : {1e-6, 1e-3, 1e-2, 1e-1})
    for (const double xx : {-1.0, 0.0, 1.0})
      for (const double yy : {-1.0, -0.5, 0.0, 0.3, 1.0})
        for (const double xy : {-1.0, 0.0, 0.5}) f(Rate{{size * xx, size * yy, size * xy}});
}

}  // namespace

TEST_CASE("D15: one step of plane stress, in closed form, ends on the surface for every Poisson's ratio") {
  for (const double nu : {0.0, 0.33, 0.4999})
    for (const double H : {0.0, 1e9, -1e9}) {
      const double G = E / (2 * (1 + nu)), K = E / (3 * (1 - 2 * nu));
      const VonMises law{.shear_modulus = G, .yield_stress = Y, .hardening_modulus = H};
      const PlaneStress material{Solid{LinearEos{.density = 2800, .bulk_modulus = K}, law}};
      each_step([&](const Rate& rate) {
        decltype(material)::State<double> state;
        const double q = equivalent_stress(material.stress(state, rate, 1.0));
        const double e = state.equivalent_plastic_strain;
        const double trial = E / (1 - nu) * std::sqrt(double_dot(rate.rate_of_deformation, rate.rate_of_deformation));
        CAPTURE(nu, H, rate.rate_of_deformation.xx, rate.rate_of_deformation.yy, rate.rate_of_deformation.xy, q, e);
        if (e > 0)
          CHECK(std::abs(q - law.flow_stress(e)) < 16 * 2.3e-16 * (trial + Y));
        else
          CHECK(q <= Y);
        CHECK(e * 3 * G <= 3 * trial);
      });
    }
}

TEST_CASE("D15: one step of plane stress by the strain across converges in fewer than 50 trials to 1e-10 Y") {
  std::size_t asked = 0, most = 0;
  for (const double nu : {0.0, 0.33, 0.4999})
    for (const double H : {0.0, 1e9, -1e9}) {
      const double G = E / (2 * (1 + nu)), K = E / (3 * (1 - 2 * nu));
      const VonMises law{.shear_modulus = G, .yield_stress = Y, .hardening_modulus = H};
      const Solid solid{LinearEos{.density = 2800, .bulk_modulus = K}, law};
      const ZeroNormalStress material{Counted<decltype(solid)>{solid, &asked}};
      each_step([&](const Rate& rate) {
        decltype(material)::State<double> state;
        asked = 0;
        const double q = equivalent_stress(material.stress(state, rate, 1.0));
        most = std::max(most, asked);
        CAPTURE(nu, H, rate.rate_of_deformation.xx, rate.rate_of_deformation.yy, rate.rate_of_deformation.xy, q);
        CHECK(std::abs(state.stress.zz) <
              1e-10 * std::max(Y, 1e-4 * K));  // of nu = 0.4999 K is 4e5 Y: the rounding of J
        if (state.equivalent_plastic_strain > 0)
          CHECK(std::abs(q - law.flow_stress(state.equivalent_plastic_strain)) < 1e-10 * std::max(Y, 1e-4 * K));
      });
    }
  CHECK(most < 50);
}
