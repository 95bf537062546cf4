#pragma once
#include <algorithm>
#include <concepts>

namespace strike {

/// The friction of a contact.
/// A model has `impulse(normal, stops)`: the impulse against the sliding, from the normal one and from the one that
/// would stop it [force time], between 0 and the latter.
template <class F>
concept Friction = std::copyable<F> && requires(const F friction) {
  { friction.impulse(1.0, 1.0) } -> std::convertible_to<double>;
};

/// Sliding costs nothing, and neither does this.
struct Frictionless {
  double impulse(double, double) const { return 0; }
};

/// Coulomb: at most `coefficient` times the normal force; below that the node sticks, without creep.
struct Coulomb {
  double coefficient;
  double impulse(double normal, double stops) const { return std::min(coefficient * normal, stops); }
};

}  // namespace strike
