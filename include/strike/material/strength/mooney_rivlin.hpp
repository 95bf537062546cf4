#pragma once
#include <tuple>

#include <strike/range.hpp>
#include <strike/tensor/rotation.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike {

/// Rubber (Mooney 1940; Rivlin 1948), W = C10 (I1 - 3) + C01 (I2 - 3) of the isochoric part of the motion:
///   s = 2/J dev(C10 B - C01 B^-1)
/// B, the isochoric left Cauchy-Green tensor F F^T, is remembered as a spatial tensor: the element turns it, and a step
/// stretches it by Cayley's form of exp(d), B <- f B f with f = (I - d/2)^-1 (I + d/2), as mid-step kinematics advances
/// F. C01 = 0 is neo-Hookean. The pressure is that of the equation of state.
struct MooneyRivlin {
  double C10, C01 = 0;                     ///< >= 0 [stress]
  double shear_modulus = 2 * (C10 + C01);  ///< at rest [stress]

  void ranges(const auto& number) const {
    number("C10", C10, range::not_negative);
    number("C01", C01, range::not_negative);
    number("shear_modulus", shear_modulus, range::positive);
  }

  template <class T>
  struct State {
    SymmetricTensor<T> stretch = SymmetricTensor<T>::isotropic(T(1.0));  ///< B

    auto spatial_tensors() { return std::tie(stretch); }
  };

  template <class T>
  SymmetricTensor<T> deviatoric_stress(State<T>& state, const SymmetricTensor<T>&, const SymmetricTensor<T>& d,
                                       const T& J, double) const {
    const auto I = SymmetricTensor<T>::isotropic(T(1.0));
    const SymmetricTensor<T> f = T(2.0) * inverse(I - T(0.5) * d) - I;
    const SymmetricTensor<T> B = rotated<T>(f.matrix(), state.stretch);
    state.stretch = (1.0 / cbrt(determinant(B))) * B;  // det f = 1 to the third order of d
    return (2.0 / J) * deviator(T(C10) * state.stretch - T(C01) * inverse(state.stretch));
  }

  /// Bound of the tangent's shear modulus, (2/J) [C10 (2/3 n.B n + 2/9 tr B) + C01 (2/3 n.B^-1 n + 2/9 tr B^-1)] along
  /// n.
  template <class T>
  T stiffness(const State<T>& state, const T& J) const {
    const SymmetricTensor<T>& B = state.stretch;
    return (2.0 / J) * (C10 * largest_eigenvalue(B) + C01 * largest_eigenvalue(inverse(B)));
  }
};

}  // namespace strike
