#pragma once
#include <concepts>

#include <strike/element/plate4_modes.hpp>

namespace strike {

// What a plate makes of nodes that do not lie in its mean plane but z over it, z_I = h_I z/4: how the rates of the
// plane follow from those of the nodes, and what the plane's forces then are at the nodes. In each of them a rigid
// motion moves the plane rigidly, so that forces and moments balance.
//
// A policy has
// - `rates(frame, z, d, u, w)`: changes the modes of velocities and angular velocities to those of the plane; d is the
//   drilling of the nodes;
// - `forces(frame, z, F, G, D)`: its transpose, changes the modes of the plane's forces and moments to those at the
//   nodes, and gives the moment D on the drilling;
// - `lever(z)`: of how long a rotation moves the plane;
// - `stiffening(z, per_gyration, S)`: by which factor it raises the squares of frequencies beyond that; per_gyration is
//   m/I of a node and S = b b^T;
// - `drills`: whether it makes use of the drilling;
// - `projects_shear`: whether the transverse shear is the mean of that along opposite edges, in which a rotation that
//   grows along the plate adds nothing where it bends alone, whatever the shape; or that of the mean rotation.

/// The hourglass control alone knows of the warp (Belytschko, Lin and Tsay 1984): u_h - z/4 w_s x e3 is what a rigid
/// motion makes zero.
struct NoWarping {
  static constexpr bool drills = false, projects_shear = false;

  template <class T>
  void rates(const Plate4Frame<T>& frame, const T& z, const Plate4Drilling<T>&, Plate4Modes<T>& u,
             const Plate4Modes<T>& w) const {
    u.h = u.h - (0.25 * z) * cross(w.s, frame.normal);
  }
  template <class T>
  void forces(const Plate4Frame<T>& frame, const T& z, const Plate4Modes<T>& F, Plate4Modes<T>& G,
              Plate4Drilling<T>&) const {
    G.s = G.s - (0.25 * z) * cross(frame.normal, F.h);
  }
  template <class T>
  T lever(const T&) const {
    return T(0.0);
  }
  template <class T>
  T stiffening(const T&, const T&, const PlaneTensor<T>&) const {
    return T(1.0);
  }
};

/// Rigid links from the mean plane to the nodes: v_plane = v - z_I w_I x e3, in the modes of the product h_I w_I
/// (MacNeal 1978; what X3D says of "calculations with respect to the mean plane, corrected").
struct RigidOffset {
  static constexpr bool drills = false, projects_shear = false;

  template <class T>
  void rates(const Plate4Frame<T>& frame, const T& z, const Plate4Drilling<T>&, Plate4Modes<T>& u,
             const Plate4Modes<T>& w) const {
    const T l = 0.25 * z;
    u.xi = u.xi - l * cross(w.eta, frame.normal);
    u.eta = u.eta - l * cross(w.xi, frame.normal);
    u.h = u.h - l * cross(w.s, frame.normal);
  }
  template <class T>
  void forces(const Plate4Frame<T>& frame, const T& z, const Plate4Modes<T>& F, Plate4Modes<T>& G,
              Plate4Drilling<T>&) const {
    const T l = 0.25 * z;
    G.eta = G.eta - l * cross(frame.normal, F.xi);
    G.xi = G.xi - l * cross(frame.normal, F.eta);
    G.s = G.s - l * cross(frame.normal, F.h);
  }
  template <class T>
  T lever(const T& z) const {
    return 0.25 * abs(z);
  }
  template <class T>
  T stiffening(const T&, const T&, const PlaneTensor<T>&) const {
    return T(1.0);
  }
};

/// The drilling projection of Belytschko, Wong and Chiang (1992): nodes turn about the pseudo-normal p_I = e3 - grad z
/// at them as the plate does, for their own turn about it means nothing:
///   w_I <- w_I - d_I grad z_I,   grad z_I = z (eta_I g^xi + xi_I g^eta),   g^i . m_j = delta_ij.
/// Where nodes do not turn about their normals, these are the authors' curvatures b^c v. Their shear projection takes
/// the shear along the edges; here opposite ones have equal shares, so that a constant shear is exact on any
/// quadrilateral.
struct BelytschkoWongChiang {
  static constexpr bool drills = true, projects_shear = true;

  template <class T>
  void rates(const Plate4Frame<T>& frame, const T& z, const Plate4Drilling<T>& d, Plate4Modes<T>& u,
             Plate4Modes<T>& w) const {
    NoWarping{}.rates(frame, z, d, u, w);
    const auto [g_xi, g_eta] = frame.dual();
    const auto [s, xi, eta, h] = z * d;
    w.s = w.s - eta * g_xi - xi * g_eta;
    w.xi = w.xi - h * g_xi - s * g_eta;
    w.eta = w.eta - s * g_xi - h * g_eta;
    w.h = w.h - xi * g_xi - eta * g_eta;
  }
  template <class T>
  void forces(const Plate4Frame<T>& frame, const T& z, const Plate4Modes<T>& F, Plate4Modes<T>& G,
              Plate4Drilling<T>& D) const {
    const auto [g_xi, g_eta] = frame.dual();
    D.s -= z * (dot(g_eta, G.xi) + dot(g_xi, G.eta));
    D.xi -= z * (dot(g_eta, G.s) + dot(g_xi, G.h));
    D.eta -= z * (dot(g_xi, G.s) + dot(g_eta, G.h));
    D.h -= z * (dot(g_xi, G.xi) + dot(g_eta, G.eta));
    NoWarping{}.forces(frame, z, F, G, D);
  }
  template <class T>
  T lever(const T&) const {
    return T(0.0);
  }
  /// Nodes' rotations by e times what they and the spin of the plate turn about the normal: |1 + e|^2 <= 1 + e^2/2 + e
  /// sqrt(1 + e^2/4), e^2 = 2 |grad z|^2 (1 + 2 L1(S) I/m), |grad z|^2 <= z^2 tr(S)/2.
  template <class T>
  T stiffening(const T& z, const T& per_gyration, const PlaneTensor<T>& S) const {
    const T e2 = z * z * trace(S) * (1.0 + 2.0 * largest_eigenvalue(S) / per_gyration);
    return 1.0 + 0.5 * e2 + sqrt(e2 + 0.25 * e2 * e2);
  }
};

template <class W>
concept PlateWarping = requires(const W warping, const Plate4Frame<double> frame, Plate4Modes<double> modes) {
  W::drills;
  warping.rates(frame, 0.0, Plate4Drilling<double>{}, modes, modes);
};

// What resists the drilling.

/// Nothing: nodes turn about their normals as supports and neighbours askew leave them moments there, which no strain
/// feels.
struct FreeDrilling {
  template <class T>
  struct State {};
};

/// A stiffness r A66 A of each node's drilling, after Hughes and Brezzi (1989): for relaxations, which would not come
/// to rest, and very long runs.
struct DrillingStiffness {
  double coefficient = 1e-3;  ///< r

  template <class T>
  struct State {
    Plate4Drilling<T> resistance{};
  };

  template <class T>
  T stiffness(const T& in_plane_shear, const T& area) const {
    return coefficient * in_plane_shear * area;
  }
};

template <class D>
concept PlateDrilling = std::same_as<D, FreeDrilling> || requires(const D drilling) {
  { drilling.stiffness(1.0, 1.0) } -> std::convertible_to<double>;
};

}  // namespace strike
