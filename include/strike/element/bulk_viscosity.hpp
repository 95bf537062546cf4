#pragma once
#include <strike/scalar/scalar.hpp>

namespace strike {

/// Shock viscosity of von Neumann and Richtmyer (1950) with Landshoff's linear term (1955), in compression only:
///   q = rho l |tr D| (C0^2 l |tr D| + C1 c).
struct BulkViscosity {
  double quadratic = 1.5;  ///< C0
  double linear = 0.06;    ///< C1

  /// q, positive in compression; l the length that the time step uses, c the speed of sound, theta = tr D.
  template <class T>
  T pressure(const T& rho, const T& l, const T& c, const T& theta) const {
    const T compression = max(T(0.0), -theta);
    return rho * l * compression * (quadratic * quadratic * l * compression + linear * c);
  }
  /// Fraction of critical damping in the highest mode.
  template <class T>
  T damping(const T& l, const T& c, const T& theta) const {
    return linear + quadratic * quadratic * l * max(T(0.0), -theta) / c;
  }
};

struct NoBulkViscosity {};

}  // namespace strike
