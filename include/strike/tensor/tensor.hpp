#pragma once
#include <concepts>
#include <type_traits>
#include <utility>

#include <Eigen/Core>

#include <strike/scalar/eigen.hpp>
#include <strike/scalar/math.hpp>
#include <strike/scalar/scalar.hpp>

namespace strike {

template <class T>
using Vector3 = Eigen::Matrix<T, 3, 1>;
template <class T>
using Matrix3 = Eigen::Matrix<T, 3, 3>;

template <class T>
Vector3<T> cross(const Vector3<T>& a, const Vector3<T>& b) {
  return {a(1) * b(2) - a(2) * b(1), a(2) * b(0) - a(0) * b(2), a(0) * b(1) - a(1) * b(0)};
}

namespace detail {

/// The least square of which the root has a derivative that is a number too.
template <class T>
inline constexpr double least_square = sizeof(RealOf<T>) == 4 ? 5e-26 : 8e-206;

/// The matrix of the components f(0), f(1), ... column by column; unrolled at every level of optimisation.
template <class T, int n, class F>
Eigen::Matrix<T, 3, n> by_component(F f) {
  Eigen::Matrix<T, 3, n> a;
  [&]<int... i>(std::integer_sequence<int, i...>) { ((a(i) = f(i)), ...); }(std::make_integer_sequence<int, 3 * n>{});
  return a;
}

}  // namespace detail

// Sums and multiples of vectors go by components, not by Eigen's expressions: the same code at a fraction of what those
// take to compile, and `auto` names a vector. These operators are an exact match where Eigen's need a conversion. For
// Packs and Duals they are found by the namespace of the number. For built-in numbers only code in strike::detail finds
// them: a user's own formulas, with `using namespace strike` too, remain Eigen's.

template <detail::Composite T, int n>
  requires(n > 0)
Eigen::Matrix<T, 3, n> operator+(const Eigen::Matrix<T, 3, n>& a, const Eigen::Matrix<T, 3, n>& b) {
  return detail::by_component<T, n>([&](int i) -> T { return a(i) + b(i); });
}
template <detail::Composite T, int n>
  requires(n > 0)
Eigen::Matrix<T, 3, n> operator-(const Eigen::Matrix<T, 3, n>& a, const Eigen::Matrix<T, 3, n>& b) {
  return detail::by_component<T, n>([&](int i) -> T { return a(i) - b(i); });
}
template <detail::Composite T, int n>
  requires(n > 0)
Eigen::Matrix<T, 3, n> operator-(const Eigen::Matrix<T, 3, n>& a) {
  return detail::by_component<T, n>([&](int i) -> T { return -a(i); });
}
template <class S, detail::Composite T, int n>
  requires(n > 0 && (std::same_as<S, T> || std::is_arithmetic_v<S>))
Eigen::Matrix<T, 3, n> operator*(const S& factor, const Eigen::Matrix<T, 3, n>& a) {
  return detail::by_component<T, n>([&](int i) -> T { return factor * a(i); });
}

namespace detail {

template <std::floating_point T, int n>
  requires(n > 0)
Eigen::Matrix<T, 3, n> operator+(const Eigen::Matrix<T, 3, n>& a, const Eigen::Matrix<T, 3, n>& b) {
  return by_component<T, n>([&](int i) -> T { return a(i) + b(i); });
}
template <std::floating_point T, int n>
  requires(n > 0)
Eigen::Matrix<T, 3, n> operator-(const Eigen::Matrix<T, 3, n>& a, const Eigen::Matrix<T, 3, n>& b) {
  return by_component<T, n>([&](int i) -> T { return a(i) - b(i); });
}
template <std::floating_point T, int n>
  requires(n > 0)
Eigen::Matrix<T, 3, n> operator-(const Eigen::Matrix<T, 3, n>& a) {
  return by_component<T, n>([&](int i) -> T { return -a(i); });
}
template <class S, std::floating_point T, int n>
  requires(n > 0 && (std::same_as<S, T> || std::is_arithmetic_v<S>))
Eigen::Matrix<T, 3, n> operator*(const S& factor, const Eigen::Matrix<T, 3, n>& a) {
  return by_component<T, n>([&](int i) -> T { return factor * a(i); });
}
template <std::floating_point T, int n>
  requires(n > 0)
Eigen::Matrix<T, 3, n> operator*(const Eigen::Matrix<T, 3, n>& a, const std::type_identity_t<T>& factor) {
  return by_component<T, n>([&](int i) -> T { return a(i) * factor; });
}
template <std::floating_point T, int n>
  requires(n > 0)
Eigen::Matrix<T, 3, n> operator/(const Eigen::Matrix<T, 3, n>& a, const std::type_identity_t<T>& divisor) {
  return by_component<T, n>([&](int i) -> T { return a(i) / divisor; });
}
/// The unit vector along a vector; zero of zero.
inline Eigen::Vector3d direction(const Eigen::Vector3d& a) {
  const double length = a.norm();
  return length > 0 ? a / length : a;
}

}  // namespace detail

template <class T>
T dot(const Vector3<T>& a, const Vector3<T>& b) {
  return a(0) * b(0) + a(1) * b(1) + a(2) * b(2);
}

/// The matrix of these columns.
template <class T>
Matrix3<T> columns(const Vector3<T>& a, const Vector3<T>& b, const Vector3<T>& c) {
  return detail::by_component<T, 3>([&](int i) -> T { return i < 3 ? a(i) : i < 6 ? b(i - 3) : c(i - 6); });
}

template <class T, int n>
Vector3<T> column(const Eigen::Matrix<T, 3, n>& A, std::size_t j) {
  const int i = static_cast<int>(j);
  return {A(0, i), A(1, i), A(2, i)};
}
template <class T, int n>
void set_column(Eigen::Matrix<T, 3, n>& A, std::size_t j, const std::type_identity_t<Vector3<T>>& a) {
  const int i = static_cast<int>(j);
  A(0, i) = a(0), A(1, i) = a(1), A(2, i) = a(2);
}

/// A x.
template <class T>
Vector3<T> times(const Matrix3<T>& A, const Vector3<T>& x) {
  return detail::by_component<T, 1>([&](int i) -> T { return A(i, 0) * x(0) + A(i, 1) * x(1) + A(i, 2) * x(2); });
}

/// y - A x.
template <class T>
Vector3<T> minus_times(const Vector3<T>& y, const Matrix3<T>& A, const Vector3<T>& x) {
  return detail::by_component<T, 1>(
      [&](int i) -> T { return y(i) - A(i, 0) * x(0) - A(i, 1) * x(1) - A(i, 2) * x(2); });
}

/// a (x) b.
template <class T>
Matrix3<T> outer(const Vector3<T>& a, const Vector3<T>& b) {
  return detail::by_component<T, 3>([&](int i) -> T { return a(i % 3) * b(i / 3); });
}
/// A += a (x) b.
template <class T>
void add_outer(Matrix3<T>& A, const Vector3<T>& a, const Vector3<T>& b) {
  A = detail::by_component<T, 3>([&](int i) -> T { return A(i) + a(i % 3) * b(i / 3); });
}

/// Symmetric tensor of second order, by its six components.
template <class T>
struct SymmetricTensor {
  T xx{}, yy{}, zz{}, xy{}, yz{}, zx{};

