#pragma once
#include <strike/material/strength/flow_curve.hpp>
#include <strike/range.hpp>
#include <strike/scalar/scalar.hpp>

namespace strike {

/// Flow law of Johnson and Cook (1983): sigma = (A + B e^n) (1 + C ln(max(r/r0, 1))) (1 - T*^m), T* = (T - T0)/(Tm -
/// T0) in [0, 1], T rises with the plastic work.
struct JohnsonCook {
  double shear_modulus;                                                 ///< [stress]
  double A, B, n;                                                       ///< [stress], [stress], [1]
  double C = 0, reference_rate = 1;                                     ///< r0 [1/time]
  double m = 1, initial_temperature = 293, melting_temperature = 1e30;  ///< [1], T0 and Tm [temperature]
  double heating = 0;  ///< rise of temperature per plastic work, 0.9/(rho0 c_p) [temperature volume/energy]

  void ranges(const auto& number) const {
    number("shear_modulus", shear_modulus, range::positive);
    number("A", A, range::not_negative);
    number("B", B, range::not_negative);
    number("n", n, Range{.low = 0, .high = 10});
    number("C", C, range::between(0, 10));
    number("reference_rate", reference_rate, range::positive);
    number("m", m, Range{.low = 0, .high = 100});
    number("initial_temperature", initial_temperature, range::finite);
    number("melting_temperature", melting_temperature, range::above(initial_temperature));
    number("heating", heating, range::not_negative);
  }

  template <class T>
  T flow_stress(const T& e, const T& rate, const T& temperature) const {
    const T homologous = (temperature - initial_temperature) * (1.0 / (melting_temperature - initial_temperature));
    const T softening = select(homologous > 0.0, pow(min(T(1.0), homologous), m), T(0.0));
    return (A + B * pow(e, n)) * (1.0 + C * log(max(rate * (1.0 / reference_rate), T(1.0)))) * (1.0 - softening);
  }

  /// The flow stress of a step at the temperature of its start, flow_curve.hpp.
  template <class T>
  class Curve {
   public:
    Curve(const JohnsonCook& law, const T& e, const T& temperature, double dt)
        : A_(law.A), B_(law.B), C_(law.C), per_dt_(1 / dt / law.reference_rate), power_(e, law.n) {
      const T homologous = min(T(1.0), (temperature - law.initial_temperature) *
                                           (1.0 / (law.melting_temperature - law.initial_temperature)));
      thermal_ = select(homologous > 0.0, 1.0 - detail::raised(homologous, law.m), T(1.0));
    }

    T at_rest() const { return thermal_ * (A_ + B_ * power_.at_rest()); }
    void start_at(const T& dl) {
      power_.move_to(dl);
      log_rate_ = log(T(dl * per_dt_));
    }
    void move_to(const T& dl, const T& u) {
      power_.move_to(dl);
      log_rate_ += u;
    }
    LogSeries<T> series(const T& dl) const {
      const auto fast = log_rate_ > 0.0;
      const LogSeries<T> rate{1.0 + C_ * max(T(0.0), log_rate_), select(fast, T(C_), T(0.0)), T(0.0), T(0.0)};
      return (thermal_ * rate) * (A_ + T(B_) * power_.series(dl));
    }
    /// Where the rate does not pass r0.
    auto is_smooth(const T&, const T& u) const { return log_rate_ * (log_rate_ + u) > 0.0; }

   private:
    double A_, B_, C_, per_dt_;
    detail::StrainPower<T> power_;
    T thermal_, log_rate_{};
  };
  template <class T>
  Curve<T> flow_curve(const T& e, const T& temperature, double dt) const {
    return {*this, e, temperature, dt};
  }
};

}  // namespace strike
