#pragma once
#include <concepts>

#include <strike/tensor/tensor.hpp>

namespace strike {

/// Q A Q^T.
template <class T>
SymmetricTensor<T> rotated(const Matrix3<T>& Q, const SymmetricTensor<T>& A) {
  const Vector3<T> x = times<T>(Q, {A.xx, A.xy, A.zx}), y = times<T>(Q, {A.xy, A.yy, A.yz}),
                   z = times<T>(Q, {A.zx, A.yz, A.zz});
  const auto component = [&](int i, int j) -> T { return x(i) * Q(j, 0) + y(i) * Q(j, 1) + z(i) * Q(j, 2); };
  return {component(0, 0), component(1, 1), component(2, 2), component(0, 1), component(1, 2), component(2, 0)};
}

/// Rotation of the spatial tensors of a state by the spin of an element in one step.
///
/// Requirements
/// 1. `turn(w)`, for the axial vector w of the incremental spin, skew(L) dt at mid-step: a function that maps spatial
///    tensors and vectors at the start of the step to those that a pure rotation leaves at its end.
/// Laws: no spin changes nothing.
/// Models: HughesWinget, Jaumann.
template <class R>
concept Rotation = requires(const R rotation, const Vector3<double> w, const SymmetricTensor<double> A) {
  { rotation.turn(w)(A) } -> std::same_as<SymmetricTensor<double>>;
  { rotation.turn(w)(w) } -> std::same_as<Vector3<double>>;
};

/// The Jaumann rate to first order: A + W A - A W. Cheap; in a rotation by the angle theta per step it lets the
/// in-plane deviator grow by sqrt(1 + 4 theta^2).
struct Jaumann {
  template <class T>
  struct Rotator {
    Vector3<T> w;
    SymmetricTensor<T> operator()(const SymmetricTensor<T>& A) const {
      const T x = w(0), y = w(1), z = w(2);
      return {A.xx + 2.0 * (y * A.zx - z * A.xy),
              A.yy + 2.0 * (z * A.xy - x * A.yz),
              A.zz + 2.0 * (x * A.yz - y * A.zx),
              A.xy + y * A.yz - x * A.zx + z * (A.xx - A.yy),
              A.yz + z * A.zx - y * A.xy + x * (A.yy - A.zz),
              A.zx + x * A.xy - z * A.yz + y * (A.zz - A.xx)};
    }
    Vector3<T> operator()(const Vector3<T>& a) const { return a + cross(w, a); }
  };
  template <class T>
  Rotator<T> turn(const Vector3<T>& w) const {
    return {w};
  }
};

/// The rotation of Hughes and Winget (1980, eq. 24): Q = I + (W + W^2/2)/(1 + |w|^2/4). Exactly orthogonal, and with
/// mid-step kinematics exactly the rotation of a rigid motion.
struct HughesWinget {
  template <class T>
  struct Rotator {
    Matrix3<T> Q;
    SymmetricTensor<T> operator()(const SymmetricTensor<T>& A) const { return rotated(Q, A); }
    Vector3<T> operator()(const Vector3<T>& a) const { return times(Q, a); }
  };
  template <class T>
  Rotator<T> turn(const Vector3<T>& w) const {
    const T x = w(0), y = w(1), z = w(2);
    const T s = 1.0 / (1.0 + 0.25 * (x * x + y * y + z * z));
    const T h = 0.5 * s;
    return {columns<T>({1.0 - h * (y * y + z * z), h * x * y + s * z, h * z * x - s * y},
                       {h * x * y - s * z, 1.0 - h * (z * z + x * x), h * y * z + s * x},
                       {h * z * x + s * y, h * y * z - s * x, 1.0 - h * (x * x + y * y)})};
  }
};

}  // namespace strike
