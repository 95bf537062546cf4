#pragma once
#include <limits>
#include <utility>

#include <strike/material/eos/eos.hpp>
#include <strike/material/material.hpp>

namespace strike {

/// A detonation that starts from a point.
struct DetonationPoint {
  Eigen::Vector3d place;
  double time = 0;

  template <class T>
  T distance(const Vector3<T>& x) const {
    const Vector3<T> r{x(0) - place(0), x(1) - place(1), x(2) - place(2)};
    return sqrt(max(dot(r, r), T(std::numeric_limits<RealOf<T>>::min())));
  }
};

/// A detonation that starts from a plane and runs along its normal, and the other way.
struct DetonationPlane {
  Eigen::Vector3d place, normal;
  double time = 0;

  template <class T>
  T distance(const Vector3<T>& x) const {
    const Eigen::Vector3d n = normal.normalized();
    return abs((x(0) - place(0)) * n(0) + (x(1) - place(1)) * n(1) + (x(2) - place(2)) * n(2));
  }
};

/// How a detonation is programmed.
struct Burn {
  double detonation_velocity;  ///< D
  double front_width;          ///< w, over which the front is spread: 3 to 6 elements [length]
  double pressure_CJ = 0;      ///< p_CJ of Chapman and Jouguet; 0: compression burns nothing
};

/// An explosive (Wilkins 1964; LS-DYNA *MAT_HIGH_EXPLOSIVE_BURN): the pressure is F times that of its products,
///   F = max(D (t - t0)/w, (1 - V)/(1 - V_CJ)),  V_CJ = 1 - p_CJ/(rho0 D^2),  from 0 to 1 and never back.
/// t0 is when the front comes by from where it starts; the second term is what compression burns. What is not lit yet
/// resists nothing.
///   Explosive{tnt, DetonationPoint{{0, 0, 0}}, Burn{.detonation_velocity = 6930, .front_width = 0.01}}
template <ThermalEquationOfState Eos, class Ignition>
struct Explosive {
  Eos products;
  Ignition ignition;
  Burn burn;

  using Kinematics = SolidKinematics;

  template <class T>
  struct State : EosState<Eos, T> {
    T pressure{};
    T burnt{};           ///< F
    T time_since_lit{};  ///< t - t0 [time]
  };

  double density() const { return products.density; }
  /// The state before the first step of what is lit when the detonation starts.
  template <class T>
  void begin(State<T>& state) const {
    state = {};
    begin_eos(products, state);
    state.time_since_lit = T(-ignition.time);
  }
  /// That of a point at this place.
  template <class T>
  void begin(State<T>& state, const Vector3<T>& place) const {
    begin(state);
    state.time_since_lit -= (1 / burn.detonation_velocity) * ignition.distance(place);
  }

  template <class T>
  SymmetricTensor<T> stress(State<T>& state, const SolidKinematics::Rate<T>& rate, double dt) const {
    const T& J = rate.relative_volume;
    const T dv = volume_increment<T>(J, dt * trace(rate.rate_of_deformation)), mu = 1.0 / J - 1.0;
    state.time_since_lit += dt;
    T burnt = max(state.burnt, (burn.detonation_velocity / burn.front_width) * state.time_since_lit);
    if (burn.pressure_CJ > 0) burnt = max(burnt, burn_by_compression() * (1.0 - J));
    state.burnt = min(T(1.0), burnt);

    // as advance_pressure, with F A and F B
    const T energy = state.internal_energy - 0.5 * state.pressure * dv, B = state.burnt * products.B(mu);
    state.pressure = (state.burnt * products.A(mu) + B * energy) / max(T(0.1), 1.0 + 0.5 * B * dv);
    state.internal_energy = energy - 0.5 * state.pressure * dv;
    return stress(std::as_const(state));
  }

  template <class T>
  SymmetricTensor<T> stress(const State<T>& state) const {
    return SymmetricTensor<T>::isotropic(-state.pressure);
  }

  /// Bounds: that of the products, whether they are there yet or not, and what burning adds, J p/(1 - V_CJ).
  template <class T>
  Moduli<T> moduli(const State<T>& state, const SolidKinematics::Rate<T>& rate) const {
    const T& J = rate.relative_volume;
    const T mu = 1.0 / J - 1.0, p = products.A(mu) + products.B(mu) * state.internal_energy;
    const T K = strike::bulk_modulus(products, state, J, p);
    const double burning = burn.pressure_CJ > 0 ? burn_by_compression() : 0;
    return {K + select(state.burnt < 1.0, burning * J * max(p, T(0.0)), T(0.0)), T(0.0)};
  }

 private:
  /// 1/(1 - V_CJ).
  double burn_by_compression() const {
    const double D = burn.detonation_velocity;
    return products.density * D * D / burn.pressure_CJ;
  }
};
template <class Eos, class Ignition>
Explosive(Eos, Ignition, Burn) -> Explosive<Eos, Ignition>;

}  // namespace strike
