#include <cmath>
#include <numbers>

#include <strike/dynamics/explicit.hpp>
#include <strike/load/prescribed_motion.hpp>
#include <strike/load/support.hpp>
#include <strike/mesh/sheet.hpp>

#include "conformance/plate.hpp"

using namespace strike;
using namespace strike::verify;
using Catch::Matchers::ContainsSubstring;

namespace {

/// The unit square with the corner (1, 1) turned by an angle about the diagonal between its neighbours: at 180 degrees
/// it lies on the corner (0, 0).
Nodal<double, 4> folded(double degrees) {
  const Eigen::Vector3d middle(0.5, 0.5, 0), axis = Eigen::Vector3d(1, -1, 0).normalized();
  Nodal<double, 4> x = unit_square();
  const Eigen::AngleAxisd turn(degrees * std::numbers::pi / 180, axis);
  x.col(2) = middle + turn * Eigen::Vector3d(x.col(2) - middle);
  return x;
}

template <class E>
void is_strain_free(const E& element, double degrees) {
  testing::Shapes<4> shapes(19, folded(degrees));
  for (int trial = 0; trial < 5; ++trial) {
    SingleElement plate{element, testing::elastic_plate, folded(degrees)};
    double worst = 0;
    for (const auto& record : plate.run(motion::rotation(0.5 * shapes.vector().normalized()), 1.0, 5))
      worst = std::max(worst, record.force.norm());
    // of the modulus and the height of the fold over its width, to the square: that far rounding has a lever
    CHECK(worst < 1e-12 * std::max(1.0, std::pow(std::tan(degrees * std::numbers::pi / 360), 2)));
  }
}

}  // namespace

TEST_CASE("D19: a rigid rotation of a quadrilateral strains nothing, warped up to folding, in every policy") {
  for (const double degrees : {0., 1., 30., 60., 90., 120., 150., 170., 179.}) {
    CAPTURE(degrees);
    is_strain_free(Plate4{}, degrees);
    is_strain_free(Plate4{PlateHourglass{}, RigidOffset{}}, degrees);
    is_strain_free(Plate4{PlateHourglass{}, NoWarping{}, ThicknessChange{}, FreeDrilling{}}, degrees);
  }
}

TEST_CASE("D19: the area falls as the cosine of half the angle, and the step is safe at any") {
  for (const double degrees : {0., 1., 30., 60., 90., 120., 150., 170., 179.}) {
    const SingleElement plate{Plate4{}, testing::elastic_plate, folded(degrees)};
    CHECK(plate.now().volume == Approx(std::cos(degrees * std::numbers::pi / 360)).epsilon(1e-12));
    CHECK(2 / plate.vibration().frequencies()(23) >= (1 - 1e-9) * plate.now().stable_step);
  }
}

TEST_CASE("D19: one that is folded shut is refused, and one that folds ends its run with one sentence") {
  Nodal<double, 4> shut = unit_square();
  shut.col(2) = shut.col(0);
  CHECK_THROWS_WITH((SingleElement{Plate4{}, testing::elastic_plate, shut}),
                    "strike: the SingleElement has no positive mass: give its corners in the right order, none twice.");

  const Mesh mesh = rectangle({.size = {1, 1}});
  const auto angle = [](double t) { return std::numbers::pi * t / 20; };
  const auto along = [&](double t) { return -std::sqrt(0.5) * (1 - std::cos(angle(t))); };
  const auto up = [&](double t) { return std::sqrt(0.5) * std::sin(angle(t)); };
  Explicit run{Scene{mesh.nodes, Part{Plate4{}, testing::elastic_plate, mesh.quadrilaterals}, Clamped{{0, 1, 2}},
                     PrescribedDisplacement{Eigen::Vector3d(1, 1, 0), {3}, along},
                     PrescribedDisplacement{Axis::z, {3}, up}}};
  CHECK_THROWS_WITH(run.until(30), ContainsSubstring("strike: at t = ") &&
                                       ContainsSubstring("element 0 of part 0 at (") &&
                                       ContainsSubstring("the time step has fallen to "));
  CHECK(run.time() == Approx(20).epsilon(0.02));
  for (const auto& x : run.positions()) CHECK(x.allFinite());
}
