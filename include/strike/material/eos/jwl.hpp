#pragma once
#include <strike/range.hpp>
#include <strike/scalar/scalar.hpp>

namespace strike {

/// Products of an explosive by Jones, Wilkins and Lee (Lee, Hornig and Kury 1968), with V = 1/(1 + mu)
///   p = A (1 - w/(R1 V)) exp(-R1 V) + B (1 - w/(R2 V)) exp(-R2 V) + w E/V
/// whose isentropes are A exp(-R1 V) + B exp(-R2 V) + C V^(-1 - w).
struct Jwl {
  double density;                 ///< of the explosive
  double A_products, B_products;  ///< A and B [stress]
  double R1, R2, omega;           ///< R1, R2 and w [1]
  double initial_energy;          ///< E0, of detonation [energy/volume]

  void ranges(const auto& number) const {
    number("density", density, range::positive);
    number("A_products", A_products, range::positive);
    number("B_products", B_products, range::finite);
    number("R1", R1, Range{.low = 0, .high = 100});
    number("R2", R2, Range{.low = 0, .high = 100});
    number("omega", omega, range::between(0, 10));
    number("initial_energy", initial_energy, range::not_negative);
  }

  template <class T>
  T A(const T& mu) const {
    const T V = 1.0 / (1.0 + mu);
    const auto term = [&](double a, double R) -> T { return a * (1.0 - (omega / R) * (1.0 + mu)) * exp(T(-R * V)); };
    return term(A_products, R1) + term(B_products, R2);
  }
  template <class T>
  T B(const T& mu) const {
    return omega * (1.0 + mu);
  }
};

}  // namespace strike
