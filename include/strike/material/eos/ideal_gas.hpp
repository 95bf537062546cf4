#pragma once
#include <strike/cxx20.hpp>

namespace strike {

/// Ideal gas, p = (gamma - 1) (1 + mu) E.
struct IdealGas {
  double density;             ///< reference density
  double gamma;               ///< ratio of the specific heats
  double initial_energy = 0;  ///< E at rest, p0/(gamma - 1) [energy/volume]

  template <class T>
  T A(const T& mu) const {
    return 0.0 * mu;
  }
  template <class T>
  T B(const T& mu) const {
    return (gamma - 1.0) * (1.0 + mu);
  }
};

}  // namespace strike
