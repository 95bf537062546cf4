#pragma once
#include <cstddef>
#include <tuple>

#include <strike/element/policies.hpp>
#include <strike/range.hpp>

namespace strike {

/// Absence of a resistance to the hourglass modes.
struct NoHourglass {
  template <class T>
  struct State {};
};

/// Resistance against the rate of the hourglass modes, a qdot with a = Q rho c V^(2/3)/4 (Flanagan and Belytschko 1981;
/// LS-DYNA type 3).
struct ViscousHourglass {
  double coefficient = 0.1;  ///< Q, usually 0.05 to 0.15; in cubes above 0.125/(step factor) it shortens the step

  void ranges(const auto& number) const { number("coefficient", coefficient, range::between(0, 100)); }

  template <class T>
  struct State {};

  template <class T>
  T damping(const HourglassElement<T>& e) const {
    return (0.25 * coefficient) * e.edge * e.edge * sqrt(e.density * e.wave_modulus);
  }
  template <class T>
  HourglassModes<T> resistance(State<T>&, const HourglassElement<T>& e, const HourglassModes<T>& rates) const {
    const T a = damping(e);
    return {a * rates[0], a * rates[1], a * rates[2], a * rates[3]};
  }
  /// Work done against the resistance in the step [energy].
  template <class T>
  T work(const HourglassElement<T>& e, const HourglassModes<T>& Q, const HourglassModes<T>& rates) const {
    return e.dt * (dot(Q[0], rates[0]) + dot(Q[1], rates[1]) + dot(Q[2], rates[2]) + dot(Q[3], rates[3]));
  }
  /// One over the largest step that this alone allows, half the rate of decay a |Lambda|^2/m = 64 a/(rho V).
  template <class T>
  T critical_rate(const HourglassElement<T>& e) const {
    return critical_rate(e, damping(e));
  }
  template <class T>
  static T critical_rate(const HourglassElement<T>& e, const T& a) {
    return 32.0 * a * e.per_mass;
  }
};

namespace detail {
template <class Condition, class T>
Vector3<T> selected(const Condition& c, const Vector3<T>& a, const Vector3<T>& b) {
  return {select(c, a(0), b(0)), select(c, a(1), b(1)), select(c, a(2), b(2))};
}
}  // namespace detail

/// Resistance against the hourglass modes themselves, dQ/dt = k qdot with k = kappa 2 G B:B/(8 V) (Flanagan and
/// Belytschko 1981). A fluid, which has no shear modulus, gets ViscousHourglass.
struct StiffnessHourglass {
  double coefficient = 0.005;  ///< kappa, usually 0.001 to 0.01

  void ranges(const auto& number) const { number("coefficient", coefficient, range::between(0, 100)); }

  template <class T>
  struct State {
    HourglassModes<T> resistance{Vector3<T>::Zero(), Vector3<T>::Zero(), Vector3<T>::Zero(), Vector3<T>::Zero()};

    auto spatial_tensors() { return std::tie(resistance[0], resistance[1], resistance[2], resistance[3]); }
  };

  template <class T>
  T stiffness(const HourglassElement<T>& e) const {
    return (0.25 * coefficient) * e.shear_modulus * e.gradient_squared * e.volume;
  }
  template <class T>
  HourglassModes<T> resistance(State<T>& state, const HourglassElement<T>& e, const HourglassModes<T>& rates) const {
    const T k = stiffness(e) * e.dt;
    for (std::size_t i = 0; i < 4; ++i) state.resistance[i] = state.resistance[i] + k * rates[i];
    HourglassModes<T> Q = state.resistance;
    if (const auto fluid = !(e.shear_modulus > 0.0); any(fluid)) {
      const T a = ViscousHourglass{}.damping(e);
      for (std::size_t i = 0; i < 4; ++i) Q[i] = detail::selected(fluid, Vector3<T>(a * rates[i]), Q[i]);
    }
    return Q;
  }
  /// Work done against the mean of the resistances before and after the step.
  template <class T>
  T work(const HourglassElement<T>& e, const HourglassModes<T>& Q, const HourglassModes<T>& rates) const {
    const T half = 0.5 * stiffness(e) * e.dt;
    T sum = T(0.0);
    for (std::size_t i = 0; i < 4; ++i) sum += dot<T>(Q[i] - half * rates[i], rates[i]);
    return e.dt * sum;
  }
  /// One over the largest step that this alone allows, half the frequency sqrt(k |Lambda|^2/m).
  template <class T>
  T critical_rate(const HourglassElement<T>& e) const {
    return select(e.shear_modulus > 0.0, sqrt(16.0 * stiffness(e) * e.per_mass), ViscousHourglass{}.critical_rate(e));
  }
};

}  // namespace strike
