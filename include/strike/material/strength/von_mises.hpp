#pragma once
#include <string>

#include <strike/range.hpp>
#include <strike/scalar/scalar.hpp>

namespace strike {

/// Von Mises plasticity with linear isotropic hardening: sigma = Y + H e, never below zero.
struct VonMises {
  double shear_modulus;          ///< G [stress]
  double yield_stress;           ///< Y [stress]
  double hardening_modulus = 0;  ///< H = d sigma / d (plastic strain), > -3 G; negative is softening [stress]

  void ranges(const auto& number) const {
    number("shear_modulus", shear_modulus, range::positive);
    number("yield_stress", yield_stress, range::not_negative);
    number("hardening_modulus", hardening_modulus, range::above(-3 * shear_modulus));
  }
  std::string warning() const {
    if (hardening_modulus >= 0) return {};
    return "The hardening modulus is negative: strain that softens gathers in one row of elements, and the result "
           "depends on the mesh.";
  }

  template <class T>
  T flow_stress(const T& e) const {
    return max(T(0.0), yield_stress + hardening_modulus * e);
  }
  /// q - 3 G dl = Y + H (e + dl), solved for dl.
  template <class T>
  T plastic_increment(const T& q, const T& e, double) const {
    const double G3 = 3.0 * shear_modulus;
    const T dl = max(T(0.0), q - (yield_stress + hardening_modulus * e)) * (1.0 / (G3 + hardening_modulus));
    return min(dl, (1.0 / G3) * q);
  }
};

}  // namespace strike
