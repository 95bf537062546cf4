#pragma once
#include <strike/material/failure/failure.hpp>
#include <strike/range.hpp>
#include <strike/scalar/scalar.hpp>

namespace strike {

/// Failure after a time by Tuler and Butcher (1968), when the damage
///   int (max(0, s1 - s0)/S)^k dt/t0
/// of the largest principal stress s1 reaches 1: under the constant stress s0 + S after the time t0, under one that
/// grows at the rate s' at s0 + [(k + 1) S^k t0 s']^(1/(k + 1)). Without a threshold s0, and with k = 16, this is
/// Brown's (1974) law of the duration of load on glass.
struct TulerButcher {
  double threshold = 0;  ///< s0, below which there is no damage [stress]
  double strength;       ///< S [stress]
  double duration;       ///< t0 [time]
  double exponent;       ///< k

  void ranges(const auto& number) const {
    number("threshold", threshold, range::not_negative);
    number("strength", strength, range::positive);
    number("duration", duration, range::positive);
    number("exponent", exponent, Range{.low = 0, .high = 100});
  }

  template <class T>
  struct State : detail::Intact<T>, detail::Damage<T> {};

  template <class T, class S>
  void accumulate(S& state, const T&, const T&, double dt) const {
    const T excess = (1.0 / strength) * max(T(0.0), largest_principal(state.stress) - threshold);
    state.damage = min(T(1.0), state.damage + (dt / duration) * pow(excess, exponent));
  }
  template <class T, class S>
  auto fails(const T&, const S& state) const {
    return state.damage >= 1.0;
  }
};

}  // namespace strike
