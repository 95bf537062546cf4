#include <array>
#include <cmath>
#include <concepts>
#include <numbers>
#include <random>
#include <utility>

#include <Eigen/Dense>

#include <strike/scalar/dual.hpp>
#include <strike/scalar/pack.hpp>
#include <strike/tensor/tensor.hpp>

#include "support/catch.hpp"
#include "support/sanitized.hpp"

/// Types of the formulas that a user writes in Eigen's numbers.
template <class V>
struct FormulasWithout {
  static const V& a;
  static const Eigen::Matrix<double, 3, 8>& X;
  using Sum = decltype(a + a);
  using Difference = decltype(a - a);
  using Opposite = decltype(-a);
  using Multiple = decltype(2.0 * a);
  using WholeMultiple = decltype(2 * a);
  using Quotient = decltype(a / 2.0);
  using Product = decltype(a * a.transpose());
  using Cross = decltype(a.cross(a));
  using NodalSum = decltype(X + X);
  using NodalMultiple = decltype(2.0 * X);
};

using namespace strike;

template <class V>
struct FormulasWith {
  static const V& a;
  static const Eigen::Matrix<double, 3, 8>& X;
  using Sum = decltype(a + a);
  using Difference = decltype(a - a);
  using Opposite = decltype(-a);
  using Multiple = decltype(2.0 * a);
  using WholeMultiple = decltype(2 * a);
  using Quotient = decltype(a / 2.0);
  using Product = decltype(a * a.transpose());
  using Cross = decltype(a.cross(a));
  using NodalSum = decltype(X + X);
  using NodalMultiple = decltype(2.0 * X);
};

namespace {

template <class A, class B>
inline constexpr bool same_formulas =
    std::same_as<typename A::Sum, typename B::Sum> && std::same_as<typename A::Difference, typename B::Difference> &&
    std::same_as<typename A::Opposite, typename B::Opposite> &&
    std::same_as<typename A::Multiple, typename B::Multiple> &&
    std::same_as<typename A::WholeMultiple, typename B::WholeMultiple> &&
    std::same_as<typename A::Quotient, typename B::Quotient> &&
    std::same_as<typename A::Product, typename B::Product> && std::same_as<typename A::Cross, typename B::Cross> &&
    std::same_as<typename A::NodalSum, typename B::NodalSum> &&
    std::same_as<typename A::NodalMultiple, typename B::NodalMultiple>;

}  // namespace

// `using namespace strike` changes no formula of Eigen's.
static_assert(same_formulas<FormulasWithout<Eigen::Vector3d>, FormulasWith<Eigen::Vector3d>>);
static_assert(!std::same_as<FormulasWith<Eigen::Vector3d>::Sum, Eigen::Vector3d>);
// In vectors of packs and dual numbers a sum is a vector.
static_assert(std::same_as<FormulasWithout<Vector3<Pack<double, 8>>>::Sum, Vector3<Pack<double, 8>>>);
static_assert(std::same_as<FormulasWithout<Vector3<Dual<double, 2>>>::Multiple, Vector3<Dual<double, 2>>>);
// Functions of built-in numbers are those of <cmath>.
static_assert(std::same_as<decltype(min(1.0, 2.0)), double> && std::same_as<decltype(max(1.0F, 2.0F)), float>);
static_assert(std::same_as<decltype(abs(-1.5)), double> && std::same_as<decltype(abs(-1)), int>);
static_assert(std::same_as<decltype(sqrt(2.0F)), float> && std::same_as<decltype(pow(2.0, 2)), double>);

using Tensor = SymmetricTensor<double>;

namespace {

Matrix3<double> random_matrix(std::mt19937& random) {
  std::uniform_real_distribution<double> component(-1, 1);
  return Matrix3<double>::NullaryExpr([&] { return component(random); });
}

double relative_excess(const Tensor& A) {
  const Eigen::SelfAdjointEigenSolver<Matrix3<double>> exact(A.matrix(), Eigen::EigenvaluesOnly);
  return largest_eigenvalue(A) / exact.eigenvalues()(2) - 1;
}

/// R diag(l) R^T with a random R.
Tensor with_eigenvalues(const Vector3<double>& l, std::mt19937& random) {
  const Matrix3<double> R = Eigen::HouseholderQR<Matrix3<double>>(random_matrix(random)).householderQ();
  return symmetric_part<double>(R * l.asDiagonal() * R.transpose());
}

constexpr double bound = 4e-4;      // stated at the function
constexpr double rounding = 1e-15;  // some units in the last place of a dozen operations

}  // namespace

