#pragma once
#include <limits>

#include <strike/range.hpp>
#include <strike/scalar/scalar.hpp>

namespace strike {

/// Polynomial, p = C0 + C1 mu + C2 mu^2 + C3 mu^3 + (C4 + C5 mu + C6 mu^2) E; the terms of C2 and C6 act in compression
/// only (LS-DYNA *EOS_LINEAR_POLYNOMIAL; RADIOSS /EOS/POLYNOMIAL), and the pressure is cut off from below.
struct PolynomialEos {
  double density;                                                  ///< reference density
  double C0 = 0, C1 = 0, C2 = 0, C3 = 0, C4 = 0, C5 = 0, C6 = 0;   ///< [stress], C4 to C6 [1]
  double initial_energy = 0;                                       ///< E at rest [energy/volume]
  double pressure_cutoff = std::numeric_limits<double>::lowest();  ///< least pressure, at most 0 [stress]

  void ranges(const auto& number) const {
    number("density", density, range::positive);
    number("C0", C0, range::finite);
    number("C1", C1, C4 > 0 ? range::not_negative : range::positive);
    number("C2", C2, range::finite);
    number("C3", C3, range::finite);
    number("C4", C4, range::between(0, 100));
    number("C5", C5, range::between(-100, 100));
    number("C6", C6, range::between(-100, 100));
    number("initial_energy", initial_energy, range::finite);
    number("pressure_cutoff", pressure_cutoff, range::or_infinite(range::at_most(0)));
  }

  template <class T>
  T A(const T& mu) const {
    const T compression = max(mu, T(0.0));
    return C0 + mu * (C1 + C3 * mu * mu) + C2 * compression * compression;
  }
  template <class T>
  T B(const T& mu) const {
    const T compression = max(mu, T(0.0));
    return C4 + C5 * mu + C6 * compression * compression;
  }
};

}  // namespace strike
