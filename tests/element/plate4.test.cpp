#include <cmath>

#include <strike/section.hpp>

#include "conformance/plate.hpp"

using namespace strike;
using namespace strike::verify;

TEST_CASE("Plate4 gives the forces and moments of Belytschko, Lin and Tsay on a plane quadrilateral") {
  testing::Quadrilaterals shapes(31);
  for (int trial = 0; trial < 20; ++trial) {
    const Nodal<double, 4> X = shapes.flat();
    const Plate4Modes<double> m = to_plate_modes<double>(X);
    const Plate4Frame<double> frame(m.xi, m.eta);
    const auto numbers = Eigen::Matrix<double, 8, 1>::NullaryExpr([&] { return shapes.unit(); }).eval();
    testing::ConstantResultants section;
    section.resultants = {
        {numbers(0), numbers(1), numbers(2)}, {numbers(3), numbers(4), numbers(5)}, {numbers(6), numbers(7)}, 0};
    const auto& [N, Moment, Q, rate] = section.resultants;
    const Plate4 theirs{PlateHourglass{}, NoWarping{}};
    const auto found = testing::detail::respond(theirs, section, X, Nodal<double, 8>::Zero().eval(), 1.0).force;

    const Eigen::RowVector4d x = frame.e1().transpose() * X, y = frame.e2().transpose() * X;
    const auto across = [](const Eigen::RowVector4d& a) -> Eigen::RowVector4d {
      return Eigen::RowVector4d(a(1) - a(3), a(2) - a(0), a(3) - a(1), a(0) - a(2));
    };
    const Eigen::RowVector4d Ab_x = 0.5 * across(y), Ab_y = -0.5 * across(x);
    const Eigen::RowVector4d quarter = Eigen::RowVector4d::Constant(0.25 * frame.area);
    Nodal<double, 8> expected;  // in the frame
    expected << N.xx * Ab_x + N.xy * Ab_y, -Moment.yy * Ab_y - Moment.xy * Ab_x - Q(1) * quarter,
        N.yy * Ab_y + N.xy * Ab_x, Moment.xx * Ab_x + Moment.xy * Ab_y + Q(0) * quarter, Q(0) * Ab_x + Q(1) * Ab_y,
        Eigen::RowVector4d::Zero();
    Eigen::Matrix3d e;
    e << frame.e1(), frame.e2(), frame.normal;
    CHECK((found - e * expected).norm() <= 1e-14 * (1 + X.squaredNorm()));
  }
}

TEST_CASE("a uniform transverse shear of a single plate meets Q = K gamma, of any lay-up") {
  struct Row {
    double h1, h2, h3, face, nu_face, nu_core, ratio, K;  // mm, MPa; K to the digits printed
  };
  const Row table[]{{3, .76, 3, 7e4, .22, .45, 1, 1.5545e5},
                    {3, .76, 3, 7e4, .22, .45, 1e2, 6389.97},
                    {3, .76, 3, 7e4, .22, .45, 1e3, 657.657},
                    {3, .76, 3, 7e4, .22, .45, 1e4, 65.9583},
                    {3, .76, 3, 7e4, .22, .45, 1e5, 6.59776},
                    {3, .76, 3, 7e4, .22, .45, 1e6, .659796},
                    {3.2, 1.3, 12.7, 2400, .35, .45, 1e2, 1555.36},
                    {3.2, 1.3, 12.7, 2400, .35, .45, 1e3, 172.938},
                    {3.2, 1.3, 12.7, 2400, .35, .45, 1e4, 17.4894},
                    {1, 10, 1, 7e4, .3, .3, 1e2, 3264.18},
                    {1, 10, 1, 7e4, .3, .3, 1e3, 327.451},
                    {1, 10, 1, 7e4, .3, .3, 1e4, 32.7555},
                    {1, 10, 1, 7e4, .3, .3, 1e5, 3.27565},
                    {1, 1, 1, 7e4, .3, .3, 1, 67307.7},
                    {1, 1, 1, 7e4, .3, .3, 1e2, 1252.13}};
  const double gamma = 1e-6;
  for (const Row& row : table) {
    const PlaneStress stiff{Elastic{2.5e-9, row.face, row.nu_face}};
    const PlaneStress soft{Elastic{1e-9, row.face / row.ratio, row.nu_core}};
    const Layered section{Layer{stiff, row.h1}, Layer{soft, row.h2}, Layer{stiff, row.h3}};
    SingleElement plate{Plate4{}, section, unit_square()};
    Eigen::Matrix3d L = Eigen::Matrix3d::Zero();
    L(2, 0) = gamma;
    Nodal<double, 8> v = Nodal<double, 8>::Zero();
    v.leftCols<4>() = L * unit_square();
    const auto& now = plate.step(v, 1.0);
    CHECK(now.stress.shear(0) == Approx(section.shear_stiffness() * gamma).epsilon(1e-10));
    CHECK(now.stress.shear(0) == Approx(row.K * gamma).epsilon(2e-5));
    CHECK(std::abs(now.stress.shear(1)) <= 1e-15 * row.K * gamma);
  }
}

