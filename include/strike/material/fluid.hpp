#pragma once
#include <strike/material/eos/eos.hpp>
#include <strike/material/material.hpp>
#include <strike/range.hpp>

namespace strike {

/// Absence of viscosity.
struct Inviscid {};

/// Newtonian viscosity, s = 2 eta dev(D).
struct Newtonian {
  double viscosity;  ///< eta, dynamic [stress time]

  void ranges(const auto& number) const { number("viscosity", viscosity, range::not_negative); }
};

/// A fluid: an equation of state, and if it is viscous a viscosity, Inviscid or Newtonian. Its memory is the pressure,
/// so that no tensor is turned.
template <class Eos, class Viscosity = Inviscid, class... More>
struct Fluid {
  static constexpr bool has_eos = detail::eos_flaw<Eos>() != detail::EosFlaw::absent,
                        sound_eos = detail::eos_flaw<Eos>() == detail::EosFlaw::none,
                        has_viscosity = std::same_as<Viscosity, Inviscid> || std::same_as<Viscosity, Newtonian>,
                        sound = sound_eos && has_viscosity;
  static_assert(
      has_eos,
      "strike: the first piece of a Fluid is its equation of state, with a density and A(mu), such as CubicEos.");
  static_assert(!sound_eos || has_viscosity,
                "strike: the second piece of a Fluid is its viscosity, Inviscid or Newtonian.");
  static_assert(instantiates(static_cast<detail::EosReport<Eos>*>(nullptr)));

  Eos eos;
  [[no_unique_address]] Viscosity viscous{};

  void ranges(const auto& number) const {
    number(eos), number(viscous);
    detail::ranges_at_rest(eos, number);
  }

  using Kinematics = SolidKinematics;
  static constexpr bool has_shear_modulus = false;

  template <class T>
  struct State : EosState<Eos, T> {
    T pressure{};
  };

  double density() const { return eos.density; }
  /// The state at rest.
  template <class T>
  void begin(State<T>& state) const {
    state = {};
    state.pressure = begin_eos(eos, state);
  }
  double viscosity() const
    requires requires(Viscosity v) { v.viscosity; }
  {
    return viscous.viscosity;
  }

  template <class T>
  SymmetricTensor<T> stress(State<T>& state, const SolidKinematics::Rate<T>& rate, double dt) const {
    const T& J = rate.relative_volume;
    const T dv = volume_increment<T>(J, dt * trace(rate.rate_of_deformation));
    if constexpr (requires { viscous.viscosity; }) {
      const SymmetricTensor<T> d = deviator(rate.rate_of_deformation);
      const SymmetricTensor<T> s = T(2.0 * viscous.viscosity) * d;
      state.pressure =
          advance_pressure<Eos, State<T>, T>(eos, state, J, dv, state.pressure, (J - 0.5 * dv) * double_dot(s, d) * dt);
      return s - SymmetricTensor<T>::isotropic(state.pressure);
    } else {
      state.pressure = advance_pressure<Eos, State<T>, T>(eos, state, J, dv, state.pressure, T(0.0));
      return SymmetricTensor<T>::isotropic(-state.pressure);
    }
  }

  template <class T>
  SymmetricTensor<T> stress(const State<T>& state) const {
    return SymmetricTensor<T>::isotropic(-state.pressure);
  }

  template <class T>
  Moduli<T> moduli(const State<T>& state, const SolidKinematics::Rate<T>& rate) const {
    return {strike::bulk_modulus(eos, state, rate.relative_volume, state.pressure), T(0.0)};
  }
};

/// Fallback for a Fluid with too many pieces: its static_assert reports it.
template <class Eos, class Viscosity, class... More>
  requires(sizeof...(More) > 0)
struct Fluid<Eos, Viscosity, More...> {
  static_assert(sizeof...(More) == 0,
                "strike: a Fluid has one or two pieces, its equation of state and its viscosity: a failure law stands "
                "in a Solid.");
  static constexpr bool sound = false;
  using Kinematics = SolidKinematics;
  Fluid(const Eos&, const Viscosity&, const More&...) {}
};

template <class Eos>
Fluid(Eos) -> Fluid<Eos>;
template <class Eos, class Viscosity, class... More>
Fluid(Eos, Viscosity, More...) -> Fluid<Eos, Viscosity, More...>;

}  // namespace strike
