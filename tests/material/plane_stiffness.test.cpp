#include <cmath>
#include <random>

#include <Eigen/Dense>

#include <strike/material/orthotropic_ply.hpp>
#include <strike/material/plane_stiffness.hpp>

#include "support/catch.hpp"
#include "support/plies.hpp"

using namespace strike;

TEST_CASE("plane stiffness: a turn by degrees is exact at right angles, and half a turn is none") {
  for (const double angle : {0., 180., -360.}) CHECK(turn_by_degrees(angle).cosine == 1);
  for (const double angle : {90., -90., 270., -450.}) {
    CHECK(turn_by_degrees(angle).cosine == 0);
    CHECK(std::abs(turn_by_degrees(angle).sine) == 1);
  }
  for (const double angle : {30., -70., 45.}) {
    CHECK(turn_by_degrees(angle).cosine == turn_by_degrees(angle + 180).cosine);
    CHECK(turn_by_degrees(angle).sine == turn_by_degrees(angle + 180).sine);
  }
}

TEST_CASE("plane stiffness: tensors turn there and back, and work is the same in both axes") {
  const PlaneTensor<double> a{1, -2, 0.7}, b{0.3, 0.4, -5};
  const Vector2<double> q{3, -1};
  for (const double angle : {0., 20., 90., -135.}) {
    const PlaneTurn<double> turn = turn_by_degrees(angle);
    const PlaneTensor<double> there = turn.into(a), back = turn.back(there);
    CHECK(back.xx == Approx(a.xx).epsilon(1e-14));
    CHECK(back.yy == Approx(a.yy).epsilon(1e-14));
    CHECK(back.xy == Approx(a.xy).epsilon(1e-14));
    CHECK(double_dot(there, turn.into(b)) == Approx(double_dot(a, b)).epsilon(1e-14));
    CHECK((turn.back(turn.into(q)) - q).norm() < 1e-15);
    // Q turned back answers as the ply in its own axes.
    const PlaneTensor<double> own = turn.back(testing::carbon.elastic(turn.into(a)));
    const Eigen::Vector3d s =
        turned_back(testing::carbon.plane_stiffness(), turn) * Eigen::Vector3d(a.xx, a.yy, 2 * a.xy);
    CHECK((s - Eigen::Vector3d(own.xx, own.yy, own.xy)).norm() < 1e-14 * s.norm());
  }
}

TEST_CASE("plane stiffness: the isotropic bound is nowhere below, of isotropic stiffness itself, of fibres theirs") {
  const auto orthonormal = [](const PlaneModuli<double>& m) {
    return strike::detail::orthonormal(strike::detail::plane_stiffness(m));
  };
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < 2000; ++i) {
    Eigen::Matrix3d root = Eigen::Matrix3d::NullaryExpr([&] { return unit(random); });
    if (i % 2 == 0) root.row(0) *= std::pow(10, 3 * unit(random));
    const Eigen::Matrix3d Q = root * root.transpose();  // in an orthonormal basis
    const Eigen::Vector3d unit_strain(1, 1, 1 / std::sqrt(2.));
    const PlaneModuli<double> m =
        strike::detail::isotropic_bound(unit_strain.asDiagonal() * Q * unit_strain.asDiagonal());
    const double most = Q.selfadjointView<Eigen::Upper>().eigenvalues()(2);
    const Eigen::Matrix3d over = orthonormal(m) - Q;
    CHECK(over.selfadjointView<Eigen::Upper>().eigenvalues()(0) >= -1e-13 * most);
    CHECK(m.normal <= most * (1 + 1e-12));
  }
  const PlaneModuli<double> own{3, 1.1}, found = strike::detail::isotropic_bound(strike::detail::plane_stiffness(own));
  CHECK(found.normal == Approx(own.normal).epsilon(1e-14));
  CHECK(found.shear == Approx(own.shear).epsilon(1e-14));
  PlaneStiffness fibres = PlaneStiffness::Zero();
  fibres(0, 0) = 7;
  CHECK(strike::detail::isotropic_bound(fibres).normal == Approx(7).epsilon(1e-12));
}
