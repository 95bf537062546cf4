#include <cmath>

#include <strike/element/plate3.hpp>
#include <strike/material.hpp>
#include <strike/section.hpp>

#include "conformance/plate.hpp"
#include "support/sanitized.hpp"

using namespace strike;
using namespace strike::verify;

// The rows of the transverse shear in the axes of the authors: x along the first edge, corners (0, 0), (x2, 0), (x3,
// y3), rotations theta_x and theta_y of each node beyond those of the plane (LS-DYNA Theory Manual, C0 triangular
// shell).
TEST_CASE("Plate3 gives the forces and moments of Belytschko, Stolarski and Carpenter") {
  testing::Triangles shapes(31);
  for (int trial = 0; trial < 20; ++trial) {
    const double x2 = 1 + 0.5 * shapes.unit(), x3 = shapes.unit(), y3 = 1 + 0.5 * shapes.unit(), A = x2 * y3 / 2;
    Nodal<double, 3> X;
    X << 0, x2, x3, 0, 0, y3, 0, 0, 0;
    const Plate4Frame<double> frame = testing::plate_frame(X);
    Eigen::Matrix3d turn;  // from the axes of the frame to the authors'
    turn << frame.e1(), frame.e2(), frame.normal;
    const auto numbers = Eigen::Matrix<double, 8, 1>::NullaryExpr([&] { return shapes.unit(); }).eval();
    testing::ConstantResultants section;
    section.resultants = {
        {numbers(0), numbers(1), numbers(2)}, {numbers(3), numbers(4), numbers(5)}, {numbers(6), numbers(7)}, 0};
    const auto in_axes = [&](const PlaneTensor<double>& a) -> Eigen::Matrix2d {
      const Eigen::Matrix2d R = turn.topLeftCorner<2, 2>();
      return R * Eigen::Matrix2d{{a.xx, a.xy}, {a.xy, a.yy}} * R.transpose();
    };
    const Eigen::Matrix2d N = in_axes(section.resultants.force), M = in_axes(section.resultants.moment);
    const Eigen::Vector2d Q = turn.topLeftCorner<2, 2>() * section.resultants.shear;

    Eigen::Matrix<double, 2, 3> b;  // the gradient
    b << -y3, y3, 0, x3 - x2, -x3, x2;
    b /= 2 * A;
    Eigen::Matrix<double, 2, 6> shear;  // of theta_x and theta_y of each node
    shear << -y3 * y3, y3 * (2 * x2 + x3), y3 * y3, y3 * (3 * x2 - x3), 0, x2 * y3,  //
        y3 * (x3 - 2 * x2), x2 * x2 - x3 * x3, -y3 * (x2 + x3), x3 * (x3 - 2 * x2), -3 * x2 * y3, x2 * (2 * x3 - x2);
    shear /= 6 * x2 * y3;
    Nodal<double, 6> expected;
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector2d along = A * N * b.col(i), bending = A * M * b.col(i);
      expected.col(i) << along, A * Q.dot(b.col(i));
      // the motion of a fibre is z (theta_y, -theta_x)
      expected.col(3 + i) << -bending.y() + A * Q.dot(shear.col(2 * i)), bending.x() + A * Q.dot(shear.col(2 * i + 1)),
          0;
    }
    // A rigid rotation of the plane is theta_x = w,y and theta_y = -w,x: the rows of w are those of the edges, in which
    // the shear of a linear deflection is its gradient.
    const auto found = testing::detail::respond(Plate3{}, section, X, Nodal<double, 6>::Zero().eval(), 1.0).force;
    CHECK((found - expected).norm() <= 1e-14 * (1 + X.squaredNorm()));
  }
}

