#pragma once
#include <strike/material/material.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike {

/// What an element's highest frequency and every damping in it follow from: its gradient operator B in the form of
/// S = B B^T / V^2 [1/length^2] and the largest eigenvalue of S.
///
/// For nodal masses of rho V/8 and isotropic moduli the frequency is bounded by
///   w^2 <= 8 (max(lambda, 0) tr S + 2 G L1(S)) / rho,   lambda = K - 2 G/3:
/// lambda (b.v)^2 has the one eigenvalue lambda |b|^2, and the deviatoric part 2 G D:D <= 2 G L:L has at most 2 G L1.
template <class T>
struct Slenderness {
  T trace;       ///< tr S
  T eigenvalue;  ///< L1(S)

  explicit Slenderness(const SymmetricTensor<T>& S) : trace(strike::trace(S)), eigenvalue(largest_eigenvalue(S)) {}

  /// The length over which a plane wave crosses the element, the edge of a brick: 1/sqrt(2 L1). Bulk viscosity and time
  /// step must use the same one, or crushed elements are damped beyond stability.
  T length() const { return 1.0 / sqrt(2.0 * eigenvalue); }

  /// The bound above on the square of the highest frequency.
  T frequency_squared(const Moduli<T>& moduli, const T& rho) const {
    const T lambda = max(T(0.0), moduli.bulk - T(2.0 / 3.0) * moduli.shear);
    return 8.0 * (lambda * trace + 2.0 * moduli.shear * eigenvalue) / rho;
  }

  /// Rate of decay c/m of the fastest mode under a Newtonian viscosity: the same bound with 2 eta for 2 G.
  T decay(const T& viscosity, const T& rho) const { return 16.0 * viscosity * eigenvalue / rho; }
};

/// The largest stable step of central differences whose damping lags half a step: w^2 dt^2/4 + decay dt/2 = 1.
template <class T>
T critical_step(const T& frequency_squared, const T& decay) {
  return 4.0 / (decay + sqrt(decay * decay + 4.0 * frequency_squared));
}

}  // namespace strike
