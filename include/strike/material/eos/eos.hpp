#pragma once
#include <concepts>

#include <strike/scalar/dual.hpp>

namespace strike {

/// An equation of state, linear in the energy: p = A(mu) + B(mu) E with mu = rho/rho0 - 1 and E the internal energy per
/// reference volume; pressure positive in compression. A model is an aggregate with its reference `density` and the
/// formula `A(mu)`; if the pressure depends on the energy also `B(mu)`, and `initial_energy` if it does not begin at
/// none; if it does not carry every tension `pressure_cutoff`, the least pressure. All the rest follows from these.
/// Law: the sound speed is real where the equation is used.
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

struct NoEnergy {
  template <class T>
  struct State {};
};
struct Energy {
  template <class T>
  struct State {
    T internal_energy{};  ///< per reference volume
  };
};
template <class E>
constexpr auto initial_energy_state() {
  if constexpr (ThermalEquationOfState<E>)
    return Energy{};
  else
    return NoEnergy{};
}

}  // namespace detail

/// What a material with this equation of state has to remember for it: the energy, or nothing.
template <EquationOfState E, class T>
using EosState = typename decltype(detail::initial_energy_state<E>())::template State<T>;

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

/// The pressure at the end of a step that changes the relative volume by dv to J and does the deviatoric work
/// `deviatoric_work` per reference volume. The energy is implicit, which is closed-form because the equation is linear
/// in it (Wilkins 1964; Hallquist, LS-DYNA Theory Manual, "Equations of state").
template <EquationOfState E, class State, class T>
T advance_pressure(const E& eos, State& state, const T& J, const T& dv, const T& old_pressure,
                   const T& deviatoric_work) {
  const T mu = 1.0 / J - 1.0;
  const auto cut = [&](const T& p) -> T {
    if constexpr (requires { eos.pressure_cutoff; })
      return max(p, T(eos.pressure_cutoff));
    else
      return p;
  };
  if constexpr (ThermalEquationOfState<E>) {
    const T energy = state.internal_energy + deviatoric_work - 0.5 * old_pressure * dv;
    const T A = eos.A(mu), B = eos.B(mu);
    const T p =
        cut((A + B * energy) / max(T(0.1), 1.0 + 0.5 * B * dv));  // a halving per step is far beyond any stable one
    state.internal_energy = energy - 0.5 * p * dv;
    return p;
  } else {
    return cut(eos.A(mu));
  }
}

/// rho dp/drho at constant entropy: (1 + mu) (A' + B' E) + p B/(1 + mu), never less than 1e-6 of its value at rest, so
/// that the sound speed of a released material stays real. The derivatives are those of the formulas, by dual numbers.
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

}  // namespace strike
