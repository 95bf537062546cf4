#pragma once
#include <strike/element/element.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike {

/// The gradient of the linear tetrahedron from the edges that leave its first corner, a, b and c:
///   6 V = a . b x c,   g_k = d(6 V)/d x_k = b x c, c x a, a x b at the others, and minus their sum at the first.
template <class T>
struct Tet4Gradient {
  Vector3<T> g1, g2, g3;
  T volume;

  explicit Tet4Gradient(const Nodal<T, 4>& x) {
    const Vector3<T> x0 = column(x, 0), a = column(x, 1) - x0, b = column(x, 2) - x0, c = column(x, 3) - x0;
    g1 = cross(b, c), g2 = cross(c, a), g3 = cross(a, b);
    volume = T(1.0 / 6.0) * dot(a, g1);
  }

  Vector3<T> g0() const { return -(g1 + g2 + g3); }

  /// L_ij = du_i/dx_j = sum_k (u_k - u_0) (x) g_k/(6 V).
  Matrix3<T> gradient_of(const Nodal<T, 4>& u, const T& per_volume) const {
    const Vector3<T> u0 = column(u, 0);
    Matrix3<T> L = outer<T>(column(u, 1) - u0, g1);
    add_outer<T>(L, column(u, 2) - u0, g2), add_outer<T>(L, column(u, 3) - u0, g3);
    return T(T(1.0 / 6.0) * per_volume) * L;
  }
  /// 36 B_iI B_jI.
  SymmetricTensor<T> squared() const {
    return outer_square(g1) + outer_square(g2) + outer_square(g3) + outer_square(g0());
  }
  /// f_I = sigma g_I/6.
  Nodal<T, 4> forces_of(const SymmetricTensor<T>& sigma) const {
    const SymmetricTensor<T> sixth = T(1.0 / 6.0) * sigma;
    const Vector3<T> f1 = sixth * g1, f2 = sixth * g2, f3 = sixth * g3;
    Nodal<T, 4> f;
    set_column(f, 0, -(f1 + f2 + f3)), set_column(f, 1, f1), set_column(f, 2, f2), set_column(f, 3, f3);
    return f;
  }
};

}  // namespace strike
