#include <cstdio>
#include <fstream>
#include <string>

#include <strike/element/hex8.hpp>
#include <strike/element/hex8_full.hpp>
#include <strike/verify/single_element.hpp>

#include "conformance/element.hpp"

using namespace strike;
using namespace strike::verify;

namespace {
const Elastic material{.density = 2, .youngs_modulus = 3, .poissons_ratio = 0.25};
}

TEST_CASE("a single element under a homogeneous velocity gradient: stress, volume, forces and energy in closed form") {
  const double rate = 0.5, dt = 0.01, E = 3, nu = 0.25, lambda = E * nu / (1 + nu) / (1 - 2 * nu), G = E / 2 / (1 + nu);
  Eigen::Matrix3d L = Eigen::Matrix3d::Zero();
  L(0, 0) = rate;
  SingleElement cube{Hex8{}, material, unit_cube()};
  const auto history = cube.run(motion::homogeneous(L), dt, 40);
  REQUIRE(history.size() == 41);
  CHECK(history[0].stress.xx == 0);
  const auto& end = history.back();
  const double strain = 40 * rate * dt;
  CHECK(end.time == Approx(0.4));
  CHECK(end.stress.xx == Approx((lambda + 2 * G) * strain).epsilon(1e-12));
  CHECK(end.stress.yy == Approx(lambda * strain).epsilon(1e-12));
  CHECK(end.volume == Approx(std::pow((1 + rate * dt / 2) / (1 - rate * dt / 2), 40)).epsilon(1e-12));
  CHECK(end.force(0, 1) == Approx(end.stress.xx / 4).epsilon(1e-12));  // the face x keeps its area
  CHECK(end.internal == Approx(end.external).epsilon(1e-4));           // to second order in the step
  CHECK(end.hourglass <= 1e-20);
}

TEST_CASE("motions of a single element: rotation keeps lengths, hourglass patterns are the base vectors, fields any") {
  SingleElement cube{Hex8{}, material, unit_cube()};
  const auto turned = cube.run(motion::rotation({0, 0, 2.0}), 0.1, 10).back();
  const double angle = 20 * std::atan(0.1);  // Cayley's: tan(angle/2) = w dt/2
  CHECK(turned.x.col(1).isApprox(Eigen::Vector3d(std::cos(angle), std::sin(angle), 0), 1e-13));
  CHECK(turned.force.norm() <= 1e-14);

  const auto x = unit_cube();
  const auto xi = (2 * x.row(0).array() - 1), eta = (2 * x.row(1).array() - 1), zeta = (2 * x.row(2).array() - 1);
  const Eigen::Vector3d a(1, 2, 3);
  CHECK(motion::hourglass(0, a)(x, 0).row(1) == (2 * eta * zeta).matrix());
  CHECK(motion::hourglass(1, a)(x, 0).row(1) == (2 * zeta * xi).matrix());
  CHECK(motion::hourglass(2, a)(x, 0).row(1) == (2 * xi * eta).matrix());
  CHECK(motion::hourglass(3, a)(x, 0).row(1) == (2 * xi * eta * zeta).matrix());

  const auto square = motion::field([](const Eigen::Vector3d& p) -> Eigen::Vector3d { return p.cwiseProduct(p); });
  CHECK(square(x, 0) == x.cwiseProduct(x));
}

TEST_CASE("the critical step is where the amplification matrix reaches 1, with and without damping") {
  testing::Shapes<8> shapes(17);
  for (int trial = 0; trial < 5; ++trial) {
    const Nodal<double, 8> x = shapes();
    SingleElement single{Hex8{ViscousHourglass{0.2}}, material, x};
    const auto still = single.vibration(), damped = single.vibration(-1e-5 / single.now().stable_step * x);
    CHECK(damped.critical_step() < still.critical_step());
    for (const auto& vibration : {still, damped}) {
      const double dt = vibration.critical_step();
      CHECK(vibration.spectral_radius(0.99 * dt) <= 1.005);  // 1 but for the root of the rounding and of the pressure
      CHECK(vibration.spectral_radius(1.01 * dt) > 1.02);
    }
    const ElementVibration<> undamped{still.stiffness, Eigen::MatrixXd::Zero(24, 24), still.mass};
    CHECK(undamped.critical_step() == Approx(2 / undamped.frequencies()(23)).epsilon(1e-12));
  }
}

TEST_CASE("a single element says what is wrong with its corners") {
  Nodal<double, 8> inside_out = unit_cube();
  inside_out.row(2) *= -1;
  CHECK_THROWS_WITH((SingleElement{Hex8{}, material, inside_out}),
                    "strike: the SingleElement has no positive mass: give its corners in the right order, none twice.");
}

TEST_CASE("the history of a single element is written as CSV") {
  const std::string path = "single_element.csv";
  SingleElement cube{Hex8Full{}, material, unit_cube()};
  write(path, cube.run(motion::hourglass(2, {0.1, 0, 0}), 0.01, 3));
  std::ifstream file(path);
  std::string head, row;
  std::getline(file, head);
  CHECK(head.substr(0, 27) == "time,stress xx,stress yy,st");
  CHECK(std::count(head.begin(), head.end(), ',') == 12 + 24);
  int rows = 0;
  for (; std::getline(file, row); ++rows) CHECK(std::count(row.begin(), row.end(), ',') == 12 + 24);
  CHECK(rows == 4);
  file.close();
  std::remove(path.c_str());
}
