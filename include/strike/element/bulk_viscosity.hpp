#pragma once
#include <strike/element/policies.hpp>
#include <strike/range.hpp>

namespace strike {

/// Shock viscosity of von Neumann and Richtmyer (1950) with Landshoff's linear term (1955), in compression only:
///   q = rho l |tr D| (C0^2 l |tr D| + C1 c) = rho c^2 s (C0^2 s + C1),   s = |tr D| tau,   tau = l/c,
/// with the compression s in the time tau in which a wave crosses the element.
struct BulkViscosity {
  double quadratic = 1.5;  ///< C0
  double linear = 0.06;    ///< C1

  void ranges(const auto& number) const {
    number("quadratic", quadratic, range::between(0, 100));
    number("linear", linear, range::between(0, 100));
  }

  template <class T>
  struct State {
    T pressure{};  ///< q of the last step; the work is that of the mean over a step [stress]
  };

  /// q, positive in compression; rate = tr D.
  template <class T>
  T pressure(const T& wave_modulus, const T& tau, const T& rate) const {
    const T s = max(T(0.0), -rate) * tau;
    return wave_modulus * s * (quadratic * quadratic * s + linear);
  }
  /// dq/d|tr D| [stress time], the coefficient of viscosity in the stable step.
  template <class T>
  T coefficient(const T& wave_modulus, const T& tau, const T& rate) const {
    const T s = max(T(0.0), -rate) * tau;
    return wave_modulus * tau * (2.0 * quadratic * quadratic * s + linear);
  }
  /// Energy dissipated by a step to the pressure q that changes the volume by dV.
  template <class T>
  T work(State<T>& state, const T& q, const T& dV) const {
    const T mean = 0.5 * (state.pressure + q);
    state.pressure = q;
    return -mean * dV;
  }
};

/// BulkViscosity whose linear term acts in expansion too, as in Abaqus/Explicit: behind a release stresses do not ring,
/// so that tension does not overshoot and tear what would hold. Matter that flies apart without strength feels a pull
/// of C1 rho c l tr D, which BulkViscosity spares it.
struct BulkViscosityBothWays {
  double quadratic = 1.5;  ///< C0, in compression
  double linear = 0.06;    ///< C1

  void ranges(const auto& number) const {
    number("quadratic", quadratic, range::between(0, 100));
    number("linear", linear, range::between(0, 100));
  }

  template <class T>
  using State = BulkViscosity::State<T>;

  template <class T>
  T pressure(const T& wave_modulus, const T& tau, const T& rate) const {
    const T s = -rate * tau;
    return wave_modulus * s * (quadratic * quadratic * max(T(0.0), s) + linear);
  }
  template <class T>
  T coefficient(const T& wave_modulus, const T& tau, const T& rate) const {
    return in_compression().coefficient(wave_modulus, tau, rate);
  }
  template <class T>
  T work(State<T>& state, const T& q, const T& dV) const {
    return in_compression().work(state, q, dV);
  }

 private:
  constexpr BulkViscosity in_compression() const { return {quadratic, linear}; }
};

/// Absence of bulk viscosity.
struct NoBulkViscosity {
  template <class T>
  struct State {};

  template <class T>
  T pressure(const T&, const T&, const T&) const {
    return T(0.0);
  }
  template <class T>
  T coefficient(const T&, const T&, const T&) const {
    return T(0.0);
  }
  template <class T>
  T work(State<T>&, const T&, const T&) const {
    return T(0.0);
  }
};

}  // namespace strike
