#pragma once

namespace strike {

/// p = K mu.
struct LinearEos {
  double density;       ///< reference density
  double bulk_modulus;  ///< K

  template <class T>
  T A(const T& mu) const {
    return bulk_modulus * mu;
  }
};

}  // namespace strike
