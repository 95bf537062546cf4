#pragma once
#include <strike/element/plate3_motion.hpp>
#include <strike/element/plate_point.hpp>

namespace strike {

/// Resistance of a triangular plate to a small motion p of its nodes in a step dt, three displacements and behind them
/// three rotations: the forces and moments K dt^2/4 p of its stiffness K, in the letters of Plate3. A stable step keeps
/// their largest eigenvalue over the masses and moments of inertia at or below 1.
template <class T, bool drills>
struct Plate3Resistance {
  T mass{}, inertia{};                   ///< of each node
  PlateKinematics::Moduli<T> section{};  ///< tangent of the section, times dt^2/4, as is ...
  T drilling{};                          ///< ... the stiffness of each node's drilling

  Plate3Resistance& operator*=(const T& share) {
    for (PlaneModuli<T>* k : {&section.extension, &section.coupling, &section.bending})
      k->normal *= share, k->shear *= share;
    section.transverse_shear *= share, drilling *= share;
    return *this;
  }

  Nodal<T, 6> operator()(const Nodal<T, 3>& x, const Nodal<T, 6>& p) const {
    const Plate3Modes<T> m = to_triangle_modes<T>(x), u = to_triangle_modes<T>(p), w = to_triangle_modes<T>(p, 3);
    const Plate4Frame<T> frame(m.xi, m.eta);
    const PlateKinematics::Rate<T> e = detail::triangle_strain(frame, u, w);
    PlateKinematics::Stress<T> stress;
    stress.force =
        detail::plane_stress_of(section.extension, e.membrane) + detail::plane_stress_of(section.coupling, e.curvature);
    stress.moment =
        detail::plane_stress_of(section.coupling, e.membrane) + detail::plane_stress_of(section.bending, e.curvature);
    stress.shear = Vector2<T>{section.transverse_shear * e.shear(0), section.transverse_shear * e.shear(1)};
    Plate3Modes<T> F, G;
    detail::triangle_forces(frame, stress, F, G);
    if constexpr (drills) {
      Plate3Drilling<T> moment(frame, u, w);
      const Plate3Drilling<T> shares = Plate3Drilling<T>::shares();
      moment.s *= drilling * shares.s, moment.xi *= drilling * shares.xi, moment.eta *= drilling * shares.eta;
      moment.add_forces(frame, F, G);
    }
    Nodal<T, 6> f;
    to_triangle_nodes(F, f), to_triangle_nodes(G, f, 3);
    return f;
  }
};

}  // namespace strike
