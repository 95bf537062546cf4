#pragma once
#include <strike/scalar/scalar.hpp>

namespace strike {

/// Shock viscosity of von Neumann and Richtmyer (1950) with Landshoff's linear term (1955), in compression only:
///   q = rho l |tr D| (C0^2 l |tr D| + C1 c) = rho c^2 s (C0^2 s + C1),   s = |tr D| l/c,
/// with the compression s in the time l/c in which a wave crosses the element.
struct BulkViscosity {
  double quadratic = 1.5;  ///< C0
  double linear = 0.06;    ///< C1

  template <class T>
  struct State {
    T pressure{};  ///< q of the last step: the balance of energy needs the mean over a step
  };

  /// q, positive in compression.
  template <class T>
  T pressure(const T& wave_modulus, const T& s) const {
    return wave_modulus * s * (quadratic * quadratic * s + linear);
  }
  /// dq/d|tr D| [stress time], the coefficient of viscosity that the stable step must know.
  template <class T>
  T coefficient(const T& wave_modulus, const T& crossing_time, const T& s) const {
    return wave_modulus * crossing_time * (2.0 * quadratic * quadratic * s + linear);
  }
};

struct NoBulkViscosity {
  template <class T>
  struct State {};
};

}  // namespace strike
