#pragma once
#include <concepts>
#include <string>
#include <tuple>

#include <strike/material/eos/eos.hpp>
#include <strike/material/failure/failure.hpp>
#include <strike/material/material.hpp>
#include <strike/material/strength/report.hpp>
#include <strike/material/strength/strength.hpp>
#include <strike/range.hpp>

namespace strike {

namespace detail {
/// Flaws of the pieces of a Solid, in the order in which they are reported.
enum class SolidFlaw { none, no_eos, eos, no_strength, strength, no_failure, failure };
template <class Eos, class S, class Failure>
constexpr SolidFlaw solid_flaw() {
  if constexpr (eos_flaw<Eos>() != EosFlaw::none)
    return eos_flaw<Eos>() == EosFlaw::absent ? SolidFlaw::no_eos : SolidFlaw::eos;
  else if constexpr (strength_flaw<S>() != StrengthFlaw::none)
    return strength_flaw<S>() == StrengthFlaw::absent ? SolidFlaw::no_strength : SolidFlaw::strength;
  else if constexpr (failure_flaw<Failure>() != FailureFlaw::none)
    return failure_flaw<Failure>() == FailureFlaw::absent ? SolidFlaw::no_failure : SolidFlaw::failure;
  else
    return SolidFlaw::none;
}
}  // namespace detail

/// A solid: an equation of state for the pressure, a strength for the change of shape, and if it can fail a failure
/// law.
///   Solid copper{LinearEos{.density = 8930, .bulk_modulus = 130e9},
///                VonMises{.shear_modulus = 43.3e9, .yield_stress = 400e6, .hardening_modulus = 100e6}};
template <class Eos, class S, class Failure = NoFailure, class... More>
struct Solid {
  static constexpr detail::SolidFlaw flaw = detail::solid_flaw<Eos, S, Failure>();
  static_assert(
      flaw != detail::SolidFlaw::no_eos,
      "strike: the first piece of a Solid is its equation of state, with a density and A(mu), such as LinearEos.");
  static_assert(flaw != detail::SolidFlaw::no_strength,
                "strike: the second piece of a Solid is its strength, with a shear_modulus and a flow_stress, such as "
                "VonMises or ElasticStrength.");
  static_assert(
      flaw != detail::SolidFlaw::no_failure,
      "strike: the third piece of a Solid is its failure, such as UltimateStress, FailureStrain or NoFailure.");
  static_assert(instantiates(static_cast<detail::EosReport<Eos>*>(nullptr)));
  static_assert(instantiates(static_cast<detail::StrengthReport<S>*>(nullptr)));
  static_assert(instantiates(static_cast<detail::FailureReport<Failure>*>(nullptr)));

  Eos eos;
  S strength;
  [[no_unique_address]] Failure failure{};

  void ranges(const auto& number) const {
    number(eos), number(strength), number(failure);
    detail::ranges_at_rest(eos, number);
  }

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

 private:
  static constexpr bool failure_knows_state() {
    if constexpr (flaw == detail::SolidFlaw::none && can_fail)
      return detail::answers<detail::Fails, const Failure, const double, const State<double>>;
    else
      return true;
  }
  static constexpr bool can_fail = !std::same_as<Failure, NoFailure>;

 public:
  static constexpr bool sound = flaw == detail::SolidFlaw::none && failure_knows_state();
  static_assert(failure_knows_state(),
                "strike: this failure law needs a member of the state that this Solid does not have, such as the "
                "plastic strain of a strength that flows.");

  double density() const { return eos.density; }

  /// The state at rest.
  template <class T>
  void begin(State<T>& state) const {
    state = {};
    state.stress = SymmetricTensor<T>::isotropic(-begin_eos(eos, state));
  }

  /// A text for the user, empty if there is nothing to say.
  std::string warning() const
    requires requires(S law) { law.warning(); }
  {
    return strength.warning();
  }

  template <class T>
  SymmetricTensor<T> stress(State<T>& state, const SolidKinematics::Rate<T>& rate, double dt) const {
    const auto& [D, J] = detail::rate_if_intact(*this, state, rate);
    const SymmetricTensor<T> s_old = deviator(state.stress), d = T(dt) * deviator(D);
    const T p_old = (-1.0 / 3.0) * trace(state.stress);
    const T dv = volume_increment<T>(J, dt * trace(D));

    [[maybe_unused]] const T strain_old = detail::plastic_strain<T>(state);
    const SymmetricTensor<T> s = advance_deviator(strength, state, s_old, d, dt, J);
    const T deviatoric_work = (J - 0.5 * dv) * (0.5 * double_dot(s_old + s, d));
    const T p = advance_pressure(eos, state, J, dv, p_old, deviatoric_work);
    state.stress = s - SymmetricTensor<T>::isotropic(p);
    if constexpr (can_fail) {
      const auto fails = detail::fails_now<Failure, T>(failure, state, equivalent_stress(s), strain_old, dt);
      if constexpr (detail::has_intact<State<T>>) {
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
    const T J = detail::rate_if_intact(*this, state, rate).relative_volume;
    return {strike::bulk_modulus<Eos, State<T>, T>(eos, state, J, pressure), shear_modulus(state, J)};
  }

  /// The flow stress at the plastic strain of the state and this rate of it [1/time].
  template <class T>
    requires(FlowLaw<S> || detail::HasYieldRadius<S>)
  T flow_stress(const State<T>& state, [[maybe_unused]] const T& rate) const {
    if constexpr (FlowLaw<S>)
      return detail::flow_stress<S, T>(strength, state, state.equivalent_plastic_strain, rate);
    else
      return strength.yield_radius(state);
  }
  static constexpr bool flow_is_rate_independent = !FlowLaw<S> || RateIndependentFlow<S>;

  /// Plastic flow beyond that of the mean stress, of which an element knows: the deviator returns to the share `kept`
  /// of its distance from the centre of the yield surface, the plastic strain grows by the increment at the flow
  /// stress.
  template <class T>
    requires requires(State<T> state) { state.equivalent_plastic_strain; }
  void flow(State<T>& state, const T& kept, const T& increment, [[maybe_unused]] const T& flow_stress) const {
    SymmetricTensor<T> from_centre = deviator(state.stress);
    if constexpr (requires { state.back_stress; }) from_centre = from_centre - state.back_stress;
    state.stress = state.stress - (1.0 - kept) * from_centre;
    state.equivalent_plastic_strain += increment;
    if constexpr (ThermalFlow<S>) state.temperature_rise += strength.heating * flow_stress * increment;
  }

  template <class T>
    requires detail::has_intact<State<T>>
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
};

/// Fallback for a Solid with too many pieces: its static_assert reports it.
template <class Eos, class S, class Failure, class... More>
  requires(sizeof...(More) > 0)
struct Solid<Eos, S, Failure, More...> {
  static_assert(sizeof...(More) == 0,
                "strike: a Solid has two or three pieces: its equation of state, its strength and its failure.");
  static constexpr bool sound = false;
  using Kinematics = SolidKinematics;
  Solid(const Eos&, const S&, const Failure&, const More&...) {}
};

template <class Eos, class S>
Solid(Eos, S) -> Solid<Eos, S>;
template <class Eos, class S, class Failure, class... More>
Solid(Eos, S, Failure, More...) -> Solid<Eos, S, Failure, More...>;

}  // namespace strike
