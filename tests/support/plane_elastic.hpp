#pragma once
#include <strike/material/material.hpp>

namespace strike::testing {

/// Hooke's law in plane stress: sigma = nu E/(1 - nu^2) tr(e) I + 2 G e.
struct PlaneElastic {
  double youngs_modulus, poissons_ratio, reference_density = 1;

  using Kinematics = PlaneStressKinematics;
  template <class T>
  struct State {
    PlaneTensor<T> stress{};
  };

  double density() const { return reference_density; }
  PlaneModuli<double> elastic() const {
    return {youngs_modulus / (1 - poissons_ratio * poissons_ratio), youngs_modulus / (2 * (1 + poissons_ratio))};
  }
  template <class T>
  PlaneTensor<T> stress(State<T>& state, const PlaneStressKinematics::Rate<T>& rate, double dt) const {
    const PlaneTensor<T>& D = rate.rate_of_deformation;
    const double G = elastic().shear, lambda = elastic().normal - 2 * G;
    state.stress += PlaneTensor<T>::isotropic(lambda * dt * trace(D)) + T(2 * G * dt) * D;
    return state.stress;
  }
  template <class T>
  PlaneTensor<T> stress(const State<T>& state) const {
    return state.stress;
  }
  template <class T>
  PlaneModuli<T> moduli(const State<T>&, const PlaneStressKinematics::Rate<T>&) const {
    return {T(elastic().normal), T(elastic().shear)};
  }
  template <class T>
  T normal_rate(const State<T>&, const PlaneStressKinematics::Rate<T>& rate, double, const PlaneTensor<T>&) const {
    return -poissons_ratio / (1 - poissons_ratio) * trace(rate.rate_of_deformation);
  }
};

}  // namespace strike::testing
