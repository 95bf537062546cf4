// A quadrilateral two of whose corners are one.
#include <cmath>

#include <strike/dynamics/explicit.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/load/support.hpp>

#include "conformance/plate.hpp"

using namespace strike;
using namespace strike::verify;

namespace {
Nodal<double, 4> triangle() {
  Nodal<double, 4> x = Eigen::Vector3d(3, 2, 1).asDiagonal() * unit_square();
  x.col(3) = x.col(2);
  return x;
}
}  // namespace

TEST_CASE("D20: a triangle has its area and its mass, measures linear fields exactly and knows its step") {
  const SingleElement plate{Plate4{}, testing::elastic_plate, triangle()};
  CHECK(plate.now().volume == Approx(3).epsilon(1e-15));
  CHECK(plate.nodal_mass() == Approx(0.2 * 3. / 4).epsilon(1e-15));
  CHECK(2 / plate.vibration().frequencies()(23) >= (1 - 1e-9) * plate.now().stable_step);

  testing::Quadrilaterals shapes(20);
  for (int trial = 0; trial < 10; ++trial) {
    const testing::LinearPlateMotion motion(shapes, triangle(), testing::Bending::deflection);
    SingleElement witness{Plate4{}, testing::PlateWitness{}, triangle()};
    witness.step(motion(triangle()), 1e-15);
    const auto& rate = witness.state().material.rate;
    const auto expected = motion.rate();
    CHECK(testing::detail::norm(rate.membrane - expected.membrane) <= 1e-14 * motion.size());
    CHECK(testing::detail::norm(rate.curvature - expected.curvature) <= 1e-14 * motion.size());
    CHECK((rate.shear - expected.shear).norm() <= 1e-13 * motion.size());
  }
}

TEST_CASE("D20: a rigid motion of a triangle gives no force") {
  SingleElement plate{Plate4{}, testing::elastic_plate, triangle()};
  for (const auto& record : plate.run(motion::rotation({0.3, -0.2, 0.4}), 1.0, 10)) CHECK(record.force.norm() < 1e-12);
}

TEST_CASE("D20: triangles whose cells name a node twice swing and keep their energy") {
  const std::vector<Eigen::Vector3d> nodes{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0}};
  const Cells<4> cells{{0, 1, 4, 4}, {1, 2, 4, 4}, {2, 3, 4, 4}, {3, 0, 4, 4}};
  Explicit run{Scene{nodes, Part{Plate4{}, testing::elastic_plate, cells}, InitialVelocity{{2e-3, 1e-3, 5e-3}, {4}},
                     Pinned{{0, 1, 2, 3}}},
               ExplicitOptions{.step_factor = 0.45}};
  CHECK(run.nodes().mass(4) == Approx(0.2 / 2).epsilon(1e-15));  // two corners of each
  CHECK(run.nodes().mass(0) == Approx(0.2 / 8).epsilon(1e-15));
  double worst = 0;
  for (int i = 0; i < 2000; ++i) run.step(), worst = std::max(worst, std::abs(run.energy().error()));
  CHECK(worst < 2e-3);  // as four squares do in such steps
  CHECK(run.nodes().x(4).allFinite());
}
