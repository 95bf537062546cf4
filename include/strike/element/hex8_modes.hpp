#pragma once
#include <array>

#include <strike/element/element.hpp>

namespace strike {

/// The eight nodal vectors of a hexahedron in the modes of the reference cube: m_k = sum_I Lambda_kI x_I, with
/// Lambda_kI = +-1 the value of xi, eta, zeta, eta zeta, zeta xi, xi eta and xi eta zeta at corner I. (Their sum, the
/// eighth mode, moves nothing.) The trilinear map is x = (sum of x_I + a1 xi + a2 eta + a3 zeta + b1 eta zeta + b2 zeta
/// xi + b3 xi eta + d xi eta zeta)/8.
template <class T>
struct Hex8Modes {
  Vector3<T> a1, a2, a3, b1, b2, b3, d;
};

/// Nodes to modes: a butterfly along each direction, 23 additions a component.
template <class T>
Hex8Modes<T> to_modes(const Nodal<T, 8>& x) {
  const Vector3<T> x0 = column(x, 0), x1 = column(x, 1), x2 = column(x, 2), x3 = column(x, 3), x4 = column(x, 4),
                   x5 = column(x, 5), x6 = column(x, 6), x7 = column(x, 7);
  const Vector3<T> s01 = x1 + x0, d01 = x1 - x0, s32 = x2 + x3, d32 = x2 - x3;
  const Vector3<T> s45 = x5 + x4, d45 = x5 - x4, s76 = x6 + x7, d76 = x6 - x7;
  const Vector3<T> sb = s32 + s01, st = s76 + s45, eb = s32 - s01, et = s76 - s45;
  const Vector3<T> xb = d32 + d01, xt = d76 + d45, hb = d32 - d01, ht = d76 - d45;
  return {xt + xb, et + eb, st - sb, et - eb, xt - xb, ht + hb, ht - hb};
}

/// Modes to nodes, the transposed butterfly: f_I = sum_k Lambda_kI F_k.
template <class T>
Nodal<T, 8> to_nodes(const Hex8Modes<T>& F) {
  const Vector3<T> xt = F.a1 + F.b2, xb = F.a1 - F.b2, et = F.a2 + F.b1, eb = F.a2 - F.b1, ht = F.b3 + F.d,
                   hb = F.b3 - F.d;
  const Vector3<T> d76 = xt + ht, d45 = xt - ht, d32 = xb + hb, d01 = xb - hb;
  const Vector3<T> s76 = F.a3 + et, s45 = F.a3 - et, s32 = eb - F.a3, s01 = -F.a3 - eb;
  Nodal<T, 8> f;
  set_column(f, 0, s01 - d01), set_column(f, 1, s01 + d01), set_column(f, 2, s32 + d32), set_column(f, 3, s32 - d32);
  set_column(f, 4, s45 - d45), set_column(f, 5, s45 + d45), set_column(f, 6, s76 + d76), set_column(f, 7, s76 - d76);
  return f;
}

/// The mean gradient of the trilinear hexahedron (Flanagan and Belytschko 1981, eq. 16), in modes:
///   64 V = det(a1, a2, a3) + (det(a1, b3, b2) + det(b3, a2, b1) + det(b2, b1, a3))/3,   g_k = d(64 V)/d m_k;
/// d does not enter. In the nodes B_I = dV/dx_I = sum_k Lambda_kI g_k/64. As the gradient of x is 1, sum_k m_k (x) g_k
/// = 64 V 1, and V is any component of its diagonal.
template <class T>
struct Hex8Gradient {
  Vector3<T> a1, a2, a3, b1, b2, b3;
  T volume;

