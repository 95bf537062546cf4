#include <strike/element/hex8.hpp>
#include <strike/element/hex8_full.hpp>

#include "conformance/plate.hpp"

using namespace strike;
using namespace strike::verify;

namespace {

const Eigen::Vector3d plate(1, 1, 1e-4), needle(1, 1e-4, 1e-4);

template <class E>
void knows_its_step(const E& element) {
  for (const Eigen::Vector3d& stretch : {plate, needle})
    for (const double nu : {0.0, 0.3, 0.4999}) {
      const SingleElement brick{element, Elastic{1, 1, nu}, Nodal<double, 8>(stretch.asDiagonal() * unit_cube())};
      const double ratio = brick.vibration().critical_step() / brick.now().stable_step;
      CHECK(ratio >= 1 - 1e-9);
      CHECK(ratio <= 1.16);
    }
}

}  // namespace

TEST_CASE("D18: the stable step of bricks 1:1:1e-4 and 1:1e-4:1e-4 is within 1.16 of the exact one") {
  knows_its_step(Hex8{ViscousHourglass{}, HughesWinget{}, NoBulkViscosity{}});
  knows_its_step(Hex8{StiffnessHourglass{}, HughesWinget{}, NoBulkViscosity{}});
  knows_its_step(Hex8{PhysicalHourglass{}, HughesWinget{}, NoBulkViscosity{}});
  knows_its_step(Hex8Full{HughesWinget{}, NoBulkViscosity{}});
}

TEST_CASE("D18: the patch test holds at an aspect ratio of 1e4") {
  for (const Eigen::Vector3d& stretch : {plate, needle}) {
    testing::passes_the_patch_test(Hex8{}, testing::Shapes<8>(18), stretch, 1e-10);
    testing::passes_the_patch_test(Hex8Full{}, testing::Shapes<8>(19), stretch, 1e-10);
  }
}

TEST_CASE("D18: the step of a thin plate 1:1e-4 is within 1.16 of the exact one") {
  const Homogeneous thin{PlaneStress{Elastic{1, 1, 0.3}}, 1e-6};
  const Nodal<double, 4> strip = Eigen::Vector3d(1, 1e-4, 1).asDiagonal() * unit_square();
  const auto knows_its_step = [&](const auto& element) {
    const SingleElement single{element, thin, strip};
    const double ratio = single.vibration().critical_step() / single.now().stable_step;
    CHECK(ratio >= 1 - 1e-9);
    CHECK(ratio <= 1.16);
  };
  knows_its_step(Plate4{});
  knows_its_step(Plate4{PlateHourglass{}, RigidOffset{}});
  knows_its_step(Plate4{NoPlateHourglass{}, NoWarping{}, ThicknessChange{}, FreeDrilling{}});
}

TEST_CASE("D18: a plate 1:1e-4 measures linear fields to 1e-10, and to 1e-8 where its sides are askew by 1e-3") {
  testing::Quadrilaterals shapes(18);
  for (const bool askew : {false, true})
    for (int trial = 0; trial < 100; ++trial) {
      const Eigen::Vector3d shift(askew ? 0.2 : 0.2e-4, 0.2e-4, 0);
      const Eigen::Matrix3d turn = shapes.turn();
      const Nodal<double, 4> flat =
          Eigen::Vector3d(1, 1e-4, 1).asDiagonal() * unit_square() + shift.asDiagonal() * shapes.nodal();
      const Nodal<double, 4> x = turn * flat;
      const testing::LinearPlateMotion motion(shapes, x, testing::Bending::deflection);
      SingleElement strip{Plate4{}, testing::PlateWitness{}, x};
      strip.step(motion(x), 1e-18);  // so short that its end is its middle
      const auto& rate = strip.state().material.rate;
      const auto expected = motion.rate();
      const double rounding = (askew ? 1e-8 : 1e-10) * motion.size();
      CHECK(testing::detail::norm(rate.membrane - expected.membrane) <= rounding);
      CHECK(testing::detail::norm(rate.curvature - expected.curvature) <= rounding);
      CHECK((rate.shear - expected.shear).norm() <= rounding);
    }
}
