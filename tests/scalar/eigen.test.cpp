#include <cmath>
#include <type_traits>

#include <strike/scalar/eigen.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {

using Doubles8 = Pack<double, 8>;
using Floats16 = Pack<float, 16>;
using Dual2 = Dual<double, 2>;
using DualPack = Dual<Pack<double, 4>, 2>;

template <class T>
double number(const T& x) {
  if constexpr (std::is_arithmetic_v<T>)
    return double(x);
  else if constexpr (requires { x.value(); })
    return number(x.value());
  else
    return number(lane(x, lanes<T> - 1));
}

template <class T>
double rounding() {
  return sizeof(RealOf<T>) == 8 ? 1e-13 : 1e-4;  // a hundred operations, condition numbers below 20
}

/// Rows x Columns numbers without order, of size 1, well conditioned.
template <class T, int Rows, int Columns>
Eigen::Matrix<T, Rows, Columns> matrix(double seed) {
  Eigen::Matrix<T, Rows, Columns> a;
  for (int j = 0; j < Columns; ++j)
    for (int i = 0; i < Rows; ++i) a(i, j) = std::sin(seed + 3.1 * i * i + 7.7 * j * (i + 2)) + (i == j);
  return a;
}

template <class T, int Rows, int Columns>
void check_equal(const Eigen::Matrix<T, Rows, Columns>& a, const Eigen::MatrixXd& b) {
  REQUIRE(a.size() == b.size());
  for (Eigen::Index i = 0; i < a.size(); ++i)
    CHECK(number(a.data()[i]) == Approx(b.data()[i]).epsilon(rounding<T>()).margin(rounding<T>()));
}

}  // namespace

TEMPLATE_TEST_CASE("Eigen's formulas give on every scalar what they give on double", "", Doubles8, Floats16, Dual2,
                   DualPack) {
  using T = TestType;
  using Matrix3 = Eigen::Matrix<T, 3, 3>;
  using Vector3 = Eigen::Matrix<T, 3, 1>;
  const Eigen::Matrix3d a_ = matrix<double, 3, 3>(1), b_ = matrix<double, 3, 3>(2);
  const Eigen::Vector3d v_ = matrix<double, 3, 1>(3), w_ = matrix<double, 3, 1>(4);
  const Matrix3 a = matrix<T, 3, 3>(1), b = matrix<T, 3, 3>(2);
  const Vector3 v = matrix<T, 3, 1>(3), w = matrix<T, 3, 1>(4);

  check_equal(Matrix3(0.5 * (a + a.transpose()) / 3 - 2 * b), 0.5 * (a_ + a_.transpose()) / 3 - 2 * b_);
  check_equal(Matrix3(a * b * 0.5f), a_ * b_ * 0.5);
  check_equal(Matrix3(a * b + b.transpose() * a), a_ * b_ + b_.transpose() * a_);
  check_equal(Vector3(a * v - w), a_ * v_ - w_);
  check_equal(Vector3(a.transpose() * v), a_.transpose() * v_);
  check_equal(Vector3(a.inverse() * v), a_.inverse() * v_);
  check_equal(Vector3(v.cross(w)), v_.cross(w_));
  check_equal(Matrix3(v * w.transpose()), v_ * w_.transpose());
  check_equal(Matrix3(a.inverse()), a_.inverse());
  Matrix3 power = a;
  power = power * a;  // no alias
  check_equal(power, a_ * a_);
  check_equal(Matrix3(a.cwiseProduct(b).cwiseAbs()), a_.cwiseProduct(b_).cwiseAbs());
  check_equal(Matrix3(v.asDiagonal() * a), Eigen::Matrix3d(v_.asDiagonal() * a_));
  Matrix3 c = Matrix3::Identity();
  c += a * b;
  c.noalias() -= 2 * a;
  c *= 0.25;
  check_equal(c, (Eigen::Matrix3d::Identity() + a_ * b_ - 2 * a_) * 0.25);
  const double epsilon = rounding<T>();
  CHECK(number(T(v.dot(w))) == Approx(v_.dot(w_)).epsilon(epsilon));
  CHECK(number(T(v.transpose() * w)) == Approx(v_.dot(w_)).epsilon(epsilon));
  CHECK(number(T(a.trace())) == Approx(a_.trace()).epsilon(epsilon));
  CHECK(number(T(a.determinant())) == Approx(a_.determinant()).epsilon(epsilon));
  CHECK(number(T(v.norm())) == Approx(v_.norm()).epsilon(epsilon));
  CHECK(number(T(a.cwiseProduct(b).sum())) == Approx(a_.cwiseProduct(b_).sum()).epsilon(epsilon));
}

