#pragma once
#include <concepts>
#include <tuple>

#include <strike/motion/nodes.hpp>

namespace strike {

/// What bounds the stable step of a run.
/// A model has
/// - `Element<E>` and `Material<M>`: what parts work with instead of E and M so that the bound knows what it needs,
///   and whether that `suits<E, M>`;
/// - `Running<Nodes, Things>`, begun from the model, with `extend(stable, nodes, things, execution)`: after the forces
///   of a step, replaces the least stable step of all elements by a larger one that is as safe.
template <class B>
concept StepBound = std::copyable<B> && requires { typename B::template Running<Nodes<double>, std::tuple<>>; };

/// The least stable step of all elements: what a run takes unless told otherwise.
struct ElementStep {
  template <class E>
  using Element = E;
  template <class M>
  using Material = M;
  template <class E, class M>
  static constexpr bool suits = true;

  template <class Nodes, class Things>
  struct Running {
    explicit Running(ElementStep) {}
    template <class Stable, class Execution>
    void extend(Stable&, Nodes&, Things&, const Execution&) {}
  };
};

}  // namespace strike
