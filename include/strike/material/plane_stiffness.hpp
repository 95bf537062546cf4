#pragma once
#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Core>

#include <strike/material/kinematics.hpp>
#include <strike/scalar/bisect.hpp>
#include <strike/tensor/plane.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike {

/// Stiffness in plane stress: (xx, yy, xy) of the stress from the strains (xx, yy, gamma_xy), gamma_xy = 2 eps_xy.
using PlaneStiffness = Eigen::Matrix<double, 3, 3>;
/// Symmetric 2 x 2 matrix, such as the stiffness from (gamma_xz, gamma_yz) to (Q_x, Q_y). Not aligned.
using Matrix2 = Eigen::Matrix<double, 2, 2, Eigen::DontAlign>;

/// Axes in the plane that are turned by an angle about the normal, by its cosine and sine.
template <class T>
struct PlaneTurn {
  T cosine{1.0}, sine{0.0};

  /// Components along the turned axes, ...
  template <class U>
  PlaneTensor<U> into(const PlaneTensor<U>& a) const {
    return turned(a, U(cosine * sine));
  }
  template <class U>
  Vector2<U> into(const Vector2<U>& a) const {
    return {U(cosine) * a(0) + U(sine) * a(1), U(cosine) * a(1) - U(sine) * a(0)};
  }
  /// ... and from them back.
  template <class U>
  PlaneTensor<U> back(const PlaneTensor<U>& a) const {
    return turned(a, U(-cosine * sine));
  }
  template <class U>
  Vector2<U> back(const Vector2<U>& a) const {
    return {U(cosine) * a(0) - U(sine) * a(1), U(cosine) * a(1) + U(sine) * a(0)};
  }

 private:
  template <class U>
  PlaneTensor<U> turned(const PlaneTensor<U>& a, const U& cs) const {
    const U s2 = U(sine * sine), shift = s2 * (a.yy - a.xx) + 2.0 * cs * a.xy;
    return {a.xx + shift, a.yy - shift, cs * (a.yy - a.xx) + (1.0 - 2.0 * s2) * a.xy};
  }
};

/// The turn by an angle in degrees, exact at its right angles; half a turn is none, for tensors do not see it.
inline PlaneTurn<double> turn_by_degrees(double angle) {
  const double a = std::remainder(angle, 180);
  if (a == 0) return {1, 0};
  if (std::abs(a) == 90) return {0, 1};
  return {std::cos(a * std::numbers::pi / 180), std::sin(a * std::numbers::pi / 180)};
}

/// The stiffness in axes from which those of `own` are turned.
inline PlaneStiffness turned_back(const PlaneStiffness& own, const PlaneTurn<double>& turn) {
  const double c = turn.cosine, s = turn.sine;
  PlaneStiffness strain;
  strain << c * c, s * s, c * s, s * s, c * c, -c * s, -2 * c * s, 2 * c * s, c * c - s * s;
  return strain.transpose() * own * strain;
}
inline Matrix2 turned_back(const Matrix2& own, const PlaneTurn<double>& turn) {
  Matrix2 R;
  R << turn.cosine, turn.sine, -turn.sine, turn.cosine;
  return R.transpose() * own * R;
}

namespace detail {

/// The stiffness of an isotropic layer.
inline PlaneStiffness plane_stiffness(const PlaneModuli<double>& m) {
  PlaneStiffness Q;
  const double lambda = m.normal - 2 * m.shear;
  Q << m.normal, lambda, 0, lambda, m.normal, 0, 0, 0, m.shear;
  return Q;
}

/// Factors from engineering strains to an orthonormal basis: sqrt(2) eps_xy for the third.
inline PlaneStiffness orthonormal(const PlaneStiffness& Q) {
  const Eigen::Vector3d unit(1, 1, std::numbers::sqrt2);
  return unit.asDiagonal() * Q * unit.asDiagonal();
}
inline double trace_of(const PlaneStiffness& Q) { return Q(0, 0) + Q(1, 1) + 2 * Q(2, 2); }

/// The isotropic moduli of least `normal` whose energy is nowhere below that of Q: with x = 2 (normal - shear) on equal
/// strains v and y = 2 shear on deviators d,
///   y > mu_i,   x = Q_vv + sum_i Q_vi^2/(y - mu_i),   mu_i the eigenvalues of Q_dd,
/// normal = (x + y)/2. Of an isotropic Q they are its own, of fibres alone along one axis x = y.
inline PlaneModuli<double> isotropic_bound(const PlaneStiffness& stiffness) {
  const PlaneStiffness Q = orthonormal(stiffness);
  const double vv = 0.5 * (Q(0, 0) + Q(1, 1)) + Q(0, 1), dd = 0.5 * (Q(0, 0) + Q(1, 1)) - Q(0, 1), ss = Q(2, 2),
               vd = 0.5 * (Q(0, 0) - Q(1, 1)), vs = (Q(0, 2) + Q(1, 2)) / std::numbers::sqrt2,
               ds = (Q(0, 2) - Q(1, 2)) / std::numbers::sqrt2;
  const double middle = 0.5 * (dd + ss), half = std::hypot(0.5 * (dd - ss), ds),
               phi = 0.5 * std::atan2(2 * ds, dd - ss);
  const double mu0 = middle + half, mu1 = middle - half;
  const double c0 = std::cos(phi) * vd + std::sin(phi) * vs, c1 = std::cos(phi) * vs - std::sin(phi) * vd;
  const double c = std::hypot(c0, c1);
  if (c <= 1e-14 * (std::abs(vv) + mu0)) return {0.5 * (vv + mu0), 0.5 * mu0};
  const auto square = [](double x) { return x * x; };
  const auto falls = [&](double y) { return square(c0 / (y - mu0)) + square(c1 / (y - mu1)) > 1; };
  const double y = bisect(Bracket<double>{mu0, mu0 + 1.001 * c}, falls, 60).upper;
  const auto part = [&](double ci, double mu) { return ci == 0 ? 0 : ci * ci / std::max(y - mu, std::abs(ci)); };
  const double x = vv + part(c0, mu0) + part(c1, mu1);
  return {0.5 * (x + y), 0.5 * y};
}

}  // namespace detail

}  // namespace strike
