#pragma once
#include <strike/element/policies.hpp>
#include <strike/range.hpp>

namespace strike {

/// Plates taken as flat (Belytschko, Lin and Tsay 1984): the warp counts in the hourglass control alone, whose rate
/// u_h - z/4 w_s x e3 is zero in a rigid motion.
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
/// (MacNeal 1978; X3D's "calculations with respect to the mean plane, corrected").
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

/// The drilling projection of Belytschko, Wong and Chiang (1992): about the pseudo-normal p_I = e3 - grad z at them the
/// nodes turn as the plate does, because their own rotation about it strains nothing:
///   w_I <- w_I - d_I grad z_I,   grad z_I = z (eta_I g^xi + xi_I g^eta),   g^i . m_j = delta_ij.
/// Without drilling these are the authors' curvatures b^c v. Their shear projection takes the shear along the edges;
/// here opposite edges have equal shares, so that a constant shear is exact on any quadrilateral.
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
  /// The projection adds to the rotations of the nodes e times their rotation and the plate's about the normal: |1 +
  /// e|^2 <= 1 + e^2/2 + e sqrt(1 + e^2/4), e^2 = 2 |grad z|^2 (1 + 2 L1(S) I/m), |grad z|^2 <= z^2 tr(S)/2.
  template <class T>
  T stiffening(const T& z, const T& per_gyration, const PlaneTensor<T>& S) const {
    const T e2 = z * z * trace(S) * (1.0 + 2.0 * largest_eigenvalue(S) / per_gyration);
    return 1.0 + 0.5 * e2 + sqrt(e2 + 0.25 * e2 * e2);
  }
};

/// Absence of a resistance to the drilling: about their normals, where nothing strains, nodes turn by the moments that
/// supports and inclined neighbours give them.
struct FreeDrilling {
  template <class T>
  struct State {};
};

/// A stiffness r A66 A of each node's drilling, after Hughes and Brezzi (1989): for very long runs, and for
/// relaxations, which would not come to rest without it.
struct DrillingStiffness {
  double coefficient = 1e-3;  ///< r

  void ranges(const auto& number) const { number("coefficient", coefficient, range::between(0, 100)); }

  template <class T>
  struct State {
    Plate4Drilling<T> resistance{};
  };

  template <class T>
  T stiffness(const T& in_plane_shear, const T& area) const {
    return coefficient * in_plane_shear * area;
  }
};

}  // namespace strike
