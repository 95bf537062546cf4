#pragma once
#include <string>

#include <strike/material/strength/flow_curve.hpp>
#include <strike/range.hpp>
#include <strike/scalar/scalar.hpp>

namespace strike {

/// Von Mises plasticity with linear isotropic hardening: sigma = Y + H e, never below zero.
struct VonMises {
  double shear_modulus;          ///< G [stress]
  double yield_stress;           ///< Y [stress]
  double hardening_modulus = 0;  ///< H = d sigma / d (plastic strain), > -3 G; negative is softening [stress]

  void ranges(const auto& number) const {
    number("shear_modulus", shear_modulus, range::positive);
    number("yield_stress", yield_stress, range::not_negative);
    number("hardening_modulus", hardening_modulus, range::above(-3 * shear_modulus));
  }
  std::string warning() const {
    if (hardening_modulus >= 0) return {};
    return "The hardening modulus is negative: strain that softens gathers in one row of elements, and the result "
           "depends on the mesh.";
  }

  template <class T>
  T flow_stress(const T& e) const {
    return max(T(0.0), yield_stress + hardening_modulus * e);
  }
  /// The flow stress of a step, flow_curve.hpp.
  template <class T>
  class Curve {
   public:
    Curve(const VonMises& law, const T& e)
        : stress_(law.yield_stress + law.hardening_modulus * e), hardening_(law.hardening_modulus) {}

    T at_rest() const { return max(T(0.0), stress_); }
    void start_at(const T&) {}
    void move_to(const T&, const T&) {}
    LogSeries<T> series(const T& dl) const {
      const T stress = stress_ + hardening_ * dl, rise = select(stress > 0.0, hardening_ * dl, T(0.0));
      return {max(T(0.0), stress), rise, 0.5 * rise, (1.0 / 6) * rise};
    }
    /// Where the stress does not reach zero.
    auto is_smooth(const T& dl, const T& u) const {
      return (stress_ + hardening_ * dl > 0.0) && (stress_ + hardening_ * dl * (1.0 + u * (1.0 + u)) > 0.0);
    }

   private:
    T stress_;
    double hardening_;
  };
  template <class T>
  Curve<T> flow_curve(const T& e, double) const {
    return {*this, e};
  }

  /// q - 3 G dl = Y + H (e + dl), solved for dl.
  template <class T>
  T plastic_increment(const T& q, const T& e, double) const {
    const double G3 = 3.0 * shear_modulus;
    const T dl = max(T(0.0), q - (yield_stress + hardening_modulus * e)) * (1.0 / (G3 + hardening_modulus));
    return min(dl, (1.0 / G3) * q);
  }
};

}  // namespace strike
