#pragma once
#include <strike/range.hpp>
#include <strike/scalar/scalar.hpp>

namespace strike {

/// Flow law of Swift (1952), sigma = K (e0 + e)^n with the yield stress Y = K e0^n. e0 = (K/E)^(1/(1 - n)), the strain
/// at which Hollomon's law of the total strain leaves the elastic line, makes it Hollomon's; Ludwik's A + B e^n is
/// JohnsonCook.
struct PowerHardening {
  double shear_modulus;   ///< [stress]
  double coefficient;     ///< K [stress]
  double exponent;        ///< n, from 0 to 1
  double initial_strain;  ///< e0 > 0: (Y/K)^(1/n)

  void ranges(const auto& number) const {
    number("shear_modulus", shear_modulus, range::positive);
    number("coefficient", coefficient, range::not_negative);
    number("exponent", exponent, range::share);
    number("initial_strain", initial_strain, range::positive);
  }

  template <class T>
  T flow_stress(const T& e) const {
    return coefficient * pow(T(initial_strain + e), exponent);
  }
};

}  // namespace strike
