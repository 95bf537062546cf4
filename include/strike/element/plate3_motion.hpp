#pragma once
#include <strike/element/plate3_modes.hpp>
#include <strike/material/kinematics.hpp>

// The strains of the C0 triangle and their transpose (Belytschko, Stolarski and Carpenter 1984). Velocities and angular
// velocities are linear, so membrane rate and curvature are uniform. The transverse shear is that along the edges,
//   t_k = e3 . (u_J - u_I) + (e3 x l_k) . (w_I + w_J)/2   on the edge l_k from I to J,
// without a part of linear rotations that bend the plate, and in the middle of the plate it is
//   gamma = (1/3) sum_k t_k (grad N_J - grad N_I),
// which are the authors' rows (LS-DYNA Theory Manual, C0 triangular shell). In the modes of the equilateral triangle
// all that the edges add to the shear at the mean rotation is, with the curvatures k along the tangents,
//   gamma_xi = e3 . u_xi + c_xi . w_s/3 - 2 kappa k_xi_eta,   gamma_eta = e3 . u_eta + c_eta . w_s/3
//              - kappa (k_xi_xi - k_eta_eta),   c = e3 x m,   kappa = 3^(1/4)/12.
namespace strike::detail {

inline constexpr double triangle_kappa = Plate3Modes<double>::root / 12;

/// The membrane rate, curvature and transverse shear of velocities u and angular velocities w, in the frame.
template <class T>
PlateKinematics::Rate<T> triangle_strain(const Plate4Frame<T>& frame, const Plate3Modes<T>& u,
                                         const Plate3Modes<T>& w) {
  const Vector3<T>&e3 = frame.normal, &m_xi = frame.m_xi, &m_eta = frame.m_eta;
  const Vector3<T> c_xi = cross(e3, m_xi), c_eta = cross(e3, m_eta);
  const PlaneTensor<T> k{dot(c_xi, w.xi), dot(c_eta, w.eta), 0.5 * (dot(c_xi, w.eta) + dot(c_eta, w.xi))};
  PlateKinematics::Rate<T> rate;
  rate.membrane = frame.turned({dot(m_xi, u.xi), dot(m_eta, u.eta), 0.5 * (dot(m_xi, u.eta) + dot(m_eta, u.xi))});
  rate.curvature = frame.turned(k);
  const T gamma_xi = dot(e3, u.xi) + (1.0 / 3.0) * dot(c_xi, w.s) - (2.0 * triangle_kappa) * k.xy,
          gamma_eta = dot(e3, u.eta) + (1.0 / 3.0) * dot(c_eta, w.s) - triangle_kappa * (k.xx - k.yy);
  rate.shear = frame.turned(gamma_xi, gamma_eta);
  return rate;
}

/// Forces F and moments G on the modes, by which resultants over the whole area do work on those strains.
template <class T>
void triangle_forces(const Plate4Frame<T>& frame, const PlateKinematics::Stress<T>& stress, Plate3Modes<T>& F,
                     Plate3Modes<T>& G) {
  const T& A = frame.area;
  const Vector3<T>&e3 = frame.normal, &m_xi = frame.m_xi, &m_eta = frame.m_eta;
  const PlaneTensor<T> N = A * frame.turned(stress.force), bending = A * frame.turned(stress.moment);
  const Vector2<T> Q = frame.turned(stress.shear(0), stress.shear(1));
  const T Q_xi = A * Q(0), Q_eta = A * Q(1), shared_xi = triangle_kappa * Q_xi, shared_eta = triangle_kappa * Q_eta;
  const PlaneTensor<T> M{bending.xx - shared_eta, bending.yy + shared_eta, bending.xy - shared_xi};
  const Vector3<T> c_xi = cross(e3, m_xi), c_eta = cross(e3, m_eta);
  F.s = Vector3<T>{T(0.0), T(0.0), T(0.0)};
  F.xi = N.xx * m_xi + N.xy * m_eta + Q_xi * e3;
  F.eta = N.xy * m_xi + N.yy * m_eta + Q_eta * e3;
  G.s = ((1.0 / 3.0) * Q_xi) * c_xi + ((1.0 / 3.0) * Q_eta) * c_eta;
  G.xi = M.xx * c_xi + M.xy * c_eta;
  G.eta = M.xy * c_xi + M.yy * c_eta;
}

}  // namespace strike::detail
