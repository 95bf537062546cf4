#pragma once
#include <tuple>

#include <strike/material/material.hpp>
#include <strike/range.hpp>

namespace strike {

/// Isotropic hypoelasticity: the objective rate of the Cauchy stress is lambda tr(D) I + 2 G D.
struct Elastic {
  double density;         ///< in the undeformed configuration
  double youngs_modulus;  ///< [stress]
  double poissons_ratio = 0;

  void ranges(const auto& number) const {
    number("density", density, range::positive);
    number("youngs_modulus", youngs_modulus, range::positive);
    number("poissons_ratio", poissons_ratio, Range{.low = -1, .high = 0.5});
  }

  using Kinematics = SolidKinematics;

  template <class T>
  struct State {
    SymmetricTensor<T> stress{};  ///< Cauchy

    auto spatial_tensors() { return std::tie(stress); }
  };

  double shear_modulus() const { return youngs_modulus / (2 * (1 + poissons_ratio)); }
  double bulk_modulus() const { return youngs_modulus / (3 * (1 - 2 * poissons_ratio)); }

  template <class T>
  SymmetricTensor<T> stress(State<T>& state, const SolidKinematics::Rate<T>& rate, double dt) const {
    const SymmetricTensor<T>& D = rate.rate_of_deformation;
    const double G = shear_modulus(), lambda = bulk_modulus() - 2 * G / 3;
    state.stress += SymmetricTensor<T>::isotropic(lambda * dt * trace(D)) + T(2 * G * dt) * D;
    return state.stress;
  }

  template <class T>
  SymmetricTensor<T> stress(const State<T>& state) const {
    return state.stress;
  }

  template <class T>
  Moduli<T> moduli(const State<T>&, const SolidKinematics::Rate<T>&) const {
    return {T(bulk_modulus()), T(shear_modulus())};
  }
};

}  // namespace strike
