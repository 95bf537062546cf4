#pragma once
#include <concepts>

#include <strike/tensor/tensor.hpp>

namespace strike {

/// What a solid element measures in a step and what it gets for it: the conjugate pair of the solids.
struct SolidKinematics {
  template <class T>
  struct Rate {
    SymmetricTensor<T> rate_of_deformation;  ///< D = sym(L) at mid-step [1/time]
    T relative_volume{1.0};                  ///< V/V0 at the end of the step
  };
  template <class T>
  using Stress = SymmetricTensor<T>;  ///< Cauchy stress, tension positive
};

/// The change of a volume v in a step of volumetric strain theta = tr(D) dt at mid-step: v_new - v_old, exact to third
/// order.
template <class T>
T volume_increment(const T& v_new, const T& theta) {
  return v_new * (theta / (1.0 + 0.5 * theta));
}

/// Bulk and shear modulus of a material as it stands: they bound its tangent, rho c^2 = bulk + 4/3 shear.
template <class T>
struct Moduli {
  T bulk, shear;

  /// rho c^2 = K + 4/3 G.
  T wave() const { return bulk + T(4.0 / 3.0) * shear; }
};

/// A material: the rate of deformation in, the stress out. It knows no rotation, no mesh and no time loop.
///
/// A model has
/// - `Kinematics`, the pair of measure and stress, and `State<T>`, what it remembers, an aggregate that begins at rest;
/// - `density()`, in the reference configuration;
/// - `stress(state, rate, dt)`: advances the state over dt and returns the stress at its end; `stress(state)`: the part
/// of
///   it that is remembered;
/// - `moduli(state, rate)`;
/// - if it remembers spatial tensors, `state.spatial_tensors()`, a tuple of references: the element turns them;
/// - if its state does not begin at zero, `begin(state)`; if it is viscous, `viscosity()`; if it can fail,
/// `intact(state)`: 1, or 0 once failed; if it knows its energy,
///   `state.internal_energy` per reference volume, to which the element adds what shock viscosity dissipates.
/// Laws (see tests/conformance): at rest the stress does not grow; lane i of a pack gives what a double gives; a closed
/// cycle of strain gives no energy back; rho c^2 + 2 viscosity/dt bounds the tangent.
template <class M>
concept Material = requires(const M m, typename M::template State<double> state,
                            typename M::Kinematics::template Rate<double> rate, double dt) {
  { m.density() } -> std::convertible_to<double>;
  { m.stress(state, rate, dt) } -> std::same_as<typename M::Kinematics::template Stress<double>>;
  { m.stress(state) } -> std::convertible_to<typename M::Kinematics::template Stress<double>>;
  { m.moduli(state, rate) } -> std::same_as<Moduli<double>>;
};

/// Materials of solid elements.
template <class M>
concept SolidMaterial = Material<M> && std::same_as<typename M::Kinematics, SolidKinematics>;

}  // namespace strike
