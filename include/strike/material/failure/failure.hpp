#pragma once
#include <strike/scalar/scalar.hpp>

namespace strike {

/// When a material fails: `fails(equivalent_stress, state)`, asked after each step, with a `State<T>` that has
/// `intact`. What has failed carries no stress and stays failed; its mass remains.
template <class F>
concept FailureCriterion = requires {
  typename F::template State<double>;
};

/// Never.
struct NoFailure {
  template <class T>
  struct State {};
};

namespace detail {
template <class T>
struct Intact {
  T intact{1.0};  ///< 1, or 0 once failed
};
}  // namespace detail

/// Fails when the equivalent stress reaches the ultimate stress (Brockman and Held 1991).
struct UltimateStress {
  double ultimate_stress;

  template <class T>
  using State = detail::Intact<T>;
  template <class T, class S>
  auto fails(const T& equivalent_stress, const S&) const {
    return equivalent_stress >= ultimate_stress;
  }
};

/// Fails when the equivalent plastic strain reaches a limit.
struct FailureStrain {
  double failure_strain;

  template <class T>
  using State = detail::Intact<T>;
  template <class T, class S>
  auto fails(const T&, const S& state) const {
    return state.equivalent_plastic_strain >= failure_strain;
  }
};

/// What has failed by a criterion is a fluid from then on: it carries no change of shape and no tension, but the
/// pressure of its equation of state, and its elements go on.
///   Solid{eos, strength, BecomesFluid{UltimateStress{20e3}}}
template <FailureCriterion Criterion>
struct BecomesFluid {
  Criterion criterion;

  template <class T>
  struct State {
    T solid{1.0};  ///< 1, or 0 once failed
  };
  template <class T, class S>
  auto fails(const T& equivalent_stress, const S& state) const {
    return criterion.fails(equivalent_stress, state);
  }
};
template <class Criterion>
BecomesFluid(Criterion) -> BecomesFluid<Criterion>;

}  // namespace strike