TEMPLATE_TEST_CASE("Matrices of double stand beside matrices of any scalar", "", Doubles8, DualPack) {
  using T = TestType;
  const Eigen::Matrix<double, 3, 8> x_ = matrix<double, 3, 8>(1);
  const Eigen::Matrix<T, 3, 8> x = matrix<T, 3, 8>(1);
  const Eigen::Matrix<double, 8, 3> modes = matrix<double, 8, 3>(2);
  const Eigen::Matrix<double, 8, 1> one = matrix<double, 8, 1>(5);
  check_equal(Eigen::Matrix<T, 3, 3>(x * modes), x_.lazyProduct(modes));
  check_equal(Eigen::Matrix<T, 8, 3>(modes * (x * modes)), modes.lazyProduct(x_.lazyProduct(modes)));
  check_equal(Eigen::Matrix<T, 3, 1>(x * one), x_.lazyProduct(one));
  check_equal(Eigen::Matrix<T, 3, 8>(x + x_), 2 * x_);
}

TEMPLATE_TEST_CASE("Products of any size, fixed or not, need no branch on a value", "", Doubles8, DualPack) {
  using T = TestType;
  const Eigen::Matrix<double, 12, 12> k_ = matrix<double, 12, 12>(1);
  const Eigen::Matrix<double, 12, 1> u_ = matrix<double, 12, 1>(2);
  const Eigen::Matrix<T, 12, 12> k = matrix<T, 12, 12>(1);
  const Eigen::Matrix<T, 12, 1> u = matrix<T, 12, 1>(2);
  check_equal(Eigen::Matrix<T, 12, 1>(k * u), k_.lazyProduct(u_));
  check_equal(Eigen::Matrix<T, 1, 12>(u.transpose() * k), u_.transpose().lazyProduct(k_));
  const Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic> dynamic = k;
  check_equal(Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>(dynamic * dynamic), k_.lazyProduct(k_));
  check_equal(Eigen::Matrix<T, 3, 1>(k.template topRows<3>() * dynamic.col(0)), k_.topRows<3>().lazyProduct(k_.col(0)));
}

TEST_CASE("Jacobi's formula: d(det A)/dA = det(A) A^-T, by dual numbers") {
  using D = Dual<double, 9>;
  const Eigen::Matrix3d a = matrix<double, 3, 3>(1);
  Eigen::Matrix<D, 3, 3> x;
  for (int i = 0; i < 9; ++i) x(i) = D::variable(a(i), static_cast<std::size_t>(i));
  const D determinant = x.determinant();
  const Eigen::Matrix3d cofactor = a.determinant() * a.inverse().transpose();
  for (int i = 0; i < 9; ++i)
    CHECK(determinant.derivative(static_cast<std::size_t>(i)) == Approx(cofactor(i)).epsilon(1e-13));
}

TEST_CASE("d(A^-1) = -A^-1 dA A^-1, by dual numbers of packs") {
  using P = Pack<double, 8>;
  using D = Dual<P, 1>;
  const Eigen::Matrix<P, 3, 3> a = matrix<P, 3, 3>(1), da = matrix<P, 3, 3>(2);
  Eigen::Matrix<D, 3, 3> x;
  for (int i = 0; i < 9; ++i) x(i) = D(a(i), {da(i)});
  const Eigen::Matrix<D, 3, 3> inverse = x.inverse();
  const Eigen::Matrix<P, 3, 3> exact = -(a.inverse() * da * a.inverse());
  for (int i = 0; i < 9; ++i) CHECK(inverse(i).derivative(0)[3] == Approx(exact(i)[3]).epsilon(1e-12));
}

TEST_CASE("A dual of double, whose comparison is a bool, runs through Eigen's decompositions") {
  using D = Dual<double, 9>;
  const Eigen::Matrix3d a = matrix<double, 3, 3>(1);
  const Eigen::Vector3d b = matrix<double, 3, 1>(2);
  Eigen::Matrix<D, 3, 3> x;
  for (int i = 0; i < 9; ++i) x(i) = D::variable(a(i), static_cast<std::size_t>(i));
  const Eigen::Matrix<D, 3, 1> solution = x.partialPivLu().solve(b.cast<D>());
  const Eigen::Vector3d s = a.inverse() * b;
  for (int i = 0; i < 3; ++i) {
    CHECK(solution(i).value() == Approx(s(i)).epsilon(1e-13));
    for (int k = 0; k < 9; ++k)  // ds = -A^-1 dA s
      CHECK(solution(i).derivative(static_cast<std::size_t>(k)) ==
            Approx(-a.inverse()(i, k % 3) * s(k / 3)).epsilon(1e-12).margin(1e-13));
  }
}
