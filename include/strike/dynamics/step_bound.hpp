#pragma once
#include <concepts>
#include <tuple>

#include <strike/motion/nodes.hpp>

namespace strike {

// A bound of the stable step of a run, a policy of Explicit.
//
// Requirements.
//  1. Element<E>, Material<M>      the types that parts work with instead of E and M, so that the bound finds in their
//                                  states what it needs
//  2. suits<E, M>                  static constexpr bool: it can work with such elements
//  3. Running<Nodes, Items>        the bound at work, constructed from the model, with
//     extend(stable, nodes, items, execution)   after the forces of a step: replaces the least stable step of all
//                                               elements by a larger one, and
//     serialize(archive)                        its memory
// Laws. The step that it allows is stable; it depends neither on the order of the items nor on the threads.
//
// Models: ElementStep, GlobalStep.
template <class B>
concept StepBound = std::copyable<B> && requires { typename B::template Running<Nodes<double>, std::tuple<>>; };

/// The least stable step of all elements: the default.
struct ElementStep {
  template <class E>
  using Element = E;
  template <class M>
  using Material = M;
  template <class E, class M>
  static constexpr bool suits = true;

  template <class Nodes, class Items>
  struct Running {
    explicit Running(ElementStep) {}
    template <class Stable, class Execution>
    void extend(Stable&, Nodes&, Items&, const Execution&) {}
    void serialize(auto&) {}
  };
};

}  // namespace strike
