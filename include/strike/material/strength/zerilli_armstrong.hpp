#pragma once
#include <limits>

#include <strike/range.hpp>
#include <strike/scalar/scalar.hpp>

namespace strike {

/// Flow law of Zerilli and Armstrong (1987), of dislocations that cross barriers by thermal activation, with both of
/// their lattices in one formula:
///   sigma = C0 + [C1 + C2 sqrt(e)] exp(-C3 T + C4 T ln(r/r0)) + C5 e^n
/// bcc (iron) has C2 = 0 (eq. 20), fcc (copper) C1 = C5 = 0 (eq. 19). T is absolute and rises with the plastic work.
/// The thermal part vanishes with the rate.
struct ZerilliArmstrong {
  double shear_modulus;              ///< [stress]
  double C0;                         ///< of solutes and grains, sigma_G + k/sqrt(l) [stress]
  double C1 = 0, C2 = 0;             ///< [stress]
  double C3, C4;                     ///< [1/temperature]
  double C5 = 0, n = 1;              ///< [stress], [1]
  double reference_rate = 1;         ///< r0 [1/time]
  double initial_temperature = 293;  ///< [temperature]
  double heating = 0;  ///< rise of temperature per plastic work, 0.9/(rho0 c_p) [temperature volume/energy]

  void ranges(const auto& number) const {
    number("shear_modulus", shear_modulus, range::positive);
    number("C0", C0, range::not_negative);
    number("C1", C1, range::not_negative);
    number("C2", C2, range::not_negative);
    number("C3", C3, range::not_negative);
    number("C4", C4, range::not_negative);
    number("C5", C5, range::not_negative);
    number("n", n, Range{.low = 0, .high = 10});
    number("reference_rate", reference_rate, range::positive);
    number("initial_temperature", initial_temperature, range::positive);
    number("heating", heating, range::not_negative);
  }

  template <class T>
  T flow_stress(const T& e, const T& rate, const T& temperature) const {
    const T activity = log(max(rate * (1.0 / reference_rate), T(std::numeric_limits<RealOf<T>>::min())));
    const T thermal = exp(T(temperature * (C4 * activity - C3)));
    return C0 + (C1 + C2 * sqrt(e)) * thermal + C5 * pow(e, n);
  }
};

}  // namespace strike