  explicit Hex8Gradient(const Hex8Modes<T>& m)
      : a1(cross(m.a2, m.a3) + T(1.0 / 3.0) * cross(m.b3, m.b2)),
        a2(cross(m.a3, m.a1) + T(1.0 / 3.0) * cross(m.b1, m.b3)),
        a3(cross(m.a1, m.a2) + T(1.0 / 3.0) * cross(m.b2, m.b1)),
        b1(T(1.0 / 3.0) * (cross(m.b3, m.a2) + cross(m.a3, m.b2))),
        b2(T(1.0 / 3.0) * (cross(m.a1, m.b3) + cross(m.b1, m.a3))),
        b3(T(1.0 / 3.0) * (cross(m.b2, m.a1) + cross(m.a2, m.b1))),
        volume(T(1.0 / 64.0) * (m.a1(0) * a1(0) + m.a2(0) * a2(0) + m.a3(0) * a3(0) + m.b1(0) * b1(0) +
                                m.b2(0) * b2(0) + m.b3(0) * b3(0))) {}

  /// L_ij = du_i/dx_j, the mean over the element: sum_k u_k (x) g_k / (64 V); `per_volume` is 1/V.
  Matrix3<T> gradient_of(const Hex8Modes<T>& u, const T& per_volume) const {
    Matrix3<T> L = outer(u.a1, a1);
    add_outer(L, u.a2, a2), add_outer(L, u.a3, a3);
    add_outer(L, u.b1, b1), add_outer(L, u.b2, b2), add_outer(L, u.b3, b3);
    return T(T(1.0 / 64.0) * per_volume) * L;
  }

  /// The transpose: the forces on the modes of the mean stress sigma, V sigma grad N_I in the nodes.
  Hex8Modes<T> forces_of(const Matrix3<T>& sigma) const {
    const Matrix3<T> P = T(1.0 / 64.0) * sigma;
    return {times(P, a1), times(P, a2), times(P, a3), times(P, b1), times(P, b2), times(P, b3), Vector3<T>::Zero()};
  }
  /// Adds those of the same tension in all directions.
  void add_forces_of(const T& tension, Hex8Modes<T>& F) const {
    const T P = T(1.0 / 64.0) * tension;
    F.a1 += P * a1, F.a2 += P * a2, F.a3 += P * a3;
    F.b1 += P * b1, F.b2 += P * b2, F.b3 += P * b3;
  }

  /// 512 B_iI B_jI = sum_k g_k (x) g_k: the part of the modes a, all there is in a parallelepiped, ...
  SymmetricTensor<T> squared_a() const { return outer_square(a1) + outer_square(a2) + outer_square(a3); }
  /// ... and the part of the modes b.
  SymmetricTensor<T> squared_b() const { return outer_square(b1) + outer_square(b2) + outer_square(b3); }
};

/// The four vectors of the hourglass modes b1, b2, b3 and d of a hexahedron: rates, or the resistance to them.
template <class T>
using HourglassModes = std::array<Vector3<T>, 4>;
/// The rates u_k - L m_k, with the velocities u and the mean velocity gradient L.
template <class T>
HourglassModes<T> hourglass_rates(const Hex8Modes<T>& m, const Hex8Modes<T>& u, const Matrix3<T>& L) {
  return {minus_times(u.b1, L, m.b1), minus_times(u.b2, L, m.b2), minus_times(u.b3, L, m.b3), minus_times(u.d, L, m.d)};
}
template <class T>
T squared_norm(const HourglassModes<T>& q) {
  return dot(q[0], q[0]) + dot(q[1], q[1]) + dot(q[2], q[2]) + dot(q[3], q[3]);
}

/// The nodal forces of the mean stress sigma and of Q_k, the resistance to the hourglass rates u_k - L m_k.
template <class T>
Nodal<T, 8> nodal_forces(const SymmetricTensor<T>& sigma, const HourglassModes<T>& Q, const Hex8Modes<T>& m,
                         const Hex8Gradient<T>& g, const T& per_volume) {
  Matrix3<T> Qm = outer(Q[0], m.b1);
  add_outer(Qm, Q[1], m.b2), add_outer(Qm, Q[2], m.b3), add_outer(Qm, Q[3], m.d);
  Hex8Modes<T> F = g.forces_of(sigma.matrix() - per_volume * Qm);
  F.b1 = Q[0] + F.b1, F.b2 = Q[1] + F.b2, F.b3 = Q[2] + F.b3, F.d = Q[3];
  return to_nodes(F);
}

}  // namespace strike