  static SymmetricTensor isotropic(const T& p) { return {p, p, p, T(0), T(0), T(0)}; }

  friend SymmetricTensor operator+(const SymmetricTensor& a, const SymmetricTensor& b) {
    return {a.xx + b.xx, a.yy + b.yy, a.zz + b.zz, a.xy + b.xy, a.yz + b.yz, a.zx + b.zx};
  }
  friend SymmetricTensor operator-(const SymmetricTensor& a, const SymmetricTensor& b) {
    return {a.xx - b.xx, a.yy - b.yy, a.zz - b.zz, a.xy - b.xy, a.yz - b.yz, a.zx - b.zx};
  }
  friend SymmetricTensor operator*(const T& c, const SymmetricTensor& a) {
    return {c * a.xx, c * a.yy, c * a.zz, c * a.xy, c * a.yz, c * a.zx};
  }
  SymmetricTensor& operator+=(const SymmetricTensor& b) { return *this = *this + b; }
  template <class Condition>
  friend SymmetricTensor select(const Condition& c, const SymmetricTensor& a, const SymmetricTensor& b) {
    return {select(c, a.xx, b.xx), select(c, a.yy, b.yy), select(c, a.zz, b.zz),
            select(c, a.xy, b.xy), select(c, a.yz, b.yz), select(c, a.zx, b.zx)};
  }