TEST_CASE("the step of a plane thin plate is that of its membrane, sharp to 3.4 %, and of a square 0.877 L/c") {
  const auto steps = [](const Nodal<double, 4>& x) {
    const Homogeneous thin{PlaneStress{Elastic{1, 1, 0.3}}, 1e-3};
    const SingleElement plate{Plate4{NoPlateHourglass{}, NoWarping{}, ConstantThickness{}, FreeDrilling{}}, thin, x};
    return std::pair{plate.vibration().critical_step(), plate.now().stable_step};
  };
  testing::Quadrilaterals shapes(32);
  for (int trial = 0; trial < 1000; ++trial) {
    const auto [exact, claimed] = steps(shapes.plane());
    CHECK(exact >= (1 - 1e-9) * claimed);
    CHECK(exact <= 1.034 * claimed);
  }
  const auto [exact, claimed] = steps(unit_square());
  CHECK(exact == Approx(claimed).epsilon(1e-9));
  CHECK(exact / std::sqrt(1 - 0.3 * 0.3) == Approx(0.877).margin(5e-4));  // digits printed
}

TEST_CASE("the hourglass modes of a plate vibrate at w^2 = 4 k/m, each family with its own stiffness") {
  const double h = 0.2, nu = 0.3, D = h * h * h / 12 / (1 - nu * nu), K = 5. / 6 * h / 2 / (1 + nu);
  const double m = h / 4, I = m / 8, bb = 2;
  const auto frequencies = [&](const PlateHourglass& control) {
    const SingleElement plate{Plate4{control, NoWarping{}, ConstantThickness{}, FreeDrilling{}}, testing::elastic_plate,
                              unit_square()};
    return Eigen::VectorXd(plate.vibration().frequencies().cwiseAbs2());
  };
  const auto has = [&](const Eigen::VectorXd& all, double w2) { return ((all.array() / w2 - 1).abs() < 1e-9).count(); };
  const double r = 1e-4;
  CHECK(has(frequencies({r, 0, 0}), 4 / m * r / 8 * h / (1 - nu * nu) * bb) == 2);
  CHECK(has(frequencies({0, r, 0}), 4 / I * r / 16 * (D + K / 9) * bb) == 2);
  CHECK(has(frequencies({0, 0, r}), 4 / m * r / 12 * K * h * h * bb) == 1);
}

TEST_CASE("the thickness of a plate follows the strain across it: its volume stays as elasticity says") {
  const double nu = 0.3, rate = 1e-3;
  Eigen::Matrix3d L = Eigen::Matrix3d::Zero();
  L(0, 0) = rate, L(1, 1) = rate;
  SingleElement plate{Plate4{PlateHourglass{}, BelytschkoWongChiang{}, ThicknessChange{}}, testing::elastic_plate,
                      unit_square()};
  plate.run(motion::homogeneous(L), 1.0, 100);
  // ln(h/h0) = -nu/(1 - nu) (e_xx + e_yy)
  CHECK(std::log(plate.state().thickness.relative) == Approx(-nu / (1 - nu) * 2 * 100 * rate).epsilon(1e-6));
}