TEST_CASE("tensor: invariants, products and parts are those of the full matrix") {
  std::mt19937 random(1);
  for (int i = 0; i < 100; ++i) {
    const Matrix3<double> L = random_matrix(random), K = random_matrix(random);
    const Matrix3<double> a = 0.5 * (L + L.transpose()), b = 0.5 * (K + K.transpose());
    const Tensor A = symmetric_part(L), B = symmetric_part(K);
    const Vector3<double> x = K.col(0), y = K.col(1);
    CHECK((A.matrix() - a).norm() < rounding);
    CHECK(trace(A) == Approx(a.trace()).epsilon(0).margin(rounding));
    CHECK(double_dot(A, B) == Approx(a.cwiseProduct(b).sum()).epsilon(0).margin(4 * rounding));
    CHECK(determinant(A) == Approx(a.determinant()).epsilon(0).margin(4 * rounding));
    CHECK(quadratic_form(A, x) == Approx(x.dot(a * x)).epsilon(0).margin(4 * rounding));
    CHECK((cross(x, y) - x.cross(y)).norm() < rounding);
    CHECK((times(L, x) - L * x).norm() < 2 * rounding);
    Matrix3<double> xy = outer(x, y);
    CHECK((xy - x * y.transpose()).norm() < rounding);
    add_outer(xy, y, x);
    CHECK((xy - x * y.transpose() - y * x.transpose()).norm() < 2 * rounding);
    CHECK(((L - a) * x - cross(axial_vector(L), x)).norm() < 2 * rounding);  // skew(L) x = w cross x
    CHECK(((2.0 * A - B + Tensor::isotropic(3.0)).matrix() - (2 * a - b + 3 * Matrix3<double>::Identity())).norm() <
          4 * rounding);

    const Tensor s = deviator(A);
    CHECK(std::abs(trace(s)) < rounding);
    const Vector3<double> p = Eigen::SelfAdjointEigenSolver<Matrix3<double>>(a).eigenvalues();
    const double von_mises =
        std::sqrt(0.5 * (std::pow(p(0) - p(1), 2) + std::pow(p(1) - p(2), 2) + std::pow(p(2) - p(0), 2)));
    CHECK(equivalent_stress(s) == Approx(von_mises).epsilon(1e-14));
  }
}

TEST_CASE("tensor: the equivalent stress is the stress of a tension test and sqrt(3) times that of a shear test") {
  CHECK(equivalent_stress(deviator(Tensor{.xx = 7})) == Approx(7).epsilon(rounding));
  CHECK(equivalent_stress(deviator(Tensor{.yz = 7})) == Approx(7 * std::numbers::sqrt3).epsilon(rounding));
  CHECK(equivalent_stress(deviator(Tensor::isotropic(7))) == 0);
}

TEST_CASE("tensor: the largest eigenvalue is never below the true one and at most 0.15 % above, on random tensors") {
  std::mt19937 random(2);
  double least = 1, most = -1;
  for (int i = 0; i < testing::repeated(100000); ++i) {
    const Matrix3<double> B = random_matrix(random);
    const double excess = relative_excess(symmetric_part<double>(B * B.transpose()));
    least = std::min(least, excess);
    most = std::max(most, excess);
  }
  CHECK(least > -rounding);
  CHECK(most < bound);
}

TEST_CASE("tensor: the largest eigenvalue keeps its bounds over all shapes of tensors, nearly degenerate ones too") {
  std::mt19937 random(3);
  double least = 1, most = -1;
  for (int i = 0; i <= 400; i += 400 / testing::repeated(400))
    for (int j = 0; j <= 40; ++j) {
      const double middle = std::pow(10.0, -0.05 * i), smallest = middle * j / 40;  // of 1
      for (const double l2 : {middle, 1 - middle}) {
        const double excess = relative_excess(with_eigenvalues({1, l2, std::min(l2, smallest)}, random));
        least = std::min(least, excess);
        most = std::max(most, excess);
      }
    }
  CHECK(least > -4 * rounding);  // the rotation of the diagonal rounds too
  CHECK(most < bound);
}

TEST_CASE("tensor: the largest eigenvalue of spheres, discs, needles and nothing") {
  for (const double scale : {1e-150, 1e-20, 1.0, 1e20, 1e150}) {  // whose square is finite
    CAPTURE(scale);
    for (const Tensor& A :
         {Tensor{1, 1, 1, 0, 0, 0}, Tensor{1, 1, 0, 0, 0, 0}, Tensor{0, 1, 1, 0, 0, 0}, Tensor{1, 0, 0, 0, 0, 0},
          Tensor{0, 0, 1, 0, 0, 0}, Tensor{1, 1, 1 + 1e-14, 0, 0, 0}, Tensor{.5, .5, 0, .5, 0, 0}}) {
      const double excess = relative_excess(scale * A);
      CHECK(excess > -rounding);
      CHECK(excess < bound);
    }
  }
}

TEST_CASE("tensor: the largest eigenvalue keeps its bounds in lanes of float") {
  std::mt19937 random(4);
  using P = Pack<float, 8>;
  const std::array component{&SymmetricTensor<P>::xx, &SymmetricTensor<P>::yy, &SymmetricTensor<P>::zz,
                             &SymmetricTensor<P>::xy, &SymmetricTensor<P>::yz, &SymmetricTensor<P>::zx};
  double least = 1, most = -1;
  for (int i = 0; i < 2000; ++i) {
    SymmetricTensor<P> A;
    for (std::size_t l = 0; l < 8; ++l) {
      const Matrix3<double> B = random_matrix(random);
      const Matrix3<double> a = i % 2 == 0 ? Matrix3<double>(B * B.transpose())
                                           : with_eigenvalues({1, 1 - 1e-4 * B(0, 0) * B(0, 0), 0.1}, random).matrix();
      const std::array values{a(0, 0), a(1, 1), a(2, 2), a(0, 1), a(1, 2), a(2, 0)};
      for (std::size_t c = 0; c < 6; ++c) set_lane(A.*component[c], l, static_cast<float>(values[c]));
    }
    const P L1 = largest_eigenvalue(A);
    for (std::size_t l = 0; l < 8; ++l) {
      const auto at = [&](std::size_t c) { return static_cast<double>(lane(A.*component[c], l)); };
      const Tensor a{at(0), at(1), at(2), at(3), at(4), at(5)};
      const double exact = Eigen::SelfAdjointEigenSolver<Matrix3<double>>(a.matrix()).eigenvalues()(2);
      least = std::min(least, static_cast<double>(lane(L1, l)) / exact - 1);
      most = std::max(most, static_cast<double>(lane(L1, l)) / exact - 1);
    }
  }
  CHECK(least > -5e-7);  // some units in the last place of a float
  CHECK(most < bound);
}
