#pragma once
#include <concepts>
#include <type_traits>

#include <strike/material/report.hpp>
#include <strike/protocol.hpp>
#include <strike/range.hpp>
#include <strike/scalar/dual.hpp>

namespace strike {

/// An equation of state, linear in the energy: p = A(mu) + B(mu) E with mu = rho/rho0 - 1 and the internal energy E per
/// reference volume; pressure is positive in compression.
///
/// Requirements
/// 1. `density`: rho0 [mass/volume].
/// 2. `A(mu)`: the pressure without energy [stress], a template over the number.
/// Optional
/// 3. `B(mu)`: the pressure per energy [1], a template over the number; then the state remembers E.
/// 4. `initial_energy`: E at rest [energy/volume]; needs B(mu).
/// 5. `pressure_cutoff`: the least pressure [stress]; without it every tension is carried.
/// 6. `ranges(number)`: what its numbers may be (strike/range.hpp).
/// Energy update, sound speed (by dual numbers) and memory follow from these.
/// Laws: A is smooth but for finitely many mu; the sound speed is real where the equation is used.
/// Models: LinearEos, CubicEos, PolynomialEos, GruneisenEos, IdealGas, Jwl, TabulatedEos.
template <class E>
concept EquationOfState = requires(const E eos, double mu) {
  { eos.density } -> std::convertible_to<double>;
  { eos.A(mu) } -> std::convertible_to<double>;
};

/// Equations of state in which the energy stands.
template <class E>
concept ThermalEquationOfState = EquationOfState<E> && requires(const E eos, double mu) {
  { eos.B(mu) } -> std::convertible_to<double>;
};

namespace detail {

struct EosFormulaA {
  struct Decoy {
    int A;
  };
  template <class Model>
  using Member = decltype(&Model::A);
  template <class T>
  static auto call(const auto& eos, const T& mu) -> decltype(T(eos.A(mu))) {
    return eos.A(mu);
  }
};
struct EosFormulaB {
  struct Decoy {
    int B;
  };
  template <class Model>
  using Member = decltype(&Model::B);
  template <class T>
  static auto call(const auto& eos, const T& mu) -> decltype(T(eos.B(mu))) {
    return eos.B(mu);
  }
};

/// Flaws of an equation of state, in the order in which they are reported.
enum class EosFlaw { none, absent, A_in_double, B, energy };
template <class E>
constexpr EosFlaw eos_flaw() {
  constexpr bool B_is_number = requires(const E eos) { double(eos.B); };
  if constexpr (!EquationOfState<E>)
    return EosFlaw::absent;
  else if constexpr (!answers<EosFormulaA, const E, const TrialLanes>)
    return EosFlaw::A_in_double;
  else if constexpr (nearly<EosFormulaB, const E, const TrialLanes> && !B_is_number)
    return EosFlaw::B;
  else if constexpr (!ThermalEquationOfState<E> && requires(const E eos) { eos.initial_energy; })
    return EosFlaw::energy;
  else
    return EosFlaw::none;
}

/// Reports what is nearly an equation of state.
template <class E>
struct EosReport {
  static constexpr EosFlaw flaw = eos_flaw<E>();
  static_assert(flaw != EosFlaw::A_in_double,
                "strike: A(mu) of this equation of state takes double alone: make it a template over the number, "
                "template <class T> T A(const T& mu) const.");
  static_assert(flaw != EosFlaw::B,
                "strike: B(mu) of this equation of state has other arguments or another number: write template <class "
                "T> T B(const T& mu) const.");
  static_assert(flaw != EosFlaw::energy,
                "strike: this equation of state has an initial_energy and no B(mu), so that no pressure follows from "
                "it: give it template <class T> T B(const T& mu) const.");

