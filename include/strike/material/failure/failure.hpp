#pragma once
#include <type_traits>

#include <strike/scalar/scalar.hpp>

namespace strike {

/// When a material fails: `fails(equivalent_stress, state)`, asked after each step, when the state has the new stress
/// and plastic strain; with a `State<T>` that has `intact`. What has failed carries no stress and stays failed; its
/// mass remains. A criterion that gathers damage over the steps has beside that
///   accumulate(state, equivalent_stress, plastic_increment, dt)
template <class F>
concept FailureCriterion = requires { typename F::template State<double>; };

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
template <class T>
struct Damage {
  T damage{};  ///< from 0 to 1, when it fails
};
struct NoDamage {};
template <class F>
inline constexpr bool gathers_damage = requires(typename F::template State<double> state) { state.damage; };
template <class F, class T>
using DamageOf = std::conditional_t<gathers_damage<F>, Damage<T>, NoDamage>;

/// 0 of what does not flow.
template <class T, class State>
T plastic_strain(const State& state) {
  if constexpr (requires { state.equivalent_plastic_strain; })
    return state.equivalent_plastic_strain;
  else
    return (void)state, T(0.0);
}

/// Whether it fails in this step, which began with the plastic strain `strain_old`.
template <class F, class T, class State>
auto fails_now(const F& failure, State& state, const T& equivalent_stress, const T& strain_old, double dt) {
  if constexpr (requires { failure.accumulate(state, equivalent_stress, strain_old, dt); })
    failure.accumulate(state, equivalent_stress, T(plastic_strain<T>(state) - strain_old), dt);
  return failure.fails(equivalent_stress, state);
}
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
  struct State : detail::DamageOf<Criterion, T> {
    T solid{1.0};  ///< 1, or 0 once failed
  };
  template <class T, class S>
    requires requires(const Criterion c, S& state, T x) { c.accumulate(state, x, x, 1.0); }
  void accumulate(S& state, const T& equivalent_stress, const T& plastic_increment, double dt) const {
    criterion.accumulate(state, equivalent_stress, plastic_increment, dt);
  }
  template <class T, class S>
  auto fails(const T& equivalent_stress, const S& state) const {
    return criterion.fails(equivalent_stress, state);
  }
};
template <class Criterion>
BecomesFluid(Criterion) -> BecomesFluid<Criterion>;

}  // namespace strike
