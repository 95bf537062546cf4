#pragma once
#include <concepts>

#include <strike/cxx20.hpp>

namespace strike {

/// Interval in which a condition changes: it holds at `lower` and not at `upper`.
template <std::floating_point Real>
struct Bracket {
  Real lower, upper;

  constexpr Real middle() const { return (lower + upper) / 2; }
};

/// Halves a bracket of the condition while `wide(bracket)`.
template <std::floating_point Real, class Condition, class Wide>
  requires requires(Wide wide, const Bracket<Real> bracket) { bool(wide(bracket)); }
constexpr Bracket<Real> bisect(Bracket<Real> bracket, Condition holds, Wide wide) {
  while (wide(bracket)) {
    const Real middle = bracket.middle();
    (holds(middle) ? bracket.lower : bracket.upper) = middle;
  }
  return bracket;
}
/// Halves a bracket of the condition so many times.
template <std::floating_point Real, class Condition>
constexpr Bracket<Real> bisect(Bracket<Real> bracket, Condition holds, int halvings) {
  return bisect(bracket, holds, [&](const Bracket<Real>&) { return halvings-- > 0; });
}

}  // namespace strike
