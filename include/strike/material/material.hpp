#pragma once
#include <concepts>

#include <strike/material/kinematics.hpp>

namespace strike {

/// The density of a material in its reference configuration, a member `density` or the function `density()`: mass per
/// volume, of a plate's section per area.
template <class M>
  requires requires(const M m) {
    { m.density() } -> std::convertible_to<double>;
  }
double density_of(const M& material) {
  return material.density();
}
template <class M>
  requires requires(const M m) {
    { m.density } -> std::convertible_to<double>;
  }
double density_of(const M& material) {
  return material.density;
}

/// A material: the rate of deformation in, the stress out. It knows no rotation, no mesh and no time loop.
///
/// A model has
/// - `Kinematics`, the pair of measure and stress (strike/material/kinematics.hpp), and `State<T>`, what it remembers,
/// an aggregate that begins at rest;
/// - `density`, a number or a function without arguments, see density_of;
/// - `stress(state, rate, dt)`: advances the state over dt and returns the stress at its end; `stress(state)`: the part
/// of
///   it that is remembered;
/// - `moduli(state, rate)`;
/// - a section its `thickness()` and `rotary_inertia()`, int rho z^2 dz [mass]; a point of it `normal_rate(state, rate,
/// dt, change)`, d_zz of the step that changed its stress so;
/// - if it remembers spatial tensors, `state.spatial_tensors()`, a tuple of references: the element turns them;
/// - if its state does not begin at zero, `begin(state)`, and of solids that begin differently from place to place
/// `begin(state, place)` beside it; if it is viscous, `viscosity()`; if it can fail,
/// `intact(state)`: 1, or 0 once failed; if it knows its energy,
///   `state.internal_energy` per reference volume, to which the element adds what shock viscosity dissipates.
/// Laws (see tests/conformance): at rest the stress does not grow (but where a viscoelastic one recovers); lane i of a
/// pack gives what a double gives; a closed cycle of strain gives no energy back; rho c^2 + 2 viscosity/dt bounds the
/// tangent.
template <class M>
concept Material = requires(const M m, typename M::template State<double> state,
                            typename M::Kinematics::template Rate<double> rate, double dt) {
  { density_of(m) } -> std::convertible_to<double>;
  { m.stress(state, rate, dt) } -> std::same_as<typename M::Kinematics::template Stress<double>>;
  { m.stress(state) } -> std::convertible_to<typename M::Kinematics::template Stress<double>>;
  { m.moduli(state, rate) } -> std::same_as<typename M::Kinematics::template Moduli<double>>;
};

/// Materials of solid elements.
template <class M>
concept SolidMaterial = Material<M> && std::same_as<typename M::Kinematics, SolidKinematics>;
/// Materials of the layers of a plate.
template <class M>
concept PlaneMaterial = Material<M> && std::same_as<typename M::Kinematics, PlaneStressKinematics>;
/// Sections, the materials of plates.
template <class M>
concept PlateSection = Material<M> && std::same_as<typename M::Kinematics, PlateKinematics>;

namespace detail {
/// What has complained about itself already says so by `sound`.
template <class M>
constexpr bool is_reported() {
  if constexpr (requires { M::sound; })
    return !M::sound;
  else
    return false;
}
}  // namespace detail

}  // namespace strike
