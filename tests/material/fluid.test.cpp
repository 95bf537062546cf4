#include <strike/material/eos/cubic.hpp>
#include <strike/material/eos/ideal_gas.hpp>
#include <strike/material/eos/linear.hpp>
#include <strike/material/fluid.hpp>
#include <strike/verify/material_point.hpp>

#include "support/catch.hpp"

using namespace strike;
using namespace strike::verify;

static_assert(SolidMaterial<Fluid<CubicEos>> && SolidMaterial<Fluid<IdealGas, Newtonian>>);

namespace {
template <class M>
concept Viscous = requires(const M m) { m.viscosity(); };
}  // namespace
static_assert(Viscous<Fluid<LinearEos, Newtonian>> && !Viscous<Fluid<LinearEos>>);

TEST_CASE("fluid: Newtonian shear stress 2 eta D' beside the pressure, none at rest") {
  MaterialPoint point{Fluid{LinearEos{.density = 1000, .bulk_modulus = 2e9}, Newtonian{.viscosity = 0.5}}};
  point.run(simple_shear({.strain = 10, .rate = 300, .steps = 1000}));
  CHECK(point.now().stress.xy == Approx(0.5 * 300).epsilon(2e-5));  // half a step turns D by 5e-3: its cosine
  CHECK(std::abs(point.now().stress.xx) < 2.0);                     // and K times the rounding of the volume

  Matrix3<double> L = Matrix3<double>::Zero();
  L(0, 0) = 10;
  const auto& now = point.step(L, 1e-9);
  CHECK(now.stress.xx - now.stress.yy == Approx(2 * 0.5 * 10).epsilon(1e-6));
  CHECK(now.stress.xx - trace(now.stress) / 3 == Approx(2 * 0.5 * 10 * 2. / 3).epsilon(1e-6));

  point.run(hold(1, 1));
  CHECK(point.now().stress.xy == 0);
  CHECK(point.now().stress.xx == point.now().stress.yy);
}

TEST_CASE("fluid: viscous heating of a gas, eta rate^2 t, raises its pressure by gamma - 1 of that") {
  const IdealGas gas{.density = 1.2, .gamma = 1.4, .initial_energy = 2.5e5};
  MaterialPoint point{Fluid{gas, Newtonian{.viscosity = 2}}};
  point.run(simple_shear({.strain = 5, .rate = 100, .steps = 5000}));
  const double heat = 2. * 100 * 100 * 0.05;
  CHECK(point.now().state.internal_energy - 2.5e5 == Approx(heat).epsilon(1e-6));
  CHECK(-point.now().stress.xx == Approx(0.4 * (2.5e5 + heat)).epsilon(1e-6));
}

TEST_CASE("fluid: inviscid it resists no change of shape, however fast") {
  MaterialPoint point{Fluid{CubicEos{.density = 938, .C1 = 2.06e9, .C2 = 6.19e9, .C3 = 10.3e9}}};
  point.run(simple_shear({.strain = 100, .rate = 1e12, .steps = 100}));
  CHECK(point.now().stress.xy == 0);
  CHECK(point.now().work == Approx(0).margin(1e-6));
  CHECK(point.moduli().shear == 0);
}
