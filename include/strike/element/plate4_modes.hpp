#pragma once
#include <strike/element/element.hpp>
#include <strike/tensor/plane.hpp>

namespace strike {

/// The four nodal vectors of a quadrilateral in the modes of the reference square: m_k = sum_I Lambda_kI x_I, with
/// Lambda_kI = 1 and the values +-1 of xi, eta and xi eta at corner I. The bilinear map is x = (s + xi m_xi + eta m_eta
/// + xi eta m_h)/4.
template <class T>
struct Plate4Modes {
  Vector3<T> s, xi, eta, h;
};

/// Nodes to modes, of the four columns from `first` on.
template <class T, int n>
Plate4Modes<T> to_plate_modes(const Nodal<T, n>& a, std::size_t first = 0) {
  const Vector3<T> a0 = column(a, first), a1 = column(a, first + 1), a2 = column(a, first + 2),
                   a3 = column(a, first + 3);
  const Vector3<T> s01 = a1 + a0, d01 = a1 - a0, s32 = a2 + a3, d32 = a2 - a3;
  return {s32 + s01, d32 + d01, s32 - s01, d32 - d01};
}

/// Modes to nodes: f_I = sum_k Lambda_kI F_k, into the four columns from `first` on.
template <class T, int n>
void to_plate_nodes(const Plate4Modes<T>& F, Nodal<T, n>& f, std::size_t first = 0) {
  const Vector3<T> s = F.s - F.eta, d = F.xi - F.h, S = F.s + F.eta, D = F.xi + F.h;
  set_column(f, first, s - d), set_column(f, first + 1, s + d);
  set_column(f, first + 2, S + D), set_column(f, first + 3, S - D);
}

/// The plane of a quadrilateral and its reference square in it. The frame is the rotation of the polar
/// decomposition of the mean map: in it (m_xi, m_eta) is the symmetric
///   U = (C + D 1)/t,   C = (m_i . m_j),   D = sqrt(det C) = 4 A,   t = sqrt(tr C + 2 D),
/// whatever corner the numbers begin with. The gradient of a field f is f_,j = f_i (U^-1)_ij.
template <class T>
struct Plate4Frame {
  Vector3<T> normal;       ///< e3
  T area;                  ///< A
  Vector3<T> m_xi, m_eta;  ///< tangents of the middle, four times
  PlaneTensor<T> inverse;  ///< U^-1

  Plate4Frame(const Vector3<T>& xi, const Vector3<T>& eta) : m_xi(xi), m_eta(eta) {
    const Vector3<T> n = cross(xi, eta);
    const T nn = dot(n, n), per_D = rsqrt(nn), D = nn * per_D;
    const T C_xx = dot(xi, xi), C_yy = dot(eta, eta), C_xy = dot(xi, eta);
    const T scale = rsqrt(C_xx + C_yy + 2.0 * D) * per_D;
    normal = per_D * n;
    area = 0.25 * D;
    inverse = {scale * (C_yy + D), scale * (C_xx + D), -scale * C_xy};
  }

  Vector3<T> e1() const { return inverse.xx * m_xi + inverse.xy * m_eta; }
  Vector3<T> e2() const { return inverse.xy * m_xi + inverse.yy * m_eta; }

  /// U^-1 a: from components along the tangents to those in the frame, and back for what does work on them.
  Vector2<T> turned(const T& xi, const T& eta) const {
    return {inverse.xx * xi + inverse.xy * eta, inverse.xy * xi + inverse.yy * eta};
  }
  /// U^-1 a U^-1, of tensors.
  PlaneTensor<T> turned(const PlaneTensor<T>& a) const {
    const T &p = inverse.xx, &q = inverse.yy, &r = inverse.xy;
    return {p * p * a.xx + 2.0 * p * r * a.xy + r * r * a.yy, r * r * a.xx + 2.0 * r * q * a.xy + q * q * a.yy,
            p * r * a.xx + (p * q + r * r) * a.xy + q * r * a.yy};
  }
  /// g^xi and g^eta in the plane with g^i . m_j = delta_ij.
  struct Dual {
    Vector3<T> xi, eta;
  };
  Dual dual() const {
    const Vector3<T> e1 = this->e1(), e2 = this->e2();
    return {inverse.xx * e1 + inverse.xy * e2, inverse.xy * e1 + inverse.yy * e2};
  }

  /// The part of an in-plane vector along e1 and e2.
  Vector2<T> in_plane(const Vector3<T>& a) const { return turned(dot(a, m_xi), dot(a, m_eta)); }

  /// sum_I b_iI b_jI of the gradient b in the frame: 4 U^-2 [1/length^2].
  PlaneTensor<T> gradient_squared() const {
    const T &p = inverse.xx, &q = inverse.yy, &r = inverse.xy;
    return {4.0 * (p * p + r * r), 4.0 * (q * q + r * r), 4.0 * (p + q) * r};
  }
};

/// The drilling of the nodes in modes: the spin of the plane, that of its mean gradient, less their rotation about the
/// normal; or the moment on it.
template <class T>
struct Plate4Drilling {
  T s{}, xi{}, eta{}, h{};

  Plate4Drilling() = default;
  Plate4Drilling(const T& s_, const T& xi_, const T& eta_, const T& h_) : s(s_), xi(xi_), eta(eta_), h(h_) {}
  Plate4Drilling(const Plate4Frame<T>& frame, const Plate4Modes<T>& u, const Plate4Modes<T>& w) {
    const auto [g_xi, g_eta] = frame.dual();
    const Vector3<T>& e3 = frame.normal;
    s = 2.0 * dot<T>(e3, cross(g_xi, u.xi) + cross(g_eta, u.eta)) - dot(e3, w.s);
    xi = -dot(e3, w.xi), eta = -dot(e3, w.eta), h = -dot(e3, w.h);
  }
  /// The transpose: adds the forces at the nodes of the moments on the drilling.
  void add_forces(const Plate4Frame<T>& frame, Plate4Modes<T>& F, Plate4Modes<T>& G) const {
    const auto [g_xi, g_eta] = frame.dual();
    const Vector3<T>& e3 = frame.normal;
    F.xi = F.xi + (2.0 * s) * cross(e3, g_xi);
    F.eta = F.eta + (2.0 * s) * cross(e3, g_eta);
    G.s = G.s - s * e3, G.xi = G.xi - xi * e3, G.eta = G.eta - eta * e3, G.h = G.h - h * e3;
  }
  friend Plate4Drilling operator*(const T& c, const Plate4Drilling& d) {
    return {c * d.s, c * d.xi, c * d.eta, c * d.h};
  }
};

}  // namespace strike
