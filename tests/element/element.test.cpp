#include "conformance/element.hpp"

#include <strike/element/element.hpp>

using namespace strike;

TEST_CASE("MidStep is exact in a homogeneous motion: L dt = 2 (F - 1)(F + 1)^-1") {
  testing::Shapes<8> shapes(7);
  for (int trial = 0; trial < 20; ++trial) {
    const Eigen::Matrix3d one = Eigen::Matrix3d::Identity(), F = one + 0.5 * shapes.matrix();
    const double dt = 0.3;
    const Eigen::Matrix3d end = (F - one) / dt * F.inverse(), mid = 2 / dt * (F - one) * (F + one).inverse();
    CHECK((MidStep{}(Matrix3<double>(end), dt) - mid).norm() <= 1e-12 * (mid.norm() + F.inverse().norm()));
    CHECK(EndStep{}(Matrix3<double>(end), dt) == end);
  }
}

TEST_CASE("a rotation strains nothing at mid-step, and by 1 - cos(theta) at the end of a step") {
  for (const double theta : {1e-3, 0.1, 1.0, 3.0}) {
    const Eigen::Matrix3d R = Eigen::AngleAxisd(theta, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    const Matrix3<double> L = (R - Eigen::Matrix3d::Identity()) * R.transpose();  // with dt = 1
    const auto D = symmetric_part(MidStep{}(L, 1.0));
    CHECK(D.matrix().norm() <= 1e-15 * (1 + std::abs(std::tan(theta / 2))));
    CHECK(axial_vector(MidStep{}(L, 1.0))(2) == Approx(2 * std::tan(theta / 2)).epsilon(1e-13));
    const auto D_end = symmetric_part(EndStep{}(L, 1.0));
    CHECK(D_end.xx == Approx(1 - std::cos(theta)).margin(1e-15));
    CHECK(D_end.yy == Approx(1 - std::cos(theta)).margin(1e-15));
    CHECK(D_end.zz == 0);
  }
}

TEST_CASE("what is measured at mid-step is carried to the end by half the spin, what is measured at the end is there") {
  const SymmetricTensor<double> D{1, -2, 0.5, 0.3, -0.7, 0.2};
  const Eigen::Vector3d axis = Eigen::Vector3d(1, 2, -2) / 3;
  for (const double theta : {1e-3, 1e-2, 0.1}) {
    const Eigen::Matrix3d R = Eigen::AngleAxisd(theta / 2, axis).toRotationMatrix();
    const Vector3<double> w = 2 * std::tan(theta / 2) * axis;  // skew(L) dt at mid-step
    const auto carried = MidStep{}.to_end(w)(D);
    CHECK((carried.matrix() - R * D.matrix() * R.transpose()).norm() <= theta * theta * D.matrix().norm());
    CHECK(trace(carried) == Approx(trace(D)).epsilon(1e-15));
    CHECK((EndStep{}.to_end(w)(D) - D).matrix().norm() == 0);
  }
}

TEST_CASE("turn_tensors turns what a state declares, and nothing else") {
  struct State {
    SymmetricTensor<double> a{1, 2, 3, 4, 5, 6}, b = a;
    auto spatial_tensors() { return std::tie(a); }
  } state;
  struct Nothing {
    double number = 1;
  } nothing;
  const auto twice = [](const SymmetricTensor<double>& A) { return 2.0 * A; };
  turn_tensors(twice, state);
  turn_tensors(twice, nothing);
  CHECK(state.a.zx == 12);
  CHECK(state.b.zx == 6);
  CHECK(nothing.number == 1);
}
