#pragma once
#include <cmath>
#include <limits>

#include <strike/material/strength/flow_curve.hpp>
#include <strike/range.hpp>
#include <strike/scalar/scalar.hpp>

namespace strike {

/// Flow law of Zerilli and Armstrong (1987), of dislocations that cross barriers by thermal activation, with both of
/// their lattices in one formula:
///   sigma = C0 + [C1 + C2 sqrt(e)] exp(-C3 T + C4 T ln(r/r0)) + C5 e^n
/// bcc (iron) has C2 = 0 (eq. 20), fcc (copper) C1 = C5 = 0 (eq. 19). T is absolute and rises with the plastic work.
/// The thermal part vanishes with the rate.
struct ZerilliArmstrong {
  double shear_modulus;              ///< [stress]
  double C0;                         ///< of solutes and grains, sigma_G + k/sqrt(l) [stress]
  double C1 = 0, C2 = 0;             ///< [stress]
  double C3, C4;                     ///< [1/temperature]
  double C5 = 0, n = 1;              ///< [stress], [1]
  double reference_rate = 1;         ///< r0 [1/time]
  double initial_temperature = 293;  ///< [temperature]
  double heating = 0;  ///< rise of temperature per plastic work, 0.9/(rho0 c_p) [temperature volume/energy]

  void ranges(const auto& number) const {
    number("shear_modulus", shear_modulus, range::positive);
    number("C0", C0, range::not_negative);
    number("C1", C1, range::not_negative);
    number("C2", C2, range::not_negative);
    number("C3", C3, range::not_negative);
    number("C4", C4, range::not_negative);
    number("C5", C5, range::not_negative);
    number("n", n, Range{.low = 0, .high = 10});
    number("reference_rate", reference_rate, range::positive);
    number("initial_temperature", initial_temperature, range::positive);
    number("heating", heating, range::not_negative);
  }

  template <class T>
  T flow_stress(const T& e, const T& rate, const T& temperature) const {
    const T activity = log(max(rate * (1.0 / reference_rate), T(std::numeric_limits<RealOf<T>>::min())));
    const T thermal = exp(T(temperature * (C4 * activity - C3)));
    return C0 + (C1 + C2 * sqrt(e)) * thermal + C5 * pow(e, n);
  }

  /// The flow stress of a step at the temperature of its start, flow_curve.hpp. The thermal part is a power of the
  /// rate.
  template <class T>
  class Curve {
   public:
    Curve(const ZerilliArmstrong& law, const T& e, const T& temperature, double dt)
        : law_(law),
          per_dt_(1 / dt / law.reference_rate),
          root_(e, 0.5),
          power_(e, law.n),
          exponent_(law.C4 * temperature),
          cold_(-law.C3 * temperature) {}

    T at_rest() const {
      const double slowest = std::log(std::numeric_limits<RealOf<T>>::min());
      T stress = law_.C0 + (law_.C1 + law_.C2 * root_.at_rest()) * exp(T(slowest * exponent_ + cold_));
      if (law_.C5 != 0) stress += law_.C5 * power_.at_rest();
      return stress;
    }
    void start_at(const T& dl) {
      move_strain_to(dl);
      thermal_ = exp(T(cold_ + exponent_ * log(T(dl * per_dt_))));
    }
    void move_to(const T& dl, const T& u) {
      move_strain_to(dl);
      thermal_ *= exp(T(exponent_ * u));
    }
    LogSeries<T> series(const T& dl) const {
      LogSeries<T> stress =
          law_.C0 + LogSeries<T>::exponential(thermal_, exponent_) * (law_.C1 + T(law_.C2) * root_.series(dl));
      if (law_.C5 != 0) stress = stress + T(law_.C5) * power_.series(dl);
      return stress;
    }

   private:
    void move_strain_to(const T& dl) {
      root_.move_to(dl);
      if (law_.C5 != 0) power_.move_to(dl);
    }

    const ZerilliArmstrong& law_;
    double per_dt_;
    detail::StrainPower<T> root_, power_;
    T exponent_, cold_, thermal_{};
  };
  template <class T>
  Curve<T> flow_curve(const T& e, const T& temperature, double dt) const {
    return {*this, e, temperature, dt};
  }
};

}  // namespace strike
