#pragma once
#include <type_traits>
#include <utility>

#include <strike/dynamics/relaxation.hpp>
#include <strike/dynamics/step_bound.hpp>
#include <strike/dynamics/subcycling.hpp>
#include <strike/motion/execution.hpp>
#include <strike/motion/nodes.hpp>
#include <strike/pick.hpp>
#include <strike/scalar/scalar.hpp>

namespace strike {

/// Chooses the numbers of a run: T in the formulas of elements and materials, Node for the positions, velocities and
/// forces of nodes, in which small changes add up.
///   Explicit run{scene, options, in<Pack<float>>};          // all in single precision
///   Explicit run{scene, options, in<Pack<float>, double>};  // mixed: elements in single, nodes in double precision
///   Explicit run{scene, options, in<Dual<Pack<double>, 2>>};  // with derivatives, see strike/calibrate.hpp
template <class T, class Node = LaneOf<T>>
struct In {
  using Number = T;
  using NodeReal = Node;
  template <bool turn>
  using Nodes = strike::Nodes<Node, LaneOf<T>, turn>;
  static constexpr bool is_scalar = Scalar<T>;
  static_assert(is_scalar,
                "strike: in<T> names the number in the formulas: double, Pack<double, N>, Pack<float, N> or a Dual.");
};
template <class T, class Node = LaneOf<T>>
inline constexpr In<T, Node> in{};

namespace detail {

template <class P>
struct IsNumbers : std::false_type {};
template <class T, class Node>
struct IsNumbers<In<T, Node>> : std::true_type {};

template <class P>
struct IsExecution : std::bool_constant<Execution<P>> {};

template <class P>
struct IsStepBound : std::bool_constant<StepBound<P>> {};

template <class P>
    struct IsDamping : std::bool_constant < requires {
  P::damps;
} > {};

template <class P>
    struct IsCycle : std::bool_constant < requires {
  P::subcycles;
} > {};

template <class P>
inline constexpr bool is_policy =
    IsNumbers<P>::value || IsExecution<P>::value || IsStepBound<P>::value || IsDamping<P>::value || IsCycle<P>::value;

/// Whether the compiler has been told to compile this execution.
template <class E>
constexpr bool is_available() {
  if constexpr (requires { E::is_available; })
    return E::is_available;
  else
    return true;
}

template <class... Policies>
using NumbersOf = decltype(pick<IsNumbers>(std::declval<Policies>()..., In<Pack<double>>{}));
template <class... Policies>
using ExecutionOf = decltype(pick<IsExecution>(std::declval<Policies>()..., Serial{}));
template <class... Policies>
using StepBoundOf = decltype(pick<IsStepBound>(std::declval<Policies>()..., ElementStep{}));
template <class... Policies>
using DampingOf = decltype(pick<IsDamping>(std::declval<Policies>()..., NoDamping{}));
template <class... Policies>
using CycleOf = decltype(pick<IsCycle>(std::declval<Policies>()..., NoSubcycling{}));

/// Whether the steps of parts can be told apart: the mesh as a whole has one, and rest has none.
template <class Cycle, class Bound, class Damping>
inline constexpr bool can_cycle = !Cycle::subcycles || (std::is_same_v<Bound, ElementStep> && !Damping::damps);

}  // namespace detail

}  // namespace strike
