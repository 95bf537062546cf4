#pragma once
#include <strike/material/material.hpp>
#include <strike/scalar/scalar.hpp>
#include <strike/tensor/plane.hpp>

// The pieces that plates of all shapes share.
namespace strike::detail {

/// Mass per moment of inertia [1/length^2]: that of the section, at most `most`, so that the membrane and not the
/// rotations limits the step (after Hughes, Cohen and Haroun 1978).
template <class Section, class T>
T mass_per_gyration(const Section& material, const T& most) {
  return min(T(density_of(material) / material.rotary_inertia()), most);
}

/// The resultants that a section remembers.
template <class Section, class S, class T>
PlateKinematics::Stress<T> remembered(const Section& material, const S& state, const T& relative_thickness) {
  if constexpr (requires { material.stress(state, relative_thickness); })
    return material.stress(state, relative_thickness);
  else
    return material.stress(state);
}

/// N : membrane + M : curvature + Q . shear.
template <class T>
T power(const PlateKinematics::Stress<T>& stress, const PlateKinematics::Rate<T>& rate) {
  return double_dot(stress.force, rate.membrane) + double_dot(stress.moment, rate.curvature) +
         stress.shear(0) * rate.shear(0) + stress.shear(1) * rate.shear(1);
}

/// Advances the resistance R by k q dt and returns the work done against the mean of R before and after.
template <class T>
T resist(T& R, const T& k, const T& q, double dt) {
  const T change = k * (dt * q);
  const T work = (R + 0.5 * change) * (dt * q);
  R += change;
  return work;
}

/// The stress of moduli at a strain.
template <class T>
PlaneTensor<T> plane_stress_of(const PlaneModuli<T>& k, const PlaneTensor<T>& e) {
  return PlaneTensor<T>::isotropic((k.normal - 2.0 * k.shear) * trace(e)) + T(2.0 * k.shear) * e;
}

}  // namespace strike::detail
