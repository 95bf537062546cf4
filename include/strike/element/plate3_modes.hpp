#pragma once
#include <strike/element/plate4_modes.hpp>

namespace strike {

/// The three nodal vectors of a triangle in the modes of an equilateral one: m_k = sum_I Lambda_kI x_I with Lambda_I =
/// 1, a_I and b_I,
///   a = 3^(1/4) (-1, 1, 0),   b = 3^(-1/4) (-1, -1, 2),   a.a = b.b = squares = 2 sqrt(3),   a.b = 0.
/// The linear map is x_I = s/3 + (a_I m_xi + b_I m_eta)/squares, and the triangle has the area |m_xi x m_eta|/4: so
/// Plate4Frame is its plane too, and b_iI b_jI is squares U^-2.
template <class T>
struct Plate3Modes {
  static constexpr double squares = 3.4641016151377546, root = 1.3160740129524924;  ///< root: 3^(1/4)

  Vector3<T> s, xi, eta;
};

/// Nodes to modes, of the three columns from `first` on.
template <class T, int n>
Plate3Modes<T> to_triangle_modes(const Nodal<T, n>& x, std::size_t first = 0) {
  constexpr double root = Plate3Modes<T>::root;
  const Vector3<T> x0 = column(x, first), x1 = column(x, first + 1), x2 = column(x, first + 2), s01 = x0 + x1;
  return {s01 + x2, T(root) * Vector3<T>(x1 - x0), T(1.0 / root) * Vector3<T>(2.0 * x2 - s01)};
}

/// Modes to nodes: f_I = sum_k Lambda_kI F_k, into the three columns from `first` on.
template <class T, int n>
void to_triangle_nodes(const Plate3Modes<T>& F, Nodal<T, n>& f, std::size_t first = 0) {
  constexpr double root = Plate3Modes<T>::root;
  const Vector3<T> along = T(root) * F.xi, across = T(1.0 / root) * F.eta, base = F.s - across;
  set_column(f, first, Vector3<T>(base - along)), set_column(f, first + 1, Vector3<T>(base + along));
  set_column(f, first + 2, Vector3<T>(F.s + 2.0 * across));
}

/// The drilling of the nodes of a triangle in modes: its spin less their rotation about the normal; or the moment on
/// it.
template <class T>
struct Plate3Drilling {
  T s{}, xi{}, eta{};

  Plate3Drilling() = default;
  Plate3Drilling(const T& s_, const T& xi_, const T& eta_) : s(s_), xi(xi_), eta(eta_) {}
  Plate3Drilling(const Plate4Frame<T>& frame, const Plate3Modes<T>& u, const Plate3Modes<T>& w) {
    const auto [g_xi, g_eta] = frame.dual();
    const Vector3<T>& e3 = frame.normal;
    s = 1.5 * dot<T>(e3, cross(g_xi, u.xi) + cross(g_eta, u.eta)) - dot(e3, w.s);
    xi = -dot(e3, w.xi), eta = -dot(e3, w.eta);
  }
  /// The transpose: adds the forces at the nodes of the moments on the drilling.
  void add_forces(const Plate4Frame<T>& frame, Plate3Modes<T>& F, Plate3Modes<T>& G) const {
    const auto [g_xi, g_eta] = frame.dual();
    const Vector3<T>& e3 = frame.normal;
    F.xi = F.xi + (1.5 * s) * cross(e3, g_xi);
    F.eta = F.eta + (1.5 * s) * cross(e3, g_eta);
    G.s = G.s - s * e3, G.xi = G.xi - xi * e3, G.eta = G.eta - eta * e3;
  }
  /// Share of the stiffness of a node that resists each mode.
  static Plate3Drilling shares() {
    constexpr double per_square = 1 / Plate3Modes<T>::squares;
    return {T(1.0 / 3.0), T(per_square), T(per_square)};
  }
};

}  // namespace strike
