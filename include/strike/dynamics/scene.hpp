#pragma once
#include <tuple>
#include <utility>
#include <vector>

#include <strike/dynamics/part.hpp>

namespace strike {

/// What a scene holds: its nodes and the things that act on them, parts, loads and contacts in any order.
///
/// A thing has some of these verbs, which a step calls in this order, and among things in the order of the scene:
/// - `begin(nodes)`, once: initial conditions, and a look at all nodes;
/// - `deform(nodes, dt, ledger)`: a part's forces at the new positions; returns its StableStep;
/// - `push(nodes, time)`: adds forces; `power(nodes)`: what these do at the present velocities;
/// - `constrain(nodes, step, ledger)`: corrects the velocities of the step to come.
template <class... Things>
struct Scene {
  std::vector<Eigen::Vector3d> nodes;
  std::tuple<Things...> things;

  explicit Scene(std::vector<Eigen::Vector3d> positions, Things... pieces)
      : nodes(std::move(positions)), things(std::move(pieces)...) {}
};

namespace detail {

template <class Thing>
inline constexpr bool is_part = false;
template <class E, class M>
inline constexpr bool is_part<Part<E, M>> = true;

/// A thing of a scene at work: parts take their lanes, the rest stays as it is.
template <class Thing, class T>
struct Running {
  using type = Thing;
  static Thing start(Thing thing, Nodes<RealOf<T>>&, std::size_t&) { return thing; }
};
template <class E, class M, class T>
struct Running<Part<E, M>, T> {
  using type = RunningPart<E, M, T>;
  static type start(Part<E, M> part, Nodes<RealOf<T>>& nodes, std::size_t& number) {
    return type(std::move(part), nodes, number++);
  }
};

}  // namespace detail

}  // namespace strike
