#pragma once
#include <strike/element/plate4_modes.hpp>
#include <strike/element/plate_point.hpp>
#include <strike/element/policies.hpp>

namespace strike {

/// Resistance of a plate to a small motion p of its nodes in a step dt, four displacements and behind them four
/// rotations: the forces and moments K dt^2/4 p of its stiffness K, in the letters of Plate4. A stable step keeps their
/// largest eigenvalue over the masses and moments of inertia at or below 1.
template <class T, class Warping, bool drills>
struct Plate4Resistance : Warping {
  T mass{}, inertia{};                     ///< of each node
  PlateKinematics::Moduli<T> section{};    ///< tangent of the section, times dt^2/4, as are ...
  PlateHourglassStiffness<T> hourglass{};  ///< ... the stiffness of the hourglass control
  T drilling{};                            ///< ... and that of each mode of the drilling

  Plate4Resistance& operator*=(const T& share) {
    for (PlaneModuli<T>* k : {&section.extension, &section.coupling, &section.bending})
      k->normal *= share, k->shear *= share;
    for (T* k : {&section.transverse_shear, &hourglass.membrane, &hourglass.bending, &hourglass.shear, &drilling})
      *k *= share;
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
    if constexpr (Warping::projects_shear) g_xi += 0.25 * dot(c_h, w.eta), g_eta += 0.25 * dot(c_h, w.xi);
    const Vector2<T> g = frame.turned(g_xi, g_eta);
    const Vector3<T> h_u = u.h - q(0) * u.xi - q(1) * u.eta, h_w = w.h - q(0) * w.xi - q(1) * w.eta;
    T across = dot(e3, h_u);
    if constexpr (Warping::projects_shear)
      across += 0.125 * (dot(c_xi, w.eta) + dot(c_eta, w.xi)) - 0.25 * dot<T>(c_h, q(0) * w.eta + q(1) * w.xi);

    const T& A = frame.area;
    const PlaneTensor<T> N = A * frame.turned(detail::plane_stress_of(section.extension, e) +
                                              detail::plane_stress_of(section.coupling, k)),
                         M = A * frame.turned(detail::plane_stress_of(section.coupling, e) +
                                              detail::plane_stress_of(section.bending, k));
    const Vector2<T> Q = frame.turned(A * section.transverse_shear * g(0), A * section.transverse_shear * g(1));
    const Vector3<T> e1 = frame.e1(), e2 = frame.e2();
    const Vector2<T> a = frame.in_plane(h_u), b = frame.in_plane(h_w);
    const T R = hourglass.shear * across;
    const Vector3<T> R_u = (hourglass.membrane * a(0)) * e1 + (hourglass.membrane * a(1)) * e2 + R * e3,
                     R_w = (hourglass.bending * b(0)) * e1 + (hourglass.bending * b(1)) * e2;
    Plate4Modes<T> F, G;
    F.s = Vector3<T>{T(0.0), T(0.0), T(0.0)};
    F.xi = N.xx * m.xi + N.xy * m.eta + Q(0) * e3 - q(0) * R_u;
    F.eta = N.xy * m.xi + N.yy * m.eta + Q(1) * e3 - q(1) * R_u;
    F.h = R_u;
    G.s = (0.25 * Q(0)) * c_xi + (0.25 * Q(1)) * c_eta;
    G.xi = M.xx * c_xi + M.xy * c_eta - q(0) * R_w;
    G.eta = M.xy * c_xi + M.yy * c_eta - q(1) * R_w;
    G.h = R_w;
    if constexpr (Warping::projects_shear) {
      G.eta = G.eta + (0.25 * Q(0) - 0.25 * R * q(0)) * c_h + (0.125 * R) * c_xi;
      G.xi = G.xi + (0.25 * Q(1) - 0.25 * R * q(1)) * c_h + (0.125 * R) * c_eta;
    }
    Plate4Drilling<T> moment = drilling * d;
    Warping::forces(frame, z, F, G, moment);
    if constexpr (drills) moment.add_forces(frame, F, G);
    Nodal<T, 8> f;
    to_plate_nodes(F, f), to_plate_nodes(G, f, 4);
    return f;
  }
};

}  // namespace strike
