#include <strike/element/hex8.hpp>
#include <strike/element/hex8_full.hpp>

#include "conformance/element.hpp"

using namespace strike;

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
  knows_its_step(Hex8Full{HughesWinget{}, NoBulkViscosity{}});
}

TEST_CASE("D18: the patch test holds at an aspect ratio of 1e4") {
  for (const Eigen::Vector3d& stretch : {plate, needle}) {
    testing::passes_the_patch_test(Hex8{}, testing::Shapes<8>(18), stretch, 1e-10);
    testing::passes_the_patch_test(Hex8Full{}, testing::Shapes<8>(19), stretch, 1e-10);
  }
}
