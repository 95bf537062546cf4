#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include <Eigen/Dense>

#include <strike/tensor/rotation.hpp>

#include "support/catch.hpp"
#include "support/sanitized.hpp"

using namespace strike;
using Tensor = SymmetricTensor<double>;

static_assert(Rotation<Jaumann>);
static_assert(Rotation<HughesWinget>);
static_assert(!Rotation<int>);
static_assert(!Rotation<Tensor>);

namespace {

constexpr double rounding = 1e-15;

Vector3<double> random_vector(std::mt19937& random, double largest) {
  std::uniform_real_distribution<double> component(-largest, largest);
  return Vector3<double>::NullaryExpr([&] { return component(random); });
}

Tensor random_tensor(std::mt19937& random) {
  Matrix3<double> A;
  for (int j = 0; j < 3; ++j) A.col(j) = random_vector(random, 1);
  return symmetric_part(A);
}

Matrix3<double> skew(const Vector3<double>& w) {
  Matrix3<double> W;
  W << 0, -w(2), w(1), w(2), 0, -w(0), -w(1), w(0), 0;
  return W;
}

}  // namespace

TEST_CASE("rotation: rotated(Q, A) is Q A Q^T") {
  std::mt19937 random(1);
  for (int i = 0; i < 100; ++i) {
    Matrix3<double> Q;
    for (int j = 0; j < 3; ++j) Q.col(j) = random_vector(random, 1);
    const Tensor A = random_tensor(random);
    CHECK((rotated(Q, A).matrix() - Q * A.matrix() * Q.transpose()).norm() < 4 * rounding);
  }
}

TEST_CASE("rotation: Hughes-Winget is the Cayley transform (I - W/2)^-1 (I + W/2), orthogonal to rounding") {
  std::mt19937 random(2);
  const Matrix3<double> I = Matrix3<double>::Identity();
  for (const double largest : {1e-300, 1e-8, 1e-3, 1.0, 10.0, 1e3})
    for (int i = 0; i < 100; ++i) {
      const Vector3<double> w = random_vector(random, largest);
      const Matrix3<double> Q = HughesWinget{}.turn(w).Q;
      CHECK((Q.transpose() * Q - I).norm() < 8 * rounding);
      CHECK(Q.determinant() == Approx(1).epsilon(8 * rounding));
      const Matrix3<double> cayley = (I - 0.5 * skew(w)).inverse() * (I + 0.5 * skew(w));
      CHECK((Q - cayley).norm() < 1e-15 * (10 + w.norm()));  // the inverse loses |w|/2 units
    }
}

TEST_CASE("rotation: Hughes-Winget turns by the angle theta when w is 2 tan(theta/2), that of mid-step kinematics") {
  std::mt19937 random(3);
  for (const double theta : {1e-6, 0.01, 0.5, 1.0, 2.0, 3.0}) {
    const Vector3<double> axis = random_vector(random, 1).normalized();
    const Vector3<double> w = 2 * std::tan(theta / 2) * axis;
    const Matrix3<double> exact = Eigen::AngleAxisd(theta, axis).toRotationMatrix();
    CHECK((HughesWinget{}.turn(w).Q - exact).norm() < 1e-14);
    const Tensor A = random_tensor(random);
    CHECK((HughesWinget{}.turn(w)(A).matrix() - exact * A.matrix() * exact.transpose()).norm() < 1e-14);
    const Vector3<double> a = random_vector(random, 1);
    CHECK((HughesWinget{}.turn(w)(a) - exact * a).norm() < 1e-14);
  }
}

TEST_CASE("rotation: Hughes-Winget keeps the invariants of a tensor over 10^4 revolutions") {
  std::mt19937 random(4);
  Tensor A = random_tensor(random);
  const Matrix3<double> begin = A.matrix();
  const double norm = begin.norm();
  const int per_revolution = 100, revolutions = testing::repeated(10000);
  const Vector3<double> w = 2 * std::tan(std::numbers::pi / per_revolution) * Vector3<double>(1, 2, 2) / 3;
  const auto turn = HughesWinget{}.turn(w);
  for (int i = 0; i < per_revolution * revolutions; ++i) A = turn(A);
  CHECK(A.matrix().norm() == Approx(norm).epsilon(1e-10));  // 10^6 roundings in one direction
  CHECK((A.matrix() - begin).norm() < 1e-9);                // and as many of the angle
}

TEST_CASE("rotation: Jaumann is A + W A - A W, and a + W a") {
  std::mt19937 random(5);
  for (int i = 0; i < 100; ++i) {
    const Vector3<double> w = random_vector(random, 1), a = random_vector(random, 1);
    const Tensor A = random_tensor(random);
    const Matrix3<double> W = skew(w), expected = A.matrix() + W * A.matrix() - A.matrix() * W;
    CHECK((Jaumann{}.turn(w)(A).matrix() - expected).norm() < 4 * rounding);
    CHECK(trace(Jaumann{}.turn(w)(A)) == Approx(trace(A)).epsilon(0).margin(4 * rounding));
    CHECK((Jaumann{}.turn(w)(a) - (a + W * a)).norm() < 4 * rounding);
  }
}

TEST_CASE("rotation: Jaumann lets the deviator in the plane of the rotation grow by sqrt(1 + 4 theta^2) a step") {
  for (const double theta : {1e-3, 0.01, 0.1, 0.5}) {
    const Tensor in_plane{.xx = 3, .yy = -3, .zz = 0, .xy = 4};
    const Tensor once = Jaumann{}.turn(Vector3<double>(0, 0, theta))(in_plane);
    CHECK(equivalent_stress(once) / equivalent_stress(in_plane) ==
          Approx(std::sqrt(1 + 4 * theta * theta)).epsilon(4 * rounding));
    const Tensor across{.xx = 1, .yy = 1, .zz = -2};  // has that axis
    CHECK(equivalent_stress(Jaumann{}.turn(Vector3<double>(0, 0, theta))(across)) == equivalent_stress(across));
  }
  // 4 pi theta per revolution, for small theta
  const int per_revolution = 1000;
  const double theta = 2 * std::numbers::pi / per_revolution;
  Tensor s{.xx = 1, .yy = -1};
  for (int i = 0; i < per_revolution; ++i) s = Jaumann{}.turn(Vector3<double>(0, 0, theta))(s);
  const double growth = equivalent_stress(s) / std::numbers::sqrt3 - 1, first_order = 4 * std::numbers::pi * theta;
  CHECK(growth == Approx(first_order).epsilon(first_order));  // the next term is growth^2/2
}

TEST_CASE("rotation: both policies agree to first order, their difference is of second") {
  std::mt19937 random(6);
  const Vector3<double> w = random_vector(random, 1);
  const Tensor A = random_tensor(random);
  const auto difference = [&](double h) {
    return (HughesWinget{}.turn(Vector3<double>(h * w))(A).matrix() -
            Jaumann{}.turn(Vector3<double>(h * w))(A).matrix())
        .norm();
  };
  CHECK(difference(2e-4) / difference(1e-4) == Approx(4).epsilon(1e-3));  // the next term is 1e-4 of it
}