  Matrix3<T> matrix() const { return columns<T>({xx, xy, zx}, {xy, yy, yz}, {zx, yz, zz}); }
};

template <class T>
T trace(const SymmetricTensor<T>& a) {
  return a.xx + a.yy + a.zz;
}

template <class T>
SymmetricTensor<T> deviator(const SymmetricTensor<T>& a) {
  const T mean = (1.0 / 3.0) * trace(a);
  return {a.xx - mean, a.yy - mean, a.zz - mean, a.xy, a.yz, a.zx};
}

/// a : b = a_ij b_ij.
template <class T>
T double_dot(const SymmetricTensor<T>& a, const SymmetricTensor<T>& b) {
  return a.xx * b.xx + a.yy * b.yy + a.zz * b.zz + 2.0 * (a.xy * b.xy + a.yz * b.yz + a.zx * b.zx);
}

/// x . A x.
template <class T>
T quadratic_form(const SymmetricTensor<T>& A, const Vector3<T>& x) {
  return A.xx * x(0) * x(0) + A.yy * x(1) * x(1) + A.zz * x(2) * x(2) +
         2.0 * (A.xy * x(0) * x(1) + A.yz * x(1) * x(2) + A.zx * x(2) * x(0));
}

template <class T>
T determinant(const SymmetricTensor<T>& a) {
  return a.xx * (a.yy * a.zz - a.yz * a.yz) - a.xy * (a.xy * a.zz - a.yz * a.zx) + a.zx * (a.xy * a.yz - a.yy * a.zx);
}

/// A x.
template <class T>
Vector3<T> operator*(const SymmetricTensor<T>& A, const Vector3<T>& x) {
  return {A.xx * x(0) + A.xy * x(1) + A.zx * x(2), A.xy * x(0) + A.yy * x(1) + A.yz * x(2),
          A.zx * x(0) + A.yz * x(1) + A.zz * x(2)};
}

/// x x^T.
template <class T>
SymmetricTensor<T> outer_square(const Vector3<T>& x) {
  return {x(0) * x(0), x(1) * x(1), x(2) * x(2), x(0) * x(1), x(1) * x(2), x(2) * x(0)};
}

template <class T>
SymmetricTensor<T> inverse(const SymmetricTensor<T>& a) {
  const T xx = a.yy * a.zz - a.yz * a.yz, xy = a.yz * a.zx - a.xy * a.zz, zx = a.xy * a.yz - a.yy * a.zx;
  const T w = 1.0 / (a.xx * xx + a.xy * xy + a.zx * zx);
  return {w * xx, w * (a.zz * a.xx - a.zx * a.zx), w * (a.xx * a.yy - a.xy * a.xy),
          w * xy, w * (a.zx * a.xy - a.xx * a.yz), w * zx};
}

/// Von Mises equivalent of a deviator s: sqrt(3/2 s : s).
template <class T>
T equivalent_stress(const SymmetricTensor<T>& s) {
  return sqrt(1.5 * double_dot(s, s));
}

/// sym(A) = (A + A^T)/2.
template <class T>
SymmetricTensor<T> symmetric_part(const Matrix3<T>& A) {
  return {A(0, 0), A(1, 1), A(2, 2), 0.5 * (A(0, 1) + A(1, 0)), 0.5 * (A(1, 2) + A(2, 1)), 0.5 * (A(2, 0) + A(0, 2))};
}

/// Axial vector w of skew(A) = (A - A^T)/2: skew(A) x = w cross x.
template <class T>
Vector3<T> axial_vector(const Matrix3<T>& A) {
  return {0.5 * (A(2, 1) - A(1, 2)), 0.5 * (A(0, 2) - A(2, 0)), 0.5 * (A(1, 0) - A(0, 1))};
}

/// Largest eigenvalue of a positive semidefinite tensor, from above: never less than the true value by more than
/// rounding, and at most 0.04 % more. With q the mean eigenvalue, s the deviator and p^2 = s:s/6 it is q + 2 p c, where
/// c is the largest root of 4c^3 - 3c = r = det(s/p)/2: c = cos(2/3 acos(t/sqrt(2))), smooth in t = sqrt(1 + r). The
/// cubic is the minimax one (Remez) of the error 7e-5, raised by that.
template <class T>
T largest_eigenvalue(const SymmetricTensor<T>& A) {
  const T q = (1.0 / 3.0) * trace(A);
  const SymmetricTensor<T> s = deviator(A);
  const T p2 = (1.0 / 6.0) * double_dot(s, s) + 1e-8 * q * q;  // a sphere has no direction: any c serves there
  const T per_p = rsqrt(p2);
  const T t = sqrt(max(T(0.0), min(T(2.0), 1.0 + 0.5 * determinant(per_p * s))));
  const T c = 0.5001399 + t * (0.4064404 + t * (-0.0480203 + t * 0.00751198));
  return q + 2.0 * (p2 * per_p) * c;
}

/// Largest eigenvalue of any tensor: sharp where `largest_eigenvalue` is a quick bound. Of 4c^3 - 3c = r Newton's steps
/// solve the form (2c - 1) sqrt(1 + c) = t, t = sqrt(1 + r), which has no double root where the two larger eigenvalues
/// meet; there t, and with it the result, is known to the square root of rounding of the deviator.
template <class T>
T largest_principal(const SymmetricTensor<T>& A) {
  const SymmetricTensor<T> s = deviator(A);
  const T p2 = max(T(detail::least_square<T>), (1.0 / 6.0) * double_dot(s, s)), per_p = rsqrt(p2);
  const T t = sqrt(max(T(0.0), min(T(2.0), 1.0 + 0.5 * determinant(per_p * s))));
  T c = 0.5 + t * (0.4064404 + t * (-0.0480203 + t * 0.00751198));
  for (int i = 0; i < 2; ++i) c -= (2.0 / 3.0) * ((2.0 * c - 1.0) * (1.0 + c) - t * sqrt(1.0 + c)) / (2.0 * c + 1.0);
  return (1.0 / 3.0) * trace(A) + 2.0 * (p2 * per_p) * c;
}

}  // namespace strike
