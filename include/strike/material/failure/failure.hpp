#pragma once
#include <concepts>
#include <type_traits>

#include <strike/material/report.hpp>
#include <strike/protocol.hpp>
#include <strike/range.hpp>
#include <strike/scalar/scalar.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike {

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

/// Archetype of the point that a failure law sees: the stress and the strength's memory beside the law's own.
template <class F, class T>
struct FailurePoint : F::template State<T> {
  SymmetricTensor<T> stress{};
  T equivalent_plastic_strain{}, temperature_rise{};
};

template <class State>
inline constexpr bool has_intact = requires(State state) { state.intact; };
template <class State>
inline constexpr bool has_solid = requires(State state) { state.solid; };
}  // namespace detail

/// Absence of failure.
struct NoFailure {
  template <class T>
  struct State {};
};

/// A failure law: when a point of a material fails.
///
/// Requirements
/// 1. `State<T>`: an aggregate with the flag `intact` that starts at 1. The material sets it to 0 where the law says
///    so; the point then carries no stress and stays failed, and its mass remains. With a flag `solid` in its place the
///    point keeps the pressure of its equation of state, without tension (see BecomesFluid).
/// 2. `fails(equivalent_stress, state)`: true, or a mask of lanes, where the point fails; called after each step with
///    the state that has the new stress and plastic strain. A template over both.
/// Optional
/// 3. `accumulate(state, equivalent_stress, plastic_increment, dt)`: gathers damage before that; needed if State<T>
///    holds more than the flag, for nothing else can change it.
/// 4. `ranges(number)`: what its numbers may be (strike/range.hpp).
/// Laws: no stress, no failure; lane i of a pack gives what a double gives.
/// Models: UltimateStress, FailureStrain, PrincipalStress, TulerButcher, JohnsonCookFailure, BecomesFluid; NoFailure
/// is the absence of one.
template <class F, class T = double>
concept FailureCriterion =
    std::same_as<F, NoFailure> ||
    (detail::has_intact<typename F::template State<T>> != detail::has_solid<typename F::template State<T>> &&
     requires(const F failure, const detail::FailurePoint<F, T> point, const T stress) {
       { select(failure.fails(stress, point), stress, stress) } -> std::convertible_to<T>;
     });

