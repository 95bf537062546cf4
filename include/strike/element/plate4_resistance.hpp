#pragma once
#include <type_traits>

#include <strike/element/plate4_modes.hpp>
#include <strike/element/plate_physical.hpp>
#include <strike/element/plate_point.hpp>
#include <strike/element/policies.hpp>

namespace strike {

namespace detail {

/// Stiffness of a section against the linear strains of PhysicalHourglass along one edge: force = extension e +
/// coupling k, moment = coupling e + bending k.
template <class T>
struct LinearModuli {
  T extension{}, coupling{}, bending{};

  AlongEdges<T> force(const AlongEdges<T>& e, const AlongEdges<T>& k) const { return extension * e + coupling * k; }
  AlongEdges<T> moment(const AlongEdges<T>& e, const AlongEdges<T>& k) const { return coupling * e + bending * k; }
  LinearModuli& operator*=(const T& share) {
    extension *= share, coupling *= share, bending *= share;
    return *this;
  }
};

/// The same of a section that has these moduli. Its points resist with 4 (G - G^2/Q) each; summed over the thickness
/// with 1, z and z^2 as 2 x 2 matrices that is 4 (G - G Q^-1 G) where the points have one Poisson's ratio, and else
/// less, for the Schur complement of a sum is not below the sum of the complements (Anderson and Trapp 1975).
template <class Section, class T>
LinearModuli<T> linear_moduli(const PlateKinematics::Moduli<T>& m) {
  if constexpr (!HasLinearStress<Section>) {
    return {uniaxial(m.extension), T(0.0), uniaxial(m.bending)};
  } else {
    const T &Q1 = m.extension.normal, &Q2 = m.coupling.normal, &Q3 = m.bending.normal;
    const T &G1 = m.extension.shear, &G2 = m.coupling.shear, &G3 = m.bending.shear;
    const T determinant = Q1 * Q3 - Q2 * Q2;
    // of one point that has not failed, 4 G, which is more
    const T per_determinant = select(determinant > 1e-9 * Q1 * Q3, 1.0 / determinant, T(0.0));
    const auto product = [&](const T& a, const T& b, const T& c, const T& d) -> T {  // (a, b) Q^-1 (c, d)
      return per_determinant * (Q3 * a * c - Q2 * (a * d + b * c) + Q1 * b * d);
    };
    return {4.0 * (G1 - product(G1, G2, G1, G2)), 4.0 * (G2 - product(G1, G2, G2, G3)),
            4.0 * (G3 - product(G2, G3, G2, G3))};
  }
}

}  // namespace detail

/// Resistance of a plate to a small motion p of its nodes in a step dt, four displacements and behind them four
/// rotations: the forces and moments K dt^2/4 p of its stiffness K, in the letters of Plate4. A stable step keeps their
/// largest eigenvalue over the masses and moments of inertia at or below 1.
template <class T, class Warping, bool drills, bool physical>
struct Plate4Resistance : Warping {
  static constexpr bool projects_shear = Warping::projects_shear || physical;
  struct Nothing {};

  T mass{}, inertia{};                     ///< of each node
  PlateKinematics::Moduli<T> section{};    ///< tangent of the section, times dt^2/4, as are ...
  PlateHourglassStiffness<T> hourglass{};  ///< ... the stiffness of the hourglass control
  T drilling{};                            ///< ... and that of each mode of the drilling
  [[no_unique_address]] std::conditional_t<physical, detail::LinearModuli<T>, Nothing> linear{};

  Plate4Resistance& operator*=(const T& share) {
    for (PlaneModuli<T>* k : {&section.extension, &section.coupling, &section.bending})
      k->normal *= share, k->shear *= share;
    for (T* k : {&section.transverse_shear, &hourglass.membrane, &hourglass.bending, &hourglass.shear, &drilling})
      *k *= share;
    if constexpr (physical) linear *= share;
    return *this;
  }

