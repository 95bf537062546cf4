#pragma once
#include <strike/range.hpp>
#include <strike/scalar/scalar.hpp>

namespace strike {

/// Flow law of Johnson and Cook (1983): sigma = (A + B e^n) (1 + C ln(max(r/r0, 1))) (1 - T*^m), T* = (T - T0)/(Tm -
/// T0) in [0, 1], T rises with the plastic work.
struct JohnsonCook {
  double shear_modulus;                                                 ///< [stress]
  double A, B, n;                                                       ///< [stress], [stress], [1]
  double C = 0, reference_rate = 1;                                     ///< r0 [1/time]
  double m = 1, initial_temperature = 293, melting_temperature = 1e30;  ///< [1], T0 and Tm [temperature]
  double heating = 0;  ///< rise of temperature per plastic work, 0.9/(rho0 c_p) [temperature volume/energy]

  void ranges(const auto& number) const {
    number("shear_modulus", shear_modulus, range::positive);
    number("A", A, range::not_negative);
    number("B", B, range::not_negative);
    number("n", n, Range{.low = 0, .high = 10});
    number("C", C, range::between(0, 10));
    number("reference_rate", reference_rate, range::positive);
    number("m", m, Range{.low = 0, .high = 100});
    number("initial_temperature", initial_temperature, range::finite);
    number("melting_temperature", melting_temperature, range::above(initial_temperature));
    number("heating", heating, range::not_negative);
  }

  template <class T>
  T flow_stress(const T& e, const T& rate, const T& temperature) const {
    const T homologous = (temperature - initial_temperature) * (1.0 / (melting_temperature - initial_temperature));
    const T softening = select(homologous > 0.0, pow(min(T(1.0), homologous), m), T(0.0));
    return (A + B * pow(e, n)) * (1.0 + C * log(max(rate * (1.0 / reference_rate), T(1.0)))) * (1.0 - softening);
  }
};

}  // namespace strike
