// The first forces are those of a step of no length.
#include <strike/strike.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {

template <class E, class M>
double speed_after_two_steps(const E& element, const M& material) {
  const Mesh sheet = rectangle({.size = {2.0, 2.0}, .cells = {2, 2}});
  Explicit run{
      Scene{sheet.nodes, Part{element, Homogeneous{material, 0.1}, sheet.quadrilaterals}, InitialVelocity{{1, 0, 0}}}};
  for (int i = 0; i < 2; ++i) run.step();
  return run.nodes().v(0).norm();
}

}  // namespace

TEST_CASE("plates that measure the strain across them start in the driver") {
  const Solid metal{LinearEos{.density = 1, .bulk_modulus = 1}, VonMises{.shear_modulus = 0.4, .yield_stress = 0.01}};
  const Plate4 thinning{PlateHourglass{}, BelytschkoWongChiang{}, ThicknessChange{}};
  CHECK(speed_after_two_steps(thinning, PlaneStress{metal}) == Approx(1));
  CHECK(speed_after_two_steps(thinning, ZeroNormalStress{metal}) == Approx(1));
  CHECK(speed_after_two_steps(Plate4{}, ZeroNormalStress{metal}) == Approx(1));
}
