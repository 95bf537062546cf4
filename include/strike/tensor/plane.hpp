#pragma once
#include <limits>

#include <strike/tensor/tensor.hpp>

namespace strike {

/// Not aligned, so that a state that holds one has no gaps.
template <class T>
using Vector2 = Eigen::Matrix<T, 2, 1, Eigen::DontAlign>;

/// Symmetric tensor of second order in a plane, by its three components.
template <class T>
struct PlaneTensor {
  T xx{}, yy{}, xy{};

  static PlaneTensor isotropic(const T& p) { return {p, p, T(0)}; }

  friend PlaneTensor operator+(const PlaneTensor& a, const PlaneTensor& b) {
    return {a.xx + b.xx, a.yy + b.yy, a.xy + b.xy};
  }
  friend PlaneTensor operator-(const PlaneTensor& a, const PlaneTensor& b) {
    return {a.xx - b.xx, a.yy - b.yy, a.xy - b.xy};
  }
  friend PlaneTensor operator*(const T& c, const PlaneTensor& a) { return {c * a.xx, c * a.yy, c * a.xy}; }
  PlaneTensor& operator+=(const PlaneTensor& b) { return *this = *this + b; }
  template <class Condition>
  friend PlaneTensor select(const Condition& c, const PlaneTensor& a, const PlaneTensor& b) {
    return {select(c, a.xx, b.xx), select(c, a.yy, b.yy), select(c, a.xy, b.xy)};
  }
};

template <class T>
T trace(const PlaneTensor<T>& a) {
  return a.xx + a.yy;
}

/// a : b = a_ij b_ij.
template <class T>
T double_dot(const PlaneTensor<T>& a, const PlaneTensor<T>& b) {
  return a.xx * b.xx + a.yy * b.yy + 2.0 * (a.xy * b.xy);
}

/// Von Mises equivalent of a plane stress.
template <class T>
T equivalent_stress(const PlaneTensor<T>& a) {
  return sqrt(a.xx * a.xx + a.yy * a.yy - a.xx * a.yy + 3.0 * (a.xy * a.xy));
}

/// The larger eigenvalue of [xx, xy; xy, yy], given xy^2.
template <class T>
T largest_eigenvalue(const T& xx, const T& yy, const T& xy_squared) {
  const T half = 0.5 * (xx - yy);
  const T p2 = max(T(std::numeric_limits<RealOf<T>>::min()), half * half + xy_squared);
  return 0.5 * (xx + yy) + p2 * rsqrt(p2);
}
template <class T>
T largest_eigenvalue(const PlaneTensor<T>& a) {
  return largest_eigenvalue<T>(a.xx, a.yy, a.xy * a.xy);
}
/// The larger of the two in the plane.
template <class T>
T largest_principal(const PlaneTensor<T>& a) {
  return largest_eigenvalue(a);
}

}  // namespace strike