TEST_CASE("Plate3 has one motion without strain beside the rigid ones, which two triangles that share an edge forbid") {
  const auto modes_without_strain = [](const Eigen::MatrixXd& K) {
    const Eigen::VectorXd values =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K, Eigen::EigenvaluesOnly).eigenvalues();
    return (values.array() < 1e-12 * values.maxCoeff()).count();
  };
  testing::Triangles shapes(32);
  const auto count = [&](const auto& element, const std::vector<std::array<int, 3>>& cells, int nodes) {
    Eigen::Matrix3Xd X(3, nodes);
    X << Eigen::Matrix<double, 3, 4>{{0, 1, 1.1, -0.1}, {0, 0.1, 1.2, 0.9}, {0, 0, 0, 0}}.leftCols(nodes);
    Eigen::MatrixXd K = Eigen::MatrixXd::Zero(6 * nodes, 6 * nodes);
    for (const auto& cell : cells) {
      Nodal<double, 3> x;
      for (int i = 0; i < 3; ++i) x.col(i) = X.col(cell[std::size_t(i)]);
      typename std::decay_t<decltype(element)>::template State<std::decay_t<decltype(testing::elastic_plate)>, double>
          state;
      element.begin(state, testing::elastic_plate, x);
      const auto resistance =
          element.resistance(state, testing::elastic_plate, x, Nodal<double, 6>::Zero().eval(), 2.0);  // K
      const auto place = [&](int j) { return (j / 9) * 3 * nodes + 3 * cell[std::size_t(j / 3 % 3)] + j % 3; };
      for (int j = 0; j < 18; ++j) {
        Nodal<double, 6> p = Nodal<double, 6>::Zero();
        p(j) = 1;
        const Nodal<double, 6> f = resistance(x, p);
        for (int i = 0; i < 18; ++i) K(place(i), place(j)) += f(i);
      }
    }
    return modes_without_strain(K);
  };
  const Plate3 free{ConstantThickness{}, FreeDrilling{}};
  CHECK(count(Plate3{}, {{0, 1, 2}}, 3) == 6 + 1);
  CHECK(count(free, {{0, 1, 2}}, 3) == 6 + 1 + 3);
  CHECK(count(Plate3{}, {{0, 1, 2}, {0, 2, 3}}, 4) == 6);
  CHECK(count(free, {{0, 1, 2}, {0, 2, 3}}, 4) == 6 + 4);
  // The one: each node turns about the line from the middle to it.
  const Nodal<double, 3> X = shapes.plane();
  Nodal<double, 6> v = Nodal<double, 6>::Zero();
  v.rightCols<3>() = X.colwise() - X.rowwise().mean();
  CHECK(testing::detail::respond(Plate3{}, testing::elastic_plate, X, v, 1e-3).force.norm() <= 1e-15);
}

// In an equilateral one S = sqrt(3)/(2 A) 1, so w^2 = 6 (1 + nu) c^2/L^2; at nu = 0 the shear across is stiffer.
TEST_CASE(
    "the step of thin triangles is that of their membrane, exact in equilateral ones, sharp to 3 % in halved squares") {
  const auto steps = [](const Nodal<double, 3>& x, double nu) {
    const Homogeneous thin{PlaneStress{Elastic{1, 1, nu}}, 1e-3};
    const SingleElement plate{Plate3{ConstantThickness{}, FreeDrilling{}}, thin, x};
    return std::pair{plate.vibration().critical_step(), plate.now().stable_step};
  };
  Nodal<double, 3> equilateral;
  equilateral << 0, 1, 0.5, 0, 0, std::sqrt(0.75), 0, 0, 0;
  for (const double nu : {0.0, 0.3, 0.49}) {
    const auto [exact, claimed] = steps(equilateral, nu);
    const double c = 1 / std::sqrt(1 - nu * nu);
    if (nu > 0) CHECK(claimed == Approx(2 / (c * std::sqrt(6 * (1 + nu)))).epsilon(1e-12));
    CHECK(exact == Approx(claimed).epsilon(1e-9));
    const auto [exact_half, claimed_half] = steps(unit_triangle(), nu);
    CHECK(exact_half >= claimed_half * (1 - 1e-9));
    CHECK(exact_half <= 1.03 * claimed_half);
  }
}

namespace {

constexpr OrthotropicPly unit_ply{.density = 1, .E1 = 1, .E2 = 0.1, .nu12 = 0.3, .G12 = 0.05, .G13 = 0.05, .G23 = 0.03};
auto of_three(double h, double a, double b, double c, double offset = 0) {
  return Layered{LayUp{unit_ply, h, {a, b, c}}, FibreDirection{{0.3, 0.5, 0.4}}, Offset{offset}};
}

}  // namespace

TEST_CASE("triangles with fibres: the laws of elements, and a direction that does not depend on the numbering") {
  const testing::Triangles shapes(1);
  const auto unsymmetric = of_three(0.07, 10, 70, -35, 0.05);
  testing::rigid_motions_give_no_force(Plate3{}, unsymmetric, shapes, testing::FiniteRotations::exact);
  testing::forces_and_moments_sum_to_zero(Plate3{}, unsymmetric, shapes);
  testing::books_its_work(Plate3{}, unsymmetric, shapes);
  testing::numbering_does_not_matter(Plate3{}, testing::Triangles(2), of_three(0.07, 0, 90, 0));
}

TEST_CASE("triangles with fibres: the step is never beyond the exact one") {
  testing::Triangles shapes(4);
  double least = 10;
  for (int trial = 0; trial < testing::repeated(300); ++trial) {
    const Nodal<double, 3> x = shapes();
    const double h = std::pow(10, 2 * shapes.unit() - 1) * std::sqrt(testing::plate_frame(x).area);
    const auto section =
        of_three(h / 3, 180 * shapes.unit(), 180 * shapes.unit(), 180 * shapes.unit(), shapes.unit() * h);
    const SingleElement single{Plate3{}, section, x};
    least = std::min(least, 2 / single.vibration().frequencies()(17) / single.now().stable_step);
  }
  CHECK(least >= 1 - 1e-9);
}
