#pragma once
#include <strike/scalar/scalar.hpp>

namespace strike {

/// Swift (1952): sigma = K (e0 + e)^n, that begins to flow at Y = K e0^n. Hollomon's law of the total strain is the
/// same with e0 = (K/E)^(1/(1 - n)), the strain at which it leaves the elastic line; Ludwik's A + B e^n is JohnsonCook.
struct PowerHardening {
  double shear_modulus;
  double coefficient;     ///< K
  double exponent;        ///< n, from 0 to 1
  double initial_strain;  ///< e0 > 0: (Y/K)^(1/n)

  template <class T>
  T flow_stress(const T& e) const {
    return coefficient * pow(T(initial_strain + e), exponent);
  }
};

}  // namespace strike
