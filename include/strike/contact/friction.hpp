#pragma once
#include <strike/contact/concepts.hpp>
#include <strike/range.hpp>
#include <strike/scalar/scalar.hpp>

namespace strike {

/// No friction, at no cost.
struct Frictionless {
  template <class Number>
  Number impulse(const Number&, const Number&) const {
    return Number(0.0);
  }
};

/// Coulomb's friction: at most `coefficient` times the normal force; below that the node sticks, without creep.
struct Coulomb {
  double coefficient;

  void ranges(const auto& number) const { number("coefficient", coefficient, range::not_negative); }

  template <class Number>
  Number impulse(const Number& normal, const Number& stops) const {
    return min(Number(coefficient * normal), stops);
  }
};

}  // namespace strike
