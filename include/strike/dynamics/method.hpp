#pragma once
#include <concepts>
#include <type_traits>
#include <utility>

#include <strike/dynamics/dynamic_relaxation.hpp>
#include <strike/dynamics/step_bound.hpp>
#include <strike/dynamics/subcycling.hpp>
#include <strike/motion/execution.hpp>
#include <strike/motion/nodes.hpp>
#include <strike/motion/ranks.hpp>
#include <strike/pick.hpp>
#include <strike/range.hpp>
#include <strike/scalar/scalar.hpp>

namespace strike {

/// The numbers of a run: T in the formulas of elements and materials, Node for the positions, velocities and forces of
/// nodes, in which small changes add up.
///   Explicit run{scene, in<Pack<float>>};          // all in single precision
///   Explicit run{scene, in<Pack<float>, double>};  // mixed: elements in single, nodes in double precision
///   Explicit run{scene, in<Dual<Pack<double>, 2>>};  // with derivatives, see strike/calibrate.hpp
template <class T, class Node = LaneOf<T>>
struct In {
  using Number = T;
  using NodeReal = Node;
  template <bool turn, class Ranks = Alone>
  using Nodes = strike::Nodes<Node, LaneOf<T>, turn, Ranks>;
  static constexpr bool is_scalar = Scalar<T>;
  static_assert(is_scalar,
                "strike: in<T> names the number in the formulas: double, Pack<double, N>, Pack<float, N> or a Dual.");
};
template <class T, class Node = LaneOf<T>>
inline constexpr In<T, Node> in{};

namespace detail {

template <class P>
inline constexpr bool is_numbers = false;
template <class T, class Node>
inline constexpr bool is_numbers<In<T, Node>> = true;

/// A kind of policy, with its default.
struct NumbersKind {
  template <class P>
  using Is = std::bool_constant<is_numbers<P>>;
  using Default = In<Pack<double>>;
};
struct ExecutionKind {
  template <class P>
  using Is = std::bool_constant<Execution<P>>;
  using Default = Serial;
};
struct StepBoundKind {
  template <class P>
  using Is = std::bool_constant<StepBound<P>>;
  using Default = ElementStep;
};
struct DampingKind {
  template <class P>
  using Is = std::bool_constant<Damping<P>>;
  using Default = NoDamping;
};
struct CycleKind {
  template <class P>
  using Is = std::bool_constant<Cycle<P>>;
  using Default = NoSubcycling;
};

template <class P>
inline constexpr bool is_policy = NumbersKind::Is<P>::value || ExecutionKind::Is<P>::value ||
                                  StepBoundKind::Is<P>::value || DampingKind::Is<P>::value || CycleKind::Is<P>::value;

/// The policy of a kind among others, or its default.
template <class Kind, class... Policies>
constexpr auto policy_of(const Policies&... policies) {
  return pick<Kind::template Is>(policies..., typename Kind::Default{});
}
template <class Kind, class... Policies>
using PolicyOf = decltype(policy_of<Kind>(std::declval<Policies>()...));

template <class Kind, class... Policies>
inline constexpr bool is_told_once = (int{Kind::template Is<Policies>::value} + ... + 0) <= 1;

/// The compiler has been told to compile this execution.
template <class E>
constexpr bool is_available() {
  if constexpr (requires { E::is_available; })
    return E::is_available;
  else
    return true;
}

/// The faults of a method, in the order in which they are looked for. Apart from Method, whose static_asserts report
/// them, so that they can be asked for in silence.
enum class MethodFault { none, unknown, twice, not_available, unfit_cycle, number };

template <class... Policies>
constexpr MethodFault method_fault() {
  using Cycle = PolicyOf<CycleKind, Policies...>;
  if constexpr (!(is_policy<Policies> && ...))
    return MethodFault::unknown;
  else if constexpr (!(is_told_once<NumbersKind, Policies...> && is_told_once<ExecutionKind, Policies...> &&
                       is_told_once<StepBoundKind, Policies...> && is_told_once<DampingKind, Policies...> &&
                       is_told_once<CycleKind, Policies...>))
    return MethodFault::twice;
  else if constexpr (!is_available<PolicyOf<ExecutionKind, Policies...>>())
    return MethodFault::not_available;
  else if constexpr (Cycle::needs_element_steps && !(std::same_as<PolicyOf<StepBoundKind, Policies...>, ElementStep> &&
                                                     std::same_as<PolicyOf<DampingKind, Policies...>, NoDamping>))
    return MethodFault::unfit_cycle;
  else if constexpr (!PolicyOf<NumbersKind, Policies...>::is_scalar)
    return MethodFault::number;
  else
    return MethodFault::none;
}

}  // namespace detail

/// The policies of a run, in any order and at most one of a kind: numbers (In), execution (Execution), the bound of the
/// step (StepBound), damping (Damping) and the cycle of parts (Cycle). Each protocol stands at its concept; a kind that
/// is not told has its default: in<Pack<double>>, Serial, ElementStep, NoDamping, NoSubcycling.
template <class... Policies>
class Method {
 public:
  using Numbers = detail::PolicyOf<detail::NumbersKind, Policies...>;
  using Execution = detail::PolicyOf<detail::ExecutionKind, Policies...>;
  using Bound = detail::PolicyOf<detail::StepBoundKind, Policies...>;
  using Damping = detail::PolicyOf<detail::DampingKind, Policies...>;
  using Cycle = detail::PolicyOf<detail::CycleKind, Policies...>;
  /// The processes of a run, by its execution, and its nodes.
  using Ranks = decltype(detail::ranks_of(std::declval<Execution>()));
  template <bool turn>
  using Nodes = typename Numbers::template Nodes<turn, Ranks>;

 private:
  using Fault = detail::MethodFault;
  static constexpr Fault fault = detail::method_fault<Policies...>();
  static_assert(
      fault != Fault::unknown,
      "strike: a policy of Explicit is unknown: it takes numbers, such as in<Pack<float>>, an execution, such "
      "as OpenMP{}, a bound of the step, such as GlobalStep{}, DynamicRelaxation{} and Subcycling{}; its "
      "ExplicitOptions come first.");
  static_assert(fault != Fault::twice,
                "strike: Explicit has been given two policies of one kind: leave one numbers, one execution, one bound "
                "of the step, one damping, one cycle.");
  static_assert(
      fault != Fault::not_available,
      "strike: OpenMP{} needs a compiler with OpenMP: link strike::openmp, or compile with -fopenmp; Mpi{} needs "
      "MPI: link strike::mpi.");
  static_assert(fault != Fault::unfit_cycle,
                "strike: Subcycling{} needs the steps of the elements and true times: leave out GlobalStep{} and "
                "DynamicRelaxation{}.");

 public:
  /// Error: a number of a policy that is out of its range.
  explicit Method(const Policies&... policies)
      : execution(detail::policy_of<detail::ExecutionKind>(policies...)),
        bound(detail::policy_of<detail::StepBoundKind>(policies...)),
        damping(detail::policy_of<detail::DampingKind>(policies...)),
        cycle(detail::policy_of<detail::CycleKind>(policies...)) {
    (detail::check_ranges(policies), ...);
  }

  [[no_unique_address]] Execution execution;
  [[no_unique_address]] Bound bound;
  [[no_unique_address]] Damping damping;
  [[no_unique_address]] Cycle cycle;
};

}  // namespace strike
