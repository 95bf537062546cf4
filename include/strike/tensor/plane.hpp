#pragma once
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

/// The larger eigenvalue.
template <class T>
T largest_eigenvalue(const PlaneTensor<T>& a) {
  const T half = 0.5 * (a.xx - a.yy);
  return 0.5 * trace(a) + sqrt(half * half + a.xy * a.xy);
}

}  // namespace strike
