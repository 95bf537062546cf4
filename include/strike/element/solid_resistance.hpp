#pragma once
#include <strike/material/material.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike {

/// The stress with which an element resists a small motion p in a step dt, sigma = lambda tr(grad p) I + 2 shear
/// sym(grad p): that of its moduli times dt^2/4 and of its viscosities times dt/2.
template <class T>
struct SolidResistance {
  T lambda{}, shear{};

  /// With a bulk viscosity of the coefficient zeta [stress time].
  template <class M>
  static SolidResistance in_step(const M& material, const Moduli<T>& moduli, const T& zeta, double dt) {
    const double k = 0.25 * dt * dt, c = 0.5 * dt;
    SolidResistance resistance{k * (moduli.bulk - T(2.0 / 3.0) * moduli.shear) + c * zeta, k * moduli.shear};
    if constexpr (requires { material.viscosity(); }) resistance.shear += c * material.viscosity();
    return resistance;
  }
  SolidResistance& operator*=(const T& share) {
    lambda *= share, shear *= share;
    return *this;
  }
  SymmetricTensor<T> stress(const Matrix3<T>& L) const {
    return SymmetricTensor<T>::isotropic(lambda * L.trace()) + T(2.0 * shear) * symmetric_part(L);
  }
};

}  // namespace strike
