#pragma once
#include <array>
#include <tuple>

#include <strike/element/hex8_modes.hpp>

namespace strike {

/// The four vectors of the hourglass modes b1, b2, b3 and d of a hexahedron: rates, or the resistance to them.
template <class T>
using HourglassModes = std::array<Vector3<T>, 4>;

/// What an hourglass control may know of its element.
template <class T>
struct HourglassElement {
  T mass, volume;
  T wave_speed, shear_modulus;
  T gradient_squared;  ///< B_iI B_iI
  T dt;
};

/// Nothing resists the hourglass modes.
struct NoHourglass {
  template <class T>
  struct State {};
};

/// Resistance against the rate of the hourglass modes, a = Q rho V^(2/3) c/4 (Flanagan and Belytschko 1981; LS-DYNA
/// type 3).
struct ViscousHourglass {
  double coefficient = 0.1;  ///< Q, usually 0.05 to 0.15; cubes need Q < 0.125/(step factor) or the step shrinks

  template <class T>
  struct State {};

  template <class T>
  T damping(const HourglassElement<T>& e) const {
    return (0.25 * coefficient) * e.mass * e.wave_speed / cbrt(e.volume);
  }
  template <class T>
  HourglassModes<T> resistance(State<T>&, const HourglassElement<T>& e, const HourglassModes<T>& rates) const {
    const T a = damping(e);
    return {a * rates[0], a * rates[1], a * rates[2], a * rates[3]};
  }
  /// Work done against the resistance in the step.
  template <class T>
  T work(const HourglassElement<T>& e, const HourglassModes<T>& Q, const HourglassModes<T>& rates) const {
    return e.dt * (Q[0].dot(rates[0]) + Q[1].dot(rates[1]) + Q[2].dot(rates[2]) + Q[3].dot(rates[3]));
  }
  /// Rate of decay of the hourglass modes, a |gamma|^2/m with m = mass/8; `gamma_squared` is the largest |gamma_k|^2.
  template <class T>
  T decay(const HourglassElement<T>& e, const T& gamma_squared) const {
    return 8.0 * damping(e) * gamma_squared / e.mass;
  }
};

/// Resistance against the hourglass modes themselves, dQ/dt = kappa 2 G B:B/(8 V) qdot (Flanagan and Belytschko 1981).
struct StiffnessHourglass {
  double coefficient = 0.005;  ///< kappa, usually 0.001 to 0.01

  template <class T>
  struct State {
    HourglassModes<T> resistance{Vector3<T>::Zero(), Vector3<T>::Zero(), Vector3<T>::Zero(), Vector3<T>::Zero()};

    auto spatial_tensors() { return std::tie(resistance[0], resistance[1], resistance[2], resistance[3]); }
  };

  template <class T>
  T stiffness(const HourglassElement<T>& e) const {
    return (0.25 * coefficient) * e.shear_modulus * e.gradient_squared / e.volume;
  }
  template <class T>
  HourglassModes<T> resistance(State<T>& state, const HourglassElement<T>& e, const HourglassModes<T>& rates) const {
    const T k = stiffness(e) * e.dt;
    for (std::size_t i = 0; i < 4; ++i) state.resistance[i] += k * rates[i];
    return state.resistance;
  }
  /// Work done against the mean of the resistances before and after the step.
  template <class T>
  T work(const HourglassElement<T>& e, const HourglassModes<T>& Q, const HourglassModes<T>& rates) const {
    const T half = 0.5 * stiffness(e) * e.dt;
    T sum = T(0.0);
    for (std::size_t i = 0; i < 4; ++i) sum += (Q[i] - half * rates[i]).dot(rates[i]);
    return e.dt * sum;
  }
  /// Square of the frequency of the hourglass modes, k |gamma|^2/m.
  template <class T>
  T frequency_squared(const HourglassElement<T>& e, const T& gamma_squared) const {
    return 8.0 * stiffness(e) * gamma_squared / e.mass;
  }
};

}  // namespace strike
