#pragma once
#include <strike/cxx20.hpp>

namespace strike {

/// Linear elasticity of the volume, p = K mu.
struct LinearEos {
  double density;       ///< reference density
  double bulk_modulus;  ///< K [stress]

  template <class T>
  T A(const T& mu) const {
    return bulk_modulus * mu;
  }
};

}  // namespace strike
