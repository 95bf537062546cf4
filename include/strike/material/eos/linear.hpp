#pragma once
#include <strike/range.hpp>

namespace strike {

/// Linear elasticity of the volume, p = K mu.
struct LinearEos {
  double density;       ///< reference density
  double bulk_modulus;  ///< K [stress]

  void ranges(const auto& number) const {
    number("density", density, range::positive);
    number("bulk_modulus", bulk_modulus, range::positive);
  }

  template <class T>
  T A(const T& mu) const {
    return bulk_modulus * mu;
  }
};

}  // namespace strike
