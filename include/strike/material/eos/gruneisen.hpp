#pragma once
#include <limits>

#include <strike/range.hpp>
#include <strike/scalar/scalar.hpp>

namespace strike {

/// Mie-Gruneisen with a cubic shock velocity, in the form of LS-DYNA *EOS_GRUNEISEN (Steinberg 1996):
///   p = rho0 c^2 mu [1 + (1 - g/2) mu - a/2 mu^2] / [1 - (S1 - 1) mu - S2 mu^2/(mu + 1) - S3 mu^3/(mu + 1)^2]^2 + (g +
///   a mu) E
/// in compression and p = rho0 c^2 mu + (g + a mu) E in tension; the pressure is cut off from below.
struct GruneisenEos {
  double density;      ///< rho0, of the reference configuration
  double sound_speed;  ///< c, the intercept of the shock velocity U = c + S1 u [length/time]
  double S1, S2 = 0, S3 = 0;
  double gamma;                                                    ///< g, the Gruneisen coefficient
  double a = 0;                                                    ///< first-order volume correction of gamma
  double initial_energy = 0;                                       ///< E at rest [energy/volume]
  double pressure_cutoff = std::numeric_limits<double>::lowest();  ///< least pressure, at most 0 [stress]

  void ranges(const auto& number) const {
    number("density", density, range::positive);
    number("sound_speed", sound_speed, range::positive);
    number("S1", S1, range::between(0, 100));
    number("S2", S2, range::between(-100, 100));
    number("S3", S3, range::between(-100, 100));
    number("gamma", gamma, range::between(0, 100));
    number("a", a, range::between(-100, 100));
    number("initial_energy", initial_energy, range::finite);
    number("pressure_cutoff", pressure_cutoff, range::or_infinite(range::at_most(0)));
  }

  template <class T>
  T A(const T& mu) const {
    const double K = density * sound_speed * sound_speed;
    const T m = max(mu, T(0.0));
    const T part = m / (m + 1.0);
    const T slope = 1.0 - m * ((S1 - 1.0) + part * (S2 + part * S3));
    const T hugoniot = K * m * (1.0 + m * ((1.0 - 0.5 * gamma) - 0.5 * a * m)) / (slope * slope);
    return select(mu < 0.0, K * mu, hugoniot);
  }
  template <class T>
  T B(const T& mu) const {
    return gamma + a * mu;
  }
};

}  // namespace strike
