#pragma once
#include <strike/element/policies.hpp>

namespace strike {

/// Constant thickness.
struct ConstantThickness {
  template <class T>
  struct State {};

  template <class T>
  T relative(const State<T>&) const {
    return T(1.0);
  }
  template <class T>
  void advance(State<T>&, const T&, double) const {}
};

/// Thickness that follows the strain across the plate, h' = h d_zz.
struct ThicknessChange {
  template <class T>
  struct State {
    T relative{1.0};  ///< h/h0
  };

  template <class T>
  T relative(const State<T>& state) const {
    return state.relative;
  }
  template <class T>
  void advance(State<T>& state, const T& normal_rate, double dt) const {
    const T half = (0.5 * dt) * normal_rate;
    state.relative *= (1.0 + half) / (1.0 - half);
  }
};

}  // namespace strike
