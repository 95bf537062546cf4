#pragma once
#include <strike/element/plate4_modes.hpp>

namespace strike {

// What a plate makes of nodes that do not lie in its mean plane but z over it, z_I = h_I z/4: how the rates of the
// plane follow from those of the nodes, and what the plane's forces then are at the nodes. In each of them a rigid
// motion moves the plane rigidly, so that forces and moments balance.
//
// A policy has
// - `rates(frame, z, u, w)`: changes the modes of velocities and angular velocities to those of the plane;
// - `forces(frame, z, F, G)`: its transpose, changes the modes of the plane's forces and moments to those at the nodes;
// - `lever(z)`: of how long a rotation moves the plane;
// - `stiffening(z, per_gyration, S)`: by which factor it raises the squares of frequencies beyond that; per_gyration is
//   m/I of a node and S = b b^T.

/// The hourglass control alone knows of the warp (Belytschko, Lin and Tsay 1984): u_h - z/4 w_s x e3 is what a rigid
/// motion makes zero.
struct NoWarping {
  template <class T>
  void rates(const Plate4Frame<T>& frame, const T& z, Plate4Modes<T>& u, const Plate4Modes<T>& w) const {
    u.h = u.h - (0.25 * z) * cross(w.s, frame.normal);
  }
  template <class T>
  void forces(const Plate4Frame<T>& frame, const T& z, const Plate4Modes<T>& F, Plate4Modes<T>& G) const {
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

/// Rigid links from the mean plane to the nodes: v_plane = v - z_I w_I x e3, in the modes of the product h_I w_I.
/// (MacNeal 1978; what X3D says of "calculations with respect to the mean plane, corrected".)
struct RigidOffset {
  template <class T>
  void rates(const Plate4Frame<T>& frame, const T& z, Plate4Modes<T>& u, const Plate4Modes<T>& w) const {
    const T lever = 0.25 * z;
    u.xi = u.xi - lever * cross(w.eta, frame.normal);
    u.eta = u.eta - lever * cross(w.xi, frame.normal);
    u.h = u.h - lever * cross(w.s, frame.normal);
  }
  template <class T>
  void forces(const Plate4Frame<T>& frame, const T& z, const Plate4Modes<T>& F, Plate4Modes<T>& G) const {
    const T lever = 0.25 * z;
    G.eta = G.eta - lever * cross(frame.normal, F.xi);
    G.xi = G.xi - lever * cross(frame.normal, F.eta);
    G.s = G.s - lever * cross(frame.normal, F.h);
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
/// at them as the plate does, whose spin w_e follows from the velocities, for their own turn about it means nothing:
///   w_I <- w_I - (w_e - w_I.e3) grad z_I,   grad z_I = z (eta_I g^xi + xi_I g^eta),   g^i . m_j = delta_ij.
/// Where nodes do not turn about their normals, these are the authors' curvatures b^c v.
struct BelytschkoWongChiang {
  template <class T>
  void rates(const Plate4Frame<T>& frame, const T& z, Plate4Modes<T>& u, Plate4Modes<T>& w) const {
    NoWarping{}.rates(frame, z, u, w);
    const auto [g_xi, g_eta] = dual(frame);
    const Vector3<T>& e3 = frame.normal;
    const T spin = 0.5 * dot<T>(e3, cross(g_xi, u.xi) + cross(g_eta, u.eta));
    const T s = z * (4.0 * spin - dot(e3, w.s)), xi = -z * dot(e3, w.xi), eta = -z * dot(e3, w.eta),
            h = -z * dot(e3, w.h);
    w.s = w.s - eta * g_xi - xi * g_eta;
    w.xi = w.xi - h * g_xi - s * g_eta;
    w.eta = w.eta - s * g_xi - h * g_eta;
    w.h = w.h - xi * g_xi - eta * g_eta;
  }
  template <class T>
  void forces(const Plate4Frame<T>& frame, const T& z, Plate4Modes<T>& F, Plate4Modes<T>& G) const {
    const auto [g_xi, g_eta] = dual(frame);
    const Vector3<T>& e3 = frame.normal;
    const T s = z * (dot(g_eta, G.xi) + dot(g_xi, G.eta)), xi = z * (dot(g_eta, G.s) + dot(g_xi, G.h)),
            eta = z * (dot(g_xi, G.s) + dot(g_eta, G.h)), h = z * (dot(g_xi, G.xi) + dot(g_eta, G.eta));
    G.s = G.s + s * e3, G.xi = G.xi + xi * e3, G.eta = G.eta + eta * e3, G.h = G.h + h * e3;
    F.xi = F.xi - (2.0 * s) * cross(e3, g_xi);
    F.eta = F.eta - (2.0 * s) * cross(e3, g_eta);
    NoWarping{}.forces(frame, z, F, G);
  }
  template <class T>
  T lever(const T&) const {
    return T(0.0);
  }
  /// Nodes' rotations by e times what they and the spin w_e turn about the normal: |1 + e|^2 <= 1 + e^2/2 + e sqrt(1 +
  /// e^2/4), e^2 = 2 |grad z|^2 (1 + 2 L1(S) I/m), |grad z|^2 <= z^2 tr(S)/2.
  template <class T>
  T stiffening(const T& z, const T& per_gyration, const PlaneTensor<T>& S) const {
    const T e2 = z * z * trace(S) * (1.0 + 2.0 * largest_eigenvalue(S) / per_gyration);
    return 1.0 + 0.5 * e2 + sqrt(e2 + 0.25 * e2 * e2);
  }

 private:
  template <class T>
  struct DualBasis {
    Vector3<T> xi, eta;
  };
  template <class T>
  static DualBasis<T> dual(const Plate4Frame<T>& frame) {
    const Vector3<T> e1 = frame.e1(), e2 = frame.e2();
    const PlaneTensor<T>& U = frame.inverse;
    return {U.xx * e1 + U.xy * e2, U.xy * e1 + U.yy * e2};
  }
};

}  // namespace strike
