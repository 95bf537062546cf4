#pragma once
#include <strike/material/material.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike {

/// Bounds of the frequencies w and of the rates of decay d of the modes of an element.
template <class T>
struct Vibration {
  T frequency_squared;  ///< w^2 [1/time^2]
  T decay;              ///< d [1/time]

  /// One over the largest stable step of central differences whose damping lags half a step: a mode phi of stiffness
  /// k = phi.K phi/m and damping c = phi.C phi/m needs k dt^2/4 + c dt/2 <= 1.
  T critical_rate() const { return 0.25 * decay + 0.5 * sqrt(frequency_squared + 0.25 * decay * decay); }
};

/// The source of an element's frequencies and damping: S = B B^T / V^2 [1/length^2] of its gradient operator B, and its
/// density.
///
/// For nodal masses of rho V/8 the highest frequency is bounded by
///   w^2 <= 8 (max(lambda, 0) tr S + 2 G L1(S)) / rho,   lambda = K - 2 G/3,   L1 the largest eigenvalue:
/// lambda (b.v)^2 has the one eigenvalue lambda |b|^2, and the deviatoric part 2 G D:D <= 2 G L:L has at most 2 G L1.
/// With viscosities in place of the moduli the same bounds the decay.
template <class T>
struct Stability {
  T trace;            ///< tr S
  T eigenvalue;       ///< L1(S)
  T volume_per_mass;  ///< 1/rho

  /// The time l/c in which a plane wave crosses the element, l = 1/sqrt(2 L1), the edge of a brick. Bulk viscosity and
  /// time step must use the same length, or crushed elements are damped beyond stability.
  T crossing_time(const T& wave_modulus) const { return rsqrt(2.0 * eigenvalue * wave_modulus * volume_per_mass); }

  /// Vibration with these moduli and a bulk viscosity of the coefficient zeta [stress time].
  template <class M>
  Vibration<T> vibration(const M& material, const Moduli<T>& moduli, const T& zeta) const {
    const T lambda = max(T(0.0), moduli.bulk - T(2.0 / 3.0) * moduli.shear), w = 8.0 * volume_per_mass;
    Vibration<T> vibration{w * (lambda * trace + 2.0 * moduli.shear * eigenvalue), w * (zeta * trace)};
    if constexpr (requires { material.viscosity(); })
      vibration.decay += w * ((2.0 * material.viscosity()) * eigenvalue);
    return vibration;
  }
};

/// One over the largest stable step of an element with hourglass control, from the vibration by its mean gradient b,
/// the critical rate h of the control alone and the overlap e = |P gamma|^2/8 of the hourglass vectors with b.
///
/// P projects onto b. As gamma = P gamma + (1 - P) Lambda, control adds h e to the rate r within b, h beside it, and
/// h sqrt(e) couples the two: a rate R is enough if (R - r)(R + r') - h e R and R (R - h) are positive with a product
/// of at least (h R)^2 e, where r and -r' are the roots of R^2 - d R/2 - w^2/4. With R + r' >= f R, f = 1 + r'/(r + h +
/// h e) because no R needs to be larger, that is the larger eigenvalue of [r + h e/f, h sqrt(e/f); h sqrt(e/f), h].
template <class T>
T critical_rate(const Vibration<T>& strain, const T& h, const T& e) {
  const T r = strain.critical_rate(), conjugate = r - 0.5 * strain.decay;
  const T bound = r + h + h * e;
  const T shared = h * e * bound / (bound + conjugate);
  const T mean = 0.5 * (r + shared + h), half = 0.5 * (r + shared - h);
  return mean + sqrt(half * half + h * shared);
}

}  // namespace strike
