#include <cmath>
#include <numbers>

#include <strike/material/eos/gruneisen.hpp>
#include <strike/material/eos/linear.hpp>
#include <strike/material/solid.hpp>
#include <strike/material/strength/johnson_cook.hpp>
#include <strike/material/strength/von_mises.hpp>
#include <strike/verify/material_point.hpp>

#include "support/catch.hpp"

using namespace strike;
using namespace strike::verify;

namespace {

Solid<LinearEos, VonMises> metal(double density, double E, double nu, double Y, double H) {
  return {LinearEos{.density = density, .bulk_modulus = E / (3 * (1 - 2 * nu))},
          VonMises{.shear_modulus = E / (2 * (1 + nu)), .yield_stress = Y, .hardening_modulus = H}};
}

/// Stress at the Hugoniot elastic limit and the wave speeds below and above it.
void check_waves(const Solid<LinearEos, VonMises>& solid, double hel, double c_elastic, double c_plastic) {
  const double G = solid.strength.shear_modulus, K = solid.eos.bulk_modulus, rho = solid.density();
  const double strain = hel / (K + 4 * G / 3), small = 1e-7;
  MaterialPoint point{solid};
  CHECK(std::sqrt(point.moduli().wave() / rho) == Approx(c_elastic).epsilon(1e-6));

  // pressed just short of the limit, just beyond, and on
  point.run(uniaxial_strain({.strain = -strain * (1 - 1e-2), .steps = 1000}));
  CHECK(point.now().state.equivalent_plastic_strain == 0);
  CHECK(-point.now().stress.xx == Approx(hel * (1 - 1e-2)).epsilon(0.7 * strain));  // p is not linear in ln J
  point.run(uniaxial_strain({.strain = -strain * 2e-2, .steps = 1000}));
  CHECK(point.now().state.equivalent_plastic_strain > 0);
  CHECK(-point.now().stress.xx < hel * (1 + 1e-2));

  // in the plastic range the slope is K + 4/3 G H/(3 G + H), in the present volume
  const auto before = point.now();
  point.run(uniaxial_strain({.strain = -small, .steps = 1}));
  const double slope = (before.stress.xx - point.now().stress.xx) / small * point.now().relative_volume();
  const double here = std::sqrt(slope / rho);
  CHECK(here == Approx(c_plastic).epsilon(2 * strain));
}

}  // namespace

TEST_CASE("solid: elastic and plastic waves of steel") {
  check_waves(metal(7850, 200e9, .3, 400e6, 0), 700.00e6, 5856.36, 4607.76);
}

TEST_CASE("solid: elastic and plastic waves of the Taylor copper") {
  check_waves(metal(8930, 117e9, .35, 400e6, 100e6), 866.667e6, 4585.60, 3816.10);
}

TEST_CASE(
    "solid: in simple shear it flows at tau = (Y/sqrt 3) cos phi, s11 = (Y/sqrt 3) sin phi, without oscillation") {
  // Jaumann's rate turns the deviator by dg, the flow by G sin(phi)/(Y/sqrt 3) dg back: sin phi = Y/(sqrt 3 G)
  const auto solid = metal(7850, 200e9, .3, 400e6, 0);
  const double G = solid.strength.shear_modulus, flow = 400e6 / std::numbers::sqrt3, sine = flow / G;
  const auto check = [&](auto rotation) {
    MaterialPoint point{solid, rotation};
    double last = 0;
    point.run(simple_shear({.strain = 10, .steps = 20000}), [&](const auto& now) {
      CHECK(now.stress.xy > last - 1e-5 * flow);  // rises, then stays
      last = now.stress.xy;
    });
    CHECK(point.now().stress.xy == Approx(flow * std::sqrt(1 - sine * sine)).epsilon(1e-6));
    CHECK(point.now().stress.xx == Approx(flow * sine).epsilon(0.1));  // a step strains 5e-4, not less than phi
    CHECK(equivalent_stress(deviator(point.now().stress)) == Approx(400e6).epsilon(1e-12));
  };
  check(HughesWinget{});
  check(Jaumann{});
}

TEST_CASE("solid: the internal energy is the work done on it, to rounding") {
  const Solid copper{GruneisenEos{.density = 8930, .sound_speed = 3940, .S1 = 1.489, .gamma = 1.99},
                     VonMises{.shear_modulus = 43.3e9, .yield_stress = 400e6, .hardening_modulus = 100e6}};
  MaterialPoint point{copper};
  const Path path = uniaxial_strain({.strain = -0.2, .steps = 50}) + simple_shear({.strain = 1, .steps = 50}) +
                    uniaxial_strain({.strain = 0.15, .steps = 50}) + hold(1, 5);
  point.run(path, [](const auto& now) {
    CHECK(now.state.internal_energy == Approx(now.work).epsilon(1e-12).margin(1e-12 * 400e6));
  });
  CHECK(point.now().work > 0);
}

TEST_CASE("solid: pressure comes from the volume alone, shear from the shape alone") {
  const auto solid = metal(7850, 200e9, .3, 1e99, 0);
  MaterialPoint point{solid};
  point.run(hydrostatic({.strain = 0.1, .steps = 10}));
  CHECK(equivalent_stress(deviator(point.now().stress)) < 1e-15 * 200e9);
  const double p = -trace(point.now().stress) / 3;
  CHECK(p == Approx(solid.eos.A(1 / point.now().relative_volume() - 1)).epsilon(1e-14));
  point.run(simple_shear({.strain = 0.5, .steps = 10}));
  CHECK(-trace(point.now().stress) / 3 == Approx(p).epsilon(1e-13));
}

namespace {
/// Relaxes by a tenth a step.
struct Maxwell {
  double shear_modulus;
  template <class T>
  SymmetricTensor<T> deviatoric_stress(const SymmetricTensor<T>& s, const SymmetricTensor<T>& d) const {
    return T(0.9) * (s + T(2 * shear_modulus) * d);
  }
};
}  // namespace

TEST_CASE("solid: a strength of one's own that is no flow law") {
  MaterialPoint point{Solid{LinearEos{.density = 1, .bulk_modulus = 3}, Maxwell{2}}};
  Matrix3<double> L = Matrix3<double>::Zero();
  L(0, 1) = 0.1;
  CHECK(point.step(L, 1).stress.xy == Approx(0.9 * 2 * 0.1).epsilon(1e-2));  // the spin turns a twentieth of it away
  const double before = equivalent_stress(point.now().stress);
  point.run(hold(1, 3));
  CHECK(equivalent_stress(point.now().stress) == Approx(before * 0.729).epsilon(1e-14));
}
