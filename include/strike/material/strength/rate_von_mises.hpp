#pragma once
#include <strike/material/strength/flow_curve.hpp>
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

  /// The flow stress of a step, flow_curve.hpp.
  template <class T>
  class Curve {
   public:
    Curve(const RateVonMises& law, const T& e, double dt)
        : stress_(law.yield_stress + law.hardening_modulus * e),
          hardening_(law.hardening_modulus),
          factor_(law.rate_factor),
          per_dt_(1 / dt),
          rate_(law.rate_exponent) {}

    T at_rest() const { return stress_; }
    void start_at(const T& dl) { rate_.start_at(T(dl * per_dt_)); }
    void move_to(const T&, const T& u) { rate_.move(u); }
    LogSeries<T> series(const T& dl) const {
      return (stress_ + LogSeries<T>::proportional(hardening_ * dl)) * (1.0 + T(factor_) * rate_.series());
    }

   private:
    T stress_;
    double hardening_, factor_, per_dt_;
    detail::RatePower<T> rate_;
  };
  template <class T>
  Curve<T> flow_curve(const T& e, double dt) const {
    return {*this, e, dt};
  }

  /// The rate-independent increment bounds that with a rate.
  template <class T>
  T plastic_increment(const T& q, const T& e, double dt) const {
    const double G3 = 3.0 * shear_modulus;
    const T quasi_static = yield_stress + hardening_modulus * e;
    const T dl0 = max(T(0.0), q - quasi_static) * (1.0 / (G3 + hardening_modulus));
    if (!(dt > 0) || rate_factor == 0) return dl0;
    return detail::find_increment(flow_curve(e, dt), q, G3, T(G3 * dl0));
  }
};

}  // namespace strike
