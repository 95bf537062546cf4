#pragma once
#include <tuple>

#include <strike/range.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike {

/// Von Mises plasticity with linear hardening, a share b of which grows the yield surface and the rest of which moves
/// its centre, the back stress a (Prager 1956; Krieg and Key 1976):
///   sqrt(3/2 |s - a|^2) = Y + b H e,    da = (1 - b) H dl (s - a)/(Y + b H e)
/// b = 0 is kinematic hardening, whose loops are 2 Y wide; b = 1 is VonMises. The return is in closed form.
struct KinematicHardening {
  double shear_modulus;        ///< G [stress]
  double yield_stress;         ///< Y [stress]
  double hardening_modulus;    ///< H >= 0 [stress]
  double isotropic_share = 0;  ///< b, from 0 to 1

  void ranges(const auto& number) const {
    number("shear_modulus", shear_modulus, range::positive);
    number("yield_stress", yield_stress, range::not_negative);
    number("hardening_modulus", hardening_modulus, range::not_negative);
    number("isotropic_share", isotropic_share, range::share);
  }

  template <class T>
  struct State {
    T equivalent_plastic_strain{};
    SymmetricTensor<T> back_stress{};

    auto spatial_tensors() { return std::tie(back_stress); }
  };

  template <class T>
  T yield_radius(const State<T>& state) const {
    return yield_stress + (isotropic_share * hardening_modulus) * state.equivalent_plastic_strain;
  }

  template <class T>
  SymmetricTensor<T> deviatoric_stress(State<T>& state, const SymmetricTensor<T>& s, const SymmetricTensor<T>& d,
                                       const T&, double) const {
    auto& [e, a] = state;
    const double G3 = 3 * shear_modulus, H = hardening_modulus, b = isotropic_share;
    const SymmetricTensor<T> trial = s + T(2 * shear_modulus) * d, from_centre = trial - a;
    const T q2 = max(T(detail::least_square<T>), 1.5 * double_dot(from_centre, from_centre)), per_q = rsqrt(q2);
    const T dl = (1 / (G3 + H)) * max(T(0.0), q2 * per_q - (yield_stress + (b * H) * e));
    e += dl;
    a += ((1 - b) * H * dl * per_q) * from_centre;
    return trial - (G3 * dl * per_q) * from_centre;
  }
};

}  // namespace strike
