#pragma once
#include <algorithm>
#include <limits>

#include <strike/range.hpp>
#include <strike/scalar/scalar.hpp>

namespace strike {

/// Von Mises plasticity of X3D (Brockman and Held 1991), linear hardening scaled by a power law of the rate:
///   sigma = (Y + H e) (1 + C r^n)
/// Cowper and Symonds' D and p are C = D^(-1/p), n = 1/p.
struct RateVonMises {
  double shear_modulus;          ///< G [stress]
  double yield_stress;           ///< Y, quasi-static [stress]
  double hardening_modulus = 0;  ///< H >= 0 [stress]
  double rate_factor = 0;        ///< C [time^n]
  double rate_exponent = 1;      ///< n > 0

  void ranges(const auto& number) const {
    number("shear_modulus", shear_modulus, range::positive);
    number("yield_stress", yield_stress, range::not_negative);
    number("hardening_modulus", hardening_modulus, range::not_negative);
    number("rate_factor", rate_factor, range::not_negative);
    number("rate_exponent", rate_exponent, Range{.low = 0, .high = 10});
  }

  template <class T>
  T flow_stress(const T& e, const T& rate) const {
    return (yield_stress + hardening_modulus * e) * (1.0 + rate_factor * pow(rate, rate_exponent));
  }

  /// The rate-independent increment dl0 bounds the root, so that dl = dl0 z^a with z in [0, 1]. With a = max(1/n, 1)
  /// and b = max(n, 1)
  ///   f(z) = q - 3 G dl0 z^a - (Y + H (e + dl0 z^a)) (1 + C (dl0/dt)^n z^b)
  /// is smooth, falling and concave, f(1) <= 0: Newton's steps from z = 1 go down to the root and never past it, at any
  /// rate.
  template <class T>
  T plastic_increment(const T& q, const T& e, double dt) const {
    using Limits = std::numeric_limits<RealOf<T>>;
    const double G3 = 3.0 * shear_modulus;
    const T quasi_static = yield_stress + hardening_modulus * e;
    const T dl0 = max(T(0.0), q - quasi_static) * (1.0 / (G3 + hardening_modulus));
    const auto yields = dl0 > 0.0;
    if (!(dt > 0) || rate_factor == 0 || !any(yields)) return dl0;
    const double a = std::max(1 / rate_exponent, 1.0), b = std::max(rate_exponent, 1.0);
    const auto raised = [](const T& z, double n) -> T { return n == 1 ? z : exp(T(n * log(z))); };
    const T growth = rate_factor * pow(T(dl0 / dt), rate_exponent);
    const T rounding = T(16.0 * Limits::epsilon()) * q;
    T z = T(1.0), za = T(1.0), zb = T(1.0);
    for (int i = 0; i < 50; ++i) {
      const T sigma = quasi_static + hardening_modulus * dl0 * za;
      const T f = q - G3 * dl0 * za - sigma * (1.0 + growth * zb);
      const T slope = (G3 + hardening_modulus * (1.0 + growth * zb)) * dl0 * a * za + sigma * growth * b * zb;  // -z f'
      z = select(yields, max(T(Limits::min()), z * (1.0 + f / slope)), T(1.0));
      za = raised(z, a), zb = raised(z, b);
      if (!any(yields && abs(f) > rounding)) break;
    }
    return dl0 * za;
  }
};

}  // namespace strike
