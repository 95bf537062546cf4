#pragma once
#include <strike/material/material.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike {

/// What the frequencies and the damping of an element follow from: S = B B^T / V^2 [1/length^2] of its gradient
/// operator B, its moduli and its density.
///
/// For nodal masses of rho V/8 the highest frequency is bounded by
///   w^2 <= 8 (max(lambda, 0) tr S + 2 G L1(S)) / rho,   lambda = K - 2 G/3,   L1 the largest eigenvalue:
/// lambda (b.v)^2 has the one eigenvalue lambda |b|^2, and the deviatoric part 2 G D:D <= 2 G L:L has at most 2 G L1.
template <class T>
struct Stability {
  T trace;            ///< tr S
  T eigenvalue;       ///< L1(S)
  T volume_per_mass;  ///< 1/rho

  Stability(const SymmetricTensor<T>& S, const T& specific_volume)
      : trace(strike::trace(S)), eigenvalue(largest_eigenvalue(S)), volume_per_mass(specific_volume) {}

  /// The time l/c in which a plane wave crosses the element, l = 1/sqrt(2 L1), the edge of a brick. Bulk viscosity and
  /// time step must use the same length, or crushed elements are damped beyond stability.
  T crossing_time(const T& wave_modulus) const { return 1.0 / sqrt(2.0 * eigenvalue * wave_modulus * volume_per_mass); }

  /// The bound above on the highest frequency.
  T frequency(const Moduli<T>& moduli) const {
    const T lambda = max(T(0.0), moduli.bulk - T(2.0 / 3.0) * moduli.shear);
    return sqrt(8.0 * volume_per_mass * (lambda * trace + 2.0 * moduli.shear * eigenvalue));
  }

  /// Rate of decay c/m of the fastest mode under a Newtonian viscosity: the same bound with 2 eta for 2 G.
  T decay(double viscosity) const { return (16.0 * viscosity) * eigenvalue * volume_per_mass; }
};

/// One over the largest stable step of central differences whose damping lags half a step: the dt of
/// w^2 dt^2/4 + xi w dt = 1 for a mode of frequency w and the fraction xi of its critical damping.
template <class T>
T critical_rate(const T& frequency, const T& damping) {
  return 0.5 * frequency * (damping + sqrt(1.0 + damping * damping));
}

}  // namespace strike
