#pragma once
#include <limits>

#include <strike/range.hpp>
#include <strike/scalar/scalar.hpp>

namespace strike {

/// Cubic polynomial without energy, p = C1 mu + C2 mu^2 + C3 mu^3: liquids, and the bird of Brockman and Held (1991).
/// The quadratic term acts in compression only, and the pressure is cut off from below. A shock velocity U = c + k u
/// gives C1 = rho c^2, C2 = (2k - 1) C1, C3 = (k - 1)(3k - 1) C1.
struct CubicEos {
  double density;                                                  ///< reference density
  double C1, C2 = 0, C3 = 0;                                       ///< [stress]
  double pressure_cutoff = std::numeric_limits<double>::lowest();  ///< least pressure, at most 0 [stress]

  void ranges(const auto& number) const {
    number("density", density, range::positive);
    number("C1", C1, range::positive);
    number("C2", C2, range::finite);
    number("C3", C3, range::finite);
    number("pressure_cutoff", pressure_cutoff, range::or_infinite(range::at_most(0)));
  }

  template <class T>
  T A(const T& mu) const {
    const T compression = max(mu, T(0.0));
    return mu * (C1 + C3 * mu * mu) + C2 * compression * compression;
  }
};

}  // namespace strike
