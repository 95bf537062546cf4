#pragma once
#include <strike/material/strength/flow_curve.hpp>
#include <strike/range.hpp>
#include <strike/scalar/scalar.hpp>

namespace strike {

/// Flow law of Swift (1952), sigma = K (e0 + e)^n with the yield stress Y = K e0^n. e0 = (K/E)^(1/(1 - n)), the strain
/// at which Hollomon's law of the total strain leaves the elastic line, makes it Hollomon's; Ludwik's A + B e^n is
/// JohnsonCook.
struct PowerHardening {
  double shear_modulus;   ///< [stress]
  double coefficient;     ///< K [stress]
  double exponent;        ///< n, from 0 to 1
  double initial_strain;  ///< e0 > 0: (Y/K)^(1/n)

  void ranges(const auto& number) const {
    number("shear_modulus", shear_modulus, range::positive);
    number("coefficient", coefficient, range::not_negative);
    number("exponent", exponent, range::share);
    number("initial_strain", initial_strain, range::positive);
  }

  template <class T>
  T flow_stress(const T& e) const {
    return coefficient * pow(T(initial_strain + e), exponent);
  }

  /// The flow stress of a step, flow_curve.hpp.
  template <class T>
  class Curve {
   public:
    Curve(const PowerHardening& law, const T& e)
        : coefficient_(law.coefficient), power_(T(law.initial_strain + e), law.exponent) {}

    T at_rest() const { return coefficient_ * power_.at_rest(); }
    void start_at(const T& dl) { power_.move_to(dl); }
    void move_to(const T& dl, const T&) { power_.move_to(dl); }
    LogSeries<T> series(const T& dl) const { return T(coefficient_) * power_.series(dl); }

   private:
    double coefficient_;
    detail::StrainPower<T> power_;
  };
  template <class T>
  Curve<T> flow_curve(const T& e, double) const {
    return {*this, e};
  }
};

}  // namespace strike