  static void try_on_lanes([[maybe_unused]] const E& eos) {
    if constexpr (flaw == EosFlaw::none) (void)eos.A(TrialLanes(0.0));
    if constexpr (flaw == EosFlaw::none && ThermalEquationOfState<E>) (void)eos.B(TrialLanes(0.0));
  }
  using OnLanes = Tried<&EosReport::try_on_lanes>;
};

struct NoEnergy {
  template <class T>
  struct State {};
};
struct InternalEnergy {
  template <class T>
  struct State {
    T internal_energy{};  ///< E, per reference volume
  };
};
template <class E>
using EnergyMemory = std::conditional_t<ThermalEquationOfState<E>, InternalEnergy, NoEnergy>;

/// The least pressure of an equation of state that does not carry every tension.
template <class E, class T>
T cut_off(const E& eos, const T& p) {
  if constexpr (requires { eos.pressure_cutoff; })
    return max(p, T(eos.pressure_cutoff));
  else
    return (void)eos, p;
}

/// p = A + B E at the end of a step that changes the relative volume by dv, and its E: the one before plus `work`, less
/// the mean of old and new pressure times dv. Closed form, because p is linear in E (Wilkins 1964; Hallquist, LS-DYNA
/// Theory Manual, "Equations of state"). The denominator is bounded at 0.1: a halving of the volume in a step is far
/// beyond a stable one.
template <class E, class T>
T advance_energy(const E& eos, T& internal_energy, const T& A, const T& B, const T& dv, const T& old_pressure,
                 const T& work) {
  const T energy = internal_energy + work - 0.5 * old_pressure * dv;
  const T p = cut_off(eos, T((A + B * energy) / max(T(0.1), 1.0 + 0.5 * B * dv)));
  internal_energy = energy - 0.5 * p * dv;
  return p;
}

}  // namespace detail

/// The memory of an equation of state: its energy, or nothing.
template <EquationOfState E, class T>
using EosState = typename detail::EnergyMemory<E>::template State<T>;

/// Sets the energy at rest and returns the pressure there.
template <EquationOfState E, class State>
double begin_eos(const E& eos, State& state) {
  if constexpr (requires { eos.initial_energy; }) {
    state.internal_energy = eos.initial_energy;
    return eos.A(0.0) + eos.B(0.0) * eos.initial_energy;
  } else {
    return (void)state, eos.A(0.0);
  }
}

/// The pressure at the end of a step that changes the relative volume by dv to J; `deviatoric_work` [energy/reference
/// volume] heats.
template <EquationOfState E, class State, class T>
T advance_pressure(const E& eos, State& state, const T& J, const T& dv, const T& old_pressure,
                   const T& deviatoric_work) {
  const T mu = 1.0 / J - 1.0;
  if constexpr (ThermalEquationOfState<E>)
    return detail::advance_energy<E, T>(eos, state.internal_energy, eos.A(mu), eos.B(mu), dv, old_pressure,
                                        deviatoric_work);
  else
    return detail::cut_off<E, T>(eos, eos.A(mu));
}

/// rho dp/drho at constant entropy: (1 + mu) (A' + B' E) + p B/(1 + mu), at least 1e-6 of its value at rest, so that
/// the sound speed of a released material stays real. Derivatives by dual numbers.
template <EquationOfState E, class State, class T>
T bulk_modulus(const E& eos, const State& state, const T& J, const T& pressure) {
  using D = Dual<T, 1>;
  const T compression = 1.0 / J;
  const D mu = D::variable(compression - 1.0, 0), rest = D::variable(T(0.0), 0);
  const T floor = 1e-6 * D(eos.A(rest)).derivative(0);
  const T cold = D(eos.A(mu)).derivative(0);
  if constexpr (ThermalEquationOfState<E>) {
    const D B = eos.B(mu);
    return max(compression * (cold + B.derivative(0) * state.internal_energy) + pressure * B.value() * J, floor);
  } else {
    return max(compression * cold, floor);
  }
}

namespace detail {
/// The range of what the numbers of an equation of state make together.
template <EquationOfState E>
void ranges_at_rest(const E& eos, const auto& number) {
  EosState<E, double> state{};
  const double pressure = begin_eos(eos, state);
  number("bulk modulus at rest", strike::bulk_modulus(eos, state, 1.0, pressure), range::positive,
         "correct its equation of state");
}
}  // namespace detail

}  // namespace strike
