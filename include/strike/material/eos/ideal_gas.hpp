#pragma once
#include <strike/range.hpp>

namespace strike {

/// Ideal gas, p = (gamma - 1) (1 + mu) E.
struct IdealGas {
  double density;         ///< reference density
  double gamma;           ///< ratio of the specific heats
  double initial_energy;  ///< E at rest, p0/(gamma - 1) [energy/volume]

  void ranges(const auto& number) const {
    number("density", density, range::positive);
    number("gamma", gamma, Range{.low = 1, .high = 100});
    number("initial_energy", initial_energy, range::positive);
  }

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
