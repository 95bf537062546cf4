#pragma once
#include <limits>

#include <strike/material/failure/failure.hpp>
#include <strike/range.hpp>
#include <strike/scalar/scalar.hpp>

namespace strike {

/// Failure by Johnson and Cook (1985), when the damage, the sum of dl/e_f over the steps, reaches 1, with the strain at
/// fracture
///   e_f = [D1 + D2 exp(D3 s*)] [1 + D4 ln(max(r/r0, 1))] (1 + D5 T*)
/// of the triaxiality s* = mean stress/equivalent stress (tension positive, at most the 1.5 of their tests), the rate
/// of plastic strain r and T* = (T - T0)/(Tm - T0); T is that of a thermal flow law, and T0 of any other.
struct JohnsonCookFailure {
  double D1, D2 = 0, D3 = 0;          ///< D3 < 0: less strain at fracture under tension
  double D4 = 0, reference_rate = 1;  ///< r0 [1/time]
  double D5 = 0, initial_temperature = 293, melting_temperature = 1e30;
  double least_strain = 1e-6;  ///< lower bound of e_f

  void ranges(const auto& number) const {
    number("D1", D1, Range{.low = -D2, .high = 1000}, "without triaxiality the strain at fracture is D1 + D2");
    number("D2", D2, range::between(-1000, 1000));
    number("D3", D3, range::between(-20, 20));
    number("D4", D4, range::between(-1, 1));
    number("reference_rate", reference_rate, range::positive);
    number("D5", D5, range::between(-1, 1000));
    number("initial_temperature", initial_temperature, range::finite);
    number("melting_temperature", melting_temperature, range::above(initial_temperature));
    number("least_strain", least_strain, range::positive);
  }

  template <class T>
  struct State : detail::Intact<T>, detail::Damage<T> {};

  template <class T>
  T strain_at_fracture(const T& triaxiality, const T& rate, const T& temperature_rise) const {
    const T s = max(T(-30.0), min(T(1.5), triaxiality));  // under high pressure neither failure nor overflow
    const T by_stress = D1 + D2 * exp(T(D3 * s));
    const T by_rate = 1.0 + D4 * log(max(rate * (1.0 / reference_rate), T(1.0)));
    const T by_heat = 1.0 + (D5 / (melting_temperature - initial_temperature)) * temperature_rise;
    return max(T(least_strain), by_stress * by_rate * by_heat);
  }

  template <class T, class S>
  void accumulate(S& state, const T& equivalent_stress, const T& plastic_increment, double dt) const {
    const T q = max(equivalent_stress, T(std::numeric_limits<RealOf<T>>::min()));
    const T triaxiality = (1.0 / 3.0) * trace(state.stress) / q;
    const T rate = (dt > 0 ? 1 / dt : 0) * plastic_increment;
    T temperature_rise = T(0.0);
    if constexpr (requires { state.temperature_rise; }) temperature_rise = state.temperature_rise;
    state.damage += plastic_increment / strain_at_fracture<T>(triaxiality, rate, temperature_rise);
  }
  template <class T, class S>
  auto fails(const T&, const S& state) const {
    return state.damage >= 1.0;
  }
};

}  // namespace strike