namespace detail {

struct Fails {
  struct Decoy {
    int fails;
  };
  template <class Model>
  using Member = decltype(&Model::fails);
  template <class T>
  static auto call(const auto& failure, const T& stress, const auto& state)
      -> decltype(select(failure.fails(stress, state), stress, stress)) {
    return select(failure.fails(stress, state), stress, stress);
  }
};
struct Fail {
  struct Decoy {
    int fail;
  };
  template <class Model>
  using Member = decltype(&Model::fail);
};
struct Accumulate {
  struct Decoy {
    int accumulate;
  };
  template <class Model>
  using Member = decltype(&Model::accumulate);
  template <class T>
  [[gnu::always_inline]] static inline auto call(const auto& failure, auto& state, const T& stress, const T& increment,
                                                 const double& dt)
      -> decltype(failure.accumulate(state, stress, increment, dt)) {
    return failure.accumulate(state, stress, increment, dt);
  }
};
template <class F, class T>
inline constexpr bool accumulates = answers<Accumulate, const F, FailurePoint<F, T>, const T, const T, const double>;

/// Flaws of a failure law, in the order in which they are reported.
enum class FailureFlaw { none, absent, fails, fail, flag, in_double, accumulate, memory, tensors };
template <class F>
constexpr FailureFlaw failure_flaw() {
  if constexpr (std::same_as<F, NoFailure>)
    return FailureFlaw::none;
  else if constexpr (!requires { typename F::template State<double>; })
    return HasName<Fails, F> ? FailureFlaw::flag : FailureFlaw::absent;
  else if constexpr (!HasName<Fails, F>)
    return HasName<Fail, F> || has_intact<typename F::template State<double>> ? FailureFlaw::fail : FailureFlaw::absent;
  else if constexpr (has_intact<typename F::template State<double>> == has_solid<typename F::template State<double>>)
    return FailureFlaw::flag;
  else if constexpr (!FailureCriterion<F>)
    return FailureFlaw::fails;
  else if constexpr (!FailureCriterion<F, TrialLanes>)
    return FailureFlaw::in_double;
  else if constexpr (HasName<Accumulate, F> && !accumulates<F, TrialLanes>)
    return FailureFlaw::accumulate;
  else if constexpr (!accumulates<F, double> && sizeof(typename F::template State<double>) > sizeof(double))
    return FailureFlaw::memory;
  else if constexpr (requires(typename F::template State<double> state) { state.spatial_tensors(); })
    return FailureFlaw::tensors;
  else
    return FailureFlaw::none;
}

/// Reports what is nearly a failure law.
template <class F>
struct FailureReport {
  static constexpr FailureFlaw flaw = failure_flaw<F>();
  static_assert(flaw != FailureFlaw::fails,
                "strike: fails of a failure law is template <class T, class S> auto fails(const T& equivalent_stress, "
                "const S& state) const; this one has other arguments or another result.");
  static_assert(flaw != FailureFlaw::fail,
                "strike: this failure law never fails: give it template <class T, class S> auto fails(const T& "
                "equivalent_stress, const S& state) const.");
  static_assert(flaw != FailureFlaw::flag,
                "strike: the State<T> of a failure law needs the flag that its material sets: T intact{1.0}, or T "
                "solid{1.0} for what goes on as a fluid.");
  static_assert(flaw != FailureFlaw::in_double,
                "strike: fails of this failure law takes double alone: make it a template over the number, template "
                "<class T, class S> auto fails(const T& equivalent_stress, const S& state) const.");
  static_assert(flaw != FailureFlaw::accumulate,
                "strike: accumulate of a failure law is template <class T, class S> void accumulate(S& state, const T& "
                "equivalent_stress, const T& plastic_increment, double dt) const; this one has other arguments.");
  static_assert(flaw != FailureFlaw::memory,
                "strike: the State<T> of this failure law holds more than its flag, and nothing changes it: give it "
                "accumulate(state, equivalent_stress, plastic_increment, dt).");
  static_assert(
      flaw != FailureFlaw::tensors,
      "strike: spatial_tensors in the State<T> of a failure law are not turned: keep what turns in a strength "
      "with memory.");
  static void try_on_lanes([[maybe_unused]] const F& failure) {
    if constexpr (flaw == FailureFlaw::none && !std::same_as<F, NoFailure>) {
      FailurePoint<F, TrialLanes> point{};
      const TrialLanes x = 1.0;
      if constexpr (accumulates<F, TrialLanes>) failure.accumulate(point, x, x, 1.0);
      (void)failure.fails(x, point);
    }
  }
  using OnLanes = Tried<&FailureReport::try_on_lanes>;
};

template <class F>
inline constexpr bool gathers_damage = requires(typename F::template State<double> state) { state.damage; };
template <class F, class T>
using DamageOf = std::conditional_t<gathers_damage<F>, Damage<T>, NoDamage>;

/// The equivalent plastic strain; 0 of what does not flow.
template <class T, class State>
T plastic_strain(const State& state) {
  if constexpr (requires { state.equivalent_plastic_strain; })
    return state.equivalent_plastic_strain;
  else
    return (void)state, T(0.0);
}

/// The answer of a failure law after a step that started at the plastic strain `strain_old`.
template <class F, class T, class State>
auto fails_now(const F& failure, State& state, const T& equivalent_stress, const T& strain_old, double dt) {
  call_if_present<Accumulate>(failure, state, equivalent_stress, T(plastic_strain<T>(state) - strain_old), dt);
  return failure.fails(equivalent_stress, state);
}

}  // namespace detail

/// Failure when the equivalent stress reaches the ultimate stress (Brockman and Held 1991).
struct UltimateStress {
  double ultimate_stress;  ///< [stress]

  void ranges(const auto& number) const {
    number("ultimate_stress", ultimate_stress, range::or_infinite(range::not_negative));
  }

  template <class T>
  using State = detail::Intact<T>;
  template <class T, class S>
  auto fails(const T& equivalent_stress, const S&) const {
    return equivalent_stress >= ultimate_stress;
  }
};

/// Failure when the equivalent plastic strain reaches a limit.
struct FailureStrain {
  double failure_strain;

  void ranges(const auto& number) const {
    number("failure_strain", failure_strain, range::or_infinite(range::not_negative));
  }

  template <class T>
  using State = detail::Intact<T>;
  template <class T, class S>
    requires requires(const S state) { state.equivalent_plastic_strain; }
  auto fails(const T&, const S& state) const {
    return state.equivalent_plastic_strain >= failure_strain;
  }
};

/// Failure that leaves a fluid: without strength and tension, with the pressure of the equation of state; its elements
/// go on.
///   Solid{eos, strength, BecomesFluid{UltimateStress{20e3}}}
template <FailureCriterion Criterion>
struct BecomesFluid {
  Criterion criterion;

  void ranges(const auto& number) const { number(criterion); }

  template <class T>
  struct State : detail::DamageOf<Criterion, T> {
    T solid{1.0};  ///< 1, or 0 once failed
  };
  template <class T, class S>
  void accumulate(S& state, const T& equivalent_stress, const T& plastic_increment, double dt) const {
    detail::call_if_present<detail::Accumulate>(criterion, state, equivalent_stress, plastic_increment, dt);
  }
  template <class T, class S>
  auto fails(const T& equivalent_stress, const S& state) const -> decltype(criterion.fails(equivalent_stress, state)) {
    return criterion.fails(equivalent_stress, state);
  }
};
template <class Criterion>
BecomesFluid(Criterion) -> BecomesFluid<Criterion>;

}  // namespace strike
