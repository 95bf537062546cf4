#pragma once
#include <tuple>

#include <strike/material/eos/eos.hpp>
#include <strike/material/failure/failure.hpp>
#include <strike/material/material.hpp>
#include <strike/material/strength/strength.hpp>

namespace strike {

/// A solid: an equation of state for the pressure, a strength for the change of shape, and if it can fail, when.
///   Solid copper{LinearEos{.density = 8930, .bulk_modulus = 130e9},
///                VonMises{.shear_modulus = 43.3e9, .yield_stress = 400e6, .hardening_modulus = 100e6}};
template <EquationOfState Eos, Strength S, class Failure = NoFailure>
struct Solid {
  Eos eos;
  S strength;
  [[no_unique_address]] Failure failure{};

  using Kinematics = SolidKinematics;

  template <class T>
  struct State : EosState<Eos, T>, StrengthState<S, T>, Failure::template State<T> {
    SymmetricTensor<T> stress{};  ///< Cauchy

    auto spatial_tensors() { return std::tie(stress); }
  };

  double density() const { return eos.density; }

  /// The state before the first step.
  template <class T>
  void begin(State<T>& state) const {
    state = {};
    state.stress = SymmetricTensor<T>::isotropic(-begin_eos(eos, state));
  }

  template <class T>
  SymmetricTensor<T> stress(State<T>& state, const SolidKinematics::Rate<T>& rate, double dt) const {
    const SymmetricTensor<T>& D = rate.rate_of_deformation;
    const T& J = rate.relative_volume;
    const SymmetricTensor<T> s_old = deviator(state.stress), d = T(dt) * deviator(D);
    const T p_old = (-1.0 / 3.0) * trace(state.stress);
    const T dv = volume_increment<T>(J, dt * trace(D));

    const SymmetricTensor<T> s = advance_deviator(strength, state, s_old, d, dt);
    const T deviatoric_work = (J - 0.5 * dv) * (0.5 * double_dot(s_old + s, d));
    const T p = advance_pressure(eos, state, J, dv, p_old, deviatoric_work);
    state.stress = s - SymmetricTensor<T>::isotropic(p);
    if constexpr (requires { state.intact; }) {
      state.intact = select(failure.fails(equivalent_stress(s), state), T(0.0), state.intact);
      state.stress = state.intact * state.stress;
    }
    return state.stress;
  }

  template <class T>
  SymmetricTensor<T> stress(const State<T>& state) const {
    return state.stress;
  }

  template <class T>
  Moduli<T> moduli(const State<T>& state, const SolidKinematics::Rate<T>& rate) const {
    const T pressure = (-1.0 / 3.0) * trace(state.stress);
    return {strike::bulk_modulus(eos, state, rate.relative_volume, pressure), T(strength.shear_modulus)};
  }

  template <class T>
  requires requires(State<T> state) { state.intact; }
  T intact(const State<T>& state) const { return state.intact; }
};

template <class Eos, class S>
Solid(Eos, S) -> Solid<Eos, S>;
template <class Eos, class S, class Failure>
Solid(Eos, S, Failure) -> Solid<Eos, S, Failure>;

}  // namespace strike
