#pragma once
#include <string>
#include <tuple>

#include <strike/material/eos/eos.hpp>
#include <strike/material/failure/failure.hpp>
#include <strike/material/material.hpp>
#include <strike/material/strength/strength.hpp>

namespace strike {

/// A solid: an equation of state for the pressure, a strength for the change of shape, and if it can fail, when.
///   Solid copper{LinearEos{.density = 8930, .bulk_modulus = 130e9},
///                VonMises{.shear_modulus = 43.3e9, .yield_stress = 400e6, .hardening_modulus = 100e6}};
template <class Eos, class S, class Failure = NoFailure>
struct Solid {
  static constexpr bool has_eos = EquationOfState<Eos>, has_strength = Strength<S>,
                        has_failure = FailureCriterion<Failure>, sound = has_eos && has_strength && has_failure;
  static_assert(
      has_eos,
      "strike: the first piece of a Solid is its equation of state, with a density and A(mu), such as LinearEos.");
  static_assert(!has_eos || has_strength,
                "strike: the second piece of a Solid is its strength, with a shear_modulus and a flow_stress, such as "
                "VonMises or ElasticStrength.");
  static_assert(
      !has_eos || !has_strength || has_failure,
      "strike: the third piece of a Solid is its failure, such as UltimateStress, FailureStrain or NoFailure.");

  Eos eos;
  S strength;
  [[no_unique_address]] Failure failure{};

  using Kinematics = SolidKinematics;

  template <class T>
  struct State : EosState<Eos, T>, StrengthState<S, T>, Failure::template State<T> {
    SymmetricTensor<T> stress{};  ///< Cauchy

    auto spatial_tensors() {
      using Memory = StrengthState<S, T>;
      if constexpr (requires(Memory memory) { memory.spatial_tensors(); })
        return std::tuple_cat(std::tie(stress), Memory::spatial_tensors());
      else
        return std::tie(stress);
    }
  };

  double density() const { return eos.density; }

  /// The state before the first step.
  template <class T>
  void begin(State<T>& state) const {
    state = {};
    state.stress = SymmetricTensor<T>::isotropic(-begin_eos(eos, state));
  }

  /// What the user should know, if anything.
  std::string warning() const
    requires requires(S law) { law.warning(); }
  {
    return strength.warning();
  }

  template <class T>
  SymmetricTensor<T> stress(State<T>& state, const SolidKinematics::Rate<T>& rate, double dt) const {
    const auto& [D, J] = felt(state, rate);
    const SymmetricTensor<T> s_old = deviator(state.stress), d = T(dt) * deviator(D);
    const T p_old = (-1.0 / 3.0) * trace(state.stress);
    const T dv = volume_increment<T>(J, dt * trace(D));

    [[maybe_unused]] const T strain_old = detail::plastic_strain<T>(state);
    const SymmetricTensor<T> s = advance_deviator(strength, state, s_old, d, dt, J);
    const T deviatoric_work = (J - 0.5 * dv) * (0.5 * double_dot(s_old + s, d));
    const T p = advance_pressure(eos, state, J, dv, p_old, deviatoric_work);
    state.stress = s - SymmetricTensor<T>::isotropic(p);
    if constexpr (requires { failure.fails(p, state); }) {
      const auto fails = detail::fails_now<Failure, T>(failure, state, equivalent_stress(s), strain_old, dt);
      if constexpr (requires { state.intact; }) {
        state.intact = select(fails, T(0.0), state.intact);
        state.stress = select(state.intact > 0.0, state.stress, SymmetricTensor<T>{});
      } else {
        state.solid = select(fails, T(0.0), state.solid);
        state.stress = select(state.solid > 0.0, state.stress, SymmetricTensor<T>::isotropic(-max(p, T(0.0))));
      }
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
    const T J = felt(state, rate).relative_volume;
    return {strike::bulk_modulus<Eos, State<T>, T>(eos, state, J, pressure), shear_modulus(state, J)};
  }

  template <class T>
    requires requires(State<T> state) { state.intact; }
  T intact(const State<T>& state) const {
    return state.intact;
  }

 private:
  template <class T>
  T shear_modulus(const State<T>& state, const T& J) const {
    if constexpr (requires { strength.stiffness(state, J); })
      return strength.stiffness(state, J);
    else
      return (void)state, (void)J, T(strength.shear_modulus);
  }

  /// What has failed feels no motion, however wild.
  template <class T>
  static decltype(auto) felt(const State<T>& state, const SolidKinematics::Rate<T>& rate) {
    if constexpr (requires { state.intact; }) {
      const auto intact = state.intact > 0.0;
      return SolidKinematics::Rate<T>{select(intact, rate.rate_of_deformation, SymmetricTensor<T>{}),
                                      select(intact, rate.relative_volume, T(1.0))};
    } else {
      return (rate);
    }
  }
};

template <class Eos, class S>
Solid(Eos, S) -> Solid<Eos, S>;
template <class Eos, class S, class Failure>
Solid(Eos, S, Failure) -> Solid<Eos, S, Failure>;

}  // namespace strike
