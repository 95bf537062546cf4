#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include <strike/dynamics/explicit.hpp>
#include <strike/element/hex8.hpp>
#include <strike/element/hex8_full.hpp>
#include <strike/mesh/box.hpp>

#include "problems/revolutions.hpp"
#include "support/catch.hpp"

using namespace strike;
using revolutions::E;
using revolutions::norm;
using revolutions::spin;
using revolutions::unit_solid;

namespace {

/// Angular velocity w about z, but that one node moves away by a millionth of its velocity, or each by a share of it.
struct Spin {
  double w, shaken = 0;
  template <class N>
  void begin(N& nodes) const {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const double a = 1 + static_cast<double>(i);
      const Eigen::Vector3d shake(std::sin(a * a), std::sin(1.7 * a * a), std::sin(2.3 * a * a));
      nodes.set_velocity(i, Eigen::Vector3d(-w * nodes.x(i).y(), w * nodes.x(i).x(), 0) + shaken * w * shake);
    }
    if (shaken == 0) nodes.set_velocity(0, (1 + 1e-6) * nodes.v(0));
  }
};

/// `cells` along each edge, which have the length 1.
template <class E>
auto spinning_cube(const E& element, double w, Index cells = 1, double shaken = 0) {
  const double size = cells, low = -size / 2;
  const Mesh mesh = box({.lower = {low, low, low}, .size = {size, size, size}, .cells = {cells, cells, cells}});
  return Explicit{Scene{mesh.nodes, Part{element, unit_solid, mesh.hexahedra}, Spin{w, shaken}}, {}, in<double>};
}

template <class Run>
Eigen::Vector3d angular_momentum(const Run& run) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < run.nodes().size(); ++i) {
    const Eigen::Vector3d x = run.nodes().x(i), v = run.nodes().v(i);
    sum += run.nodes().mass(i) * x.cross(v);
  }
  return sum;
}

/// Leaves the rate of deformation as it is measured in the middle of the step.
struct Askew : MidStep {
  template <class T>
  auto to_end(const Vector3<T>& w) const {
    return EndStep{}.to_end(w);
  }
};

}  // namespace

// 16 steps a revolution, theta = 0.39: the criterion counts steps and the law holds for any angle, so that 1e4
// revolutions are 1.6e5 steps here and not 6.3e6 (those are in bench/verification).
TEST_CASE("D8: 1e4 revolutions strain nothing and leave the stress as it was") {
  const int revolutions = 10000, per_revolution = 16;
  const double steps = double(revolutions) * per_revolution;
  const auto unstressed = spin(Hex8{}, 0, revolutions, per_revolution);
  CHECK(norm(unstressed) / E < 1e-9 * std::sqrt(steps));  // seen: 1e-13

  const double stretch = 0.01;
  const auto stressed = spin(Hex8{}, stretch, revolutions, per_revolution);
  CHECK(std::abs(norm(stressed) / (E * stretch) - 1) < 1e-6);
  CHECK(stressed.xx == Approx(E * stretch).epsilon(1e-6));  // and its axes have come back
  CHECK(std::abs(stressed.xy) < 1e-6 * E * stretch);
}

TEST_CASE("D8: 1e3 revolutions of the eight points of Hex8Full leave the stress as it was") {
  const auto stressed = spin(Hex8Full{}, 0.01, 1000, 16);
  CHECK(std::abs(norm(stressed) / (E * 0.01) - 1) < 1e-6);
  CHECK(stressed.xx == Approx(E * 0.01).epsilon(1e-6));
}

TEST_CASE("D8: measured at the end of the step, a revolution strains by pi theta along both axes") {
  const Hex8 element{ViscousHourglass{}, HughesWinget{}, BulkViscosity{}, EndStep{}};
  for (const int per_revolution : {100, 628}) {  // theta = 0.01 would add up to 314 in 1e4 revolutions
    const double theta = 2 * std::numbers::pi / per_revolution;
    const auto stress = spin(element, 0, 1, per_revolution);
    CHECK(stress.xx / E == Approx(std::numbers::pi * theta).epsilon(theta * theta));
    CHECK(stress.yy / E == Approx(std::numbers::pi * theta).epsilon(theta * theta));
    CHECK(std::abs(stress.zz) < 1e-12);
  }
}

TEST_CASE("D8: the rotation of Jaumann lets the deviator grow by 4 pi theta a revolution") {
  const int per_revolution = 1000;
  const double theta = 2 * std::numbers::pi / per_revolution, stretch = 1e-3;
  const auto stress = spin(Hex8{ViscousHourglass{}, Jaumann{}}, stretch, 1, per_revolution);
  // (xx - yy)/2 grows; xx + yy stays
  CHECK((stress.xx - stress.yy) / (E * stretch) == Approx(std::exp(4 * std::numbers::pi * theta)).epsilon(2e-3));
  CHECK((stress.xx + stress.yy) / (E * stretch) == Approx(1).epsilon(2e-3));
}

TEST_CASE("D8: a free elastic cube spins a hundred times and keeps its angular momentum and its energy") {
  const double w = 0.02;  // a strain of 1e-4, 0.014 in a step
  auto run = spinning_cube(Hex8{}, w);
  run.step();
  const Eigen::Vector3d before = angular_momentum(run), momentum = run.momentum();
  run.until(2 * std::numbers::pi / w * 100);  // some 4e4 steps
  CHECK((angular_momentum(run) - before).norm() < 1e-9 * before.norm());
  CHECK(std::abs(run.energy().error()) < 2e-4);  // its elastic energy is 1e-4 of the kinetic
  CHECK((run.momentum() - momentum).norm() < 1e-12 * w);
}

TEST_CASE("D8: cubes that are shaken spin a hundred times with every hourglass control, and gain no energy") {
  const auto spins = [](const auto& element, double shaken) {
    const double w = 0.02;  // 0.014 in a step
    auto run = spinning_cube(element, w, 3, shaken);
    run.step();
    const auto total = [&] { return run.energy().kinetic + run.energy().internal + run.energy().hourglass; };
    const double before = total();
    run.until(2 * std::numbers::pi / w * 100);
    CHECK(std::abs(run.energy().error()) < 5e-3);
    return total() / before;
  };
  for (const double shaken : {1e-6, 1e-2}) {
    CAPTURE(shaken);
    CHECK(spins(Hex8{}, shaken) == Approx(1).epsilon(5e-3));
    CHECK(spins(Hex8{ViscousHourglass{}}, shaken) == Approx(1).epsilon(5e-3));
    for (const double coefficient : {0.005, 0.05}) {
      CAPTURE(coefficient);
      CHECK(spins(Hex8{StiffnessHourglass{coefficient}}, shaken) == Approx(1).epsilon(5e-3));
    }
  }
}

TEST_CASE("D8: if the stress answered askew by half the angle of a step, that cube would shake itself to pieces") {
  const double w = 0.02;
  auto run = spinning_cube(Hex8{ViscousHourglass{}, HughesWinget{}, BulkViscosity{}, Askew{}}, w);
  CHECK_THROWS_WITH(run.until(2 * std::numbers::pi / w * 10),
                    Catch::Matchers::ContainsSubstring("the energy balance is off"));
}
