// D16: no layer, one, a hundred.
#include <strike/material/plane_stress.hpp>
#include <strike/section/layered.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {
const PlaneStress polycarbonate{Elastic{.density = 1200e-12, .youngs_modulus = 2400, .poissons_ratio = .38}};
}

TEST_CASE("D16: a plate cut into 100 layers is the same plate to 1e-12") {
  const Homogeneous whole{polycarbonate, 12.7};
  const Layered cut{Plies{Layer{polycarbonate, .127}, 100}};
  CHECK(whole.shear_stiffness() == Approx(9202.8986).epsilon(1e-8));
  CHECK(cut.shear_stiffness() == Approx(whole.shear_stiffness()).epsilon(1e-12));
  CHECK(cut.transverse_shear().bending == Approx(whole.transverse_shear().bending).epsilon(1e-12));
  CHECK(cut.density() == Approx(whole.density()).epsilon(1e-12));
  CHECK(cut.rotary_inertia() == Approx(whole.rotary_inertia()).epsilon(1e-12));
  CHECK(cut.warning(10).empty());

  decltype(whole)::State<double> a{};
  decltype(cut)::State<double> b{};
  cut.begin(b);
  const PlateKinematics::Rate<double> rate{{1e-3, 2e-3, 3e-3}, {4e-4, -5e-4, 6e-4}, {7e-4, 8e-4}};
  const auto s = whole.stress(a, rate, 1), t = cut.stress(b, rate, 1);
  CHECK(t.force.xx == Approx(s.force.xx).epsilon(1e-12));
  CHECK(t.moment.xx == Approx(s.moment.xx).epsilon(1e-12));
  CHECK(t.shear(1) == Approx(s.shear(1)).epsilon(1e-12));
  CHECK(cut.shear_stress(b, 50, 0)(0) == Approx(1.5 * t.shear(0) / 12.7).epsilon(1e-12));
}

TEST_CASE("D16: a layer without thickness is none") {
  const PlaneStress steel{Elastic{.density = 7850e-12, .youngs_modulus = 200e3, .poissons_ratio = .3}};
  const Homogeneous whole{polycarbonate, 12.7};
  const Layered with{Layer{steel, 0.0}, Layer{polycarbonate, 6.0}, Layer{steel, 0.0}, Layer{polycarbonate, 6.7}};
  CHECK(with.shear_stiffness() == Approx(whole.shear_stiffness()).epsilon(1e-14));
  CHECK(with.transverse_shear().bending == Approx(whole.transverse_shear().bending).epsilon(1e-14));
  CHECK(with.density() == Approx(whole.density()).epsilon(1e-15));
}