  Nodal<T, 8> operator()(const Nodal<T, 4>& x, const Nodal<T, 8>& p) const {
    const Plate4Modes<T> m = to_plate_modes<T>(x);
    Plate4Modes<T> u = to_plate_modes<T>(p), w = to_plate_modes<T>(p, 4);
    const Plate4Frame<T> frame(m.xi, m.eta);
    const Vector3<T>& e3 = frame.normal;
    const T z = dot(e3, m.h);
    const Vector3<T> c_xi = cross(e3, m.xi), c_eta = cross(e3, m.eta), c_h = cross(e3, m.h);
    const Vector2<T> h = frame.in_plane(m.h), q = frame.turned(h(0), h(1));

    Plate4Drilling<T> d;
    if constexpr (drills) d = Plate4Drilling<T>(frame, u, w);
    Warping::rates(frame, z, d, u, w);
    const PlaneTensor<T> e =
        frame.turned({dot(m.xi, u.xi), dot(m.eta, u.eta), 0.5 * (dot(m.xi, u.eta) + dot(m.eta, u.xi))});
    const PlaneTensor<T> k =
        frame.turned({dot(c_xi, w.xi), dot(c_eta, w.eta), 0.5 * (dot(c_xi, w.eta) + dot(c_eta, w.xi))});
    T g_xi = dot(e3, u.xi) + 0.25 * dot(c_xi, w.s), g_eta = dot(e3, u.eta) + 0.25 * dot(c_eta, w.s);
    if constexpr (projects_shear) g_xi += 0.25 * dot(c_h, w.eta), g_eta += 0.25 * dot(c_h, w.xi);
    const Vector2<T> g = frame.turned(g_xi, g_eta);
    const Vector3<T> h_u = u.h - q(0) * u.xi - q(1) * u.eta, h_w = w.h - q(0) * w.xi - q(1) * w.eta;

    const T& A = frame.area;
    const PlaneTensor<T> N = A * frame.turned(detail::plane_stress_of(section.extension, e) +
                                              detail::plane_stress_of(section.coupling, k)),
                         M = A * frame.turned(detail::plane_stress_of(section.coupling, e) +
                                              detail::plane_stress_of(section.bending, k));
    const Vector2<T> Q = frame.turned(A * section.transverse_shear * g(0), A * section.transverse_shear * g(1));

    // Of the control: forces on the hourglass motion, and those across along the edges, which the rotations share.
    T across = dot(e3, h_u);
    if constexpr (projects_shear) across -= 0.25 * dot<T>(c_h, q(0) * w.eta + q(1) * w.xi);
    const T along_xi = 0.25 * dot(c_xi, w.eta), along_eta = 0.25 * dot(c_eta, w.xi);
    Plate4Drilling<T> moment;
    Vector3<T> R_u, R_w;
    AlongEdges<T> R;
    if constexpr (physical) {
      const detail::PlateEdges<T> edges(frame);
      const AlongEdges<T> extension = edges.per_square(dot(m.xi, h_u), dot(m.eta, h_u)),
                          curvature = edges.per_square(dot(c_xi, h_w), dot(c_eta, h_w)), inverse = edges.inverse(A),
                          spin = edges.spin(extension, A);
      const T third = T(1.0 / 3.0) * A, K = third * section.transverse_shear;
      d.xi += spin.xi, d.eta += spin.eta;
      moment = drilling * d;
      R = K * AlongEdges<T>{inverse.xi * (across + along_xi), inverse.eta * (across + along_eta)};
      const AlongEdges<T> n = edges.per_square(third * linear.force(extension, curvature) +
                                               edges.strain_of_spin({moment.xi, moment.eta}, A)),
                          k_h = edges.per_square(third * linear.moment(extension, curvature));
      R_u = n.xi * m.xi + n.eta * m.eta, R_w = k_h.xi * c_xi + k_h.eta * c_eta;
    } else {
      moment = drilling * d;
      if constexpr (projects_shear) across += 0.5 * (along_xi + along_eta);
      R.xi = R.eta = 0.5 * hourglass.shear * across;
      const Vector3<T> e1 = frame.e1(), e2 = frame.e2();
      const Vector2<T> a = frame.in_plane(h_u), b = frame.in_plane(h_w);
      R_u = (hourglass.membrane * a(0)) * e1 + (hourglass.membrane * a(1)) * e2;
      R_w = (hourglass.bending * b(0)) * e1 + (hourglass.bending * b(1)) * e2;
    }
    const T R_across = R.xi + R.eta;
    R_u = R_u + R_across * e3;

    Plate4Modes<T> F, G;
    F.s = Vector3<T>{T(0.0), T(0.0), T(0.0)};
    F.xi = N.xx * m.xi + N.xy * m.eta + Q(0) * e3 - q(0) * R_u;
    F.eta = N.xy * m.xi + N.yy * m.eta + Q(1) * e3 - q(1) * R_u;
    F.h = R_u;
    G.s = (0.25 * Q(0)) * c_xi + (0.25 * Q(1)) * c_eta;
    G.xi = M.xx * c_xi + M.xy * c_eta - q(0) * R_w;
    G.eta = M.xy * c_xi + M.yy * c_eta - q(1) * R_w;
    G.h = R_w;
    if constexpr (projects_shear) {
      G.eta = G.eta + (0.25 * (Q(0) - R_across * q(0))) * c_h + (0.25 * R.xi) * c_xi;
      G.xi = G.xi + (0.25 * (Q(1) - R_across * q(1))) * c_h + (0.25 * R.eta) * c_eta;
    }
    Warping::forces(frame, z, F, G, moment);
    if constexpr (drills) moment.add_forces(frame, F, G);
    Nodal<T, 8> f;
    to_plate_nodes(F, f), to_plate_nodes(G, f, 4);
    return f;
  }
};

}  // namespace strike
