#pragma once
#include <tuple>
#include <utility>
#include <vector>

#include <strike/dynamics/part.hpp>
#include <strike/motion/ledger.hpp>
#include <strike/motion/nodes.hpp>
#include <strike/motion/step.hpp>

namespace strike {

namespace detail {

template <class Thing>
inline constexpr bool is_part = false;
template <class E, class M, std::size_t n, class R>
inline constexpr bool is_part<Part<E, M, n, R>> = true;

template <class Thing>
inline constexpr bool turns_nodes_of = false;
template <class E, class M, std::size_t n, class R>
inline constexpr bool turns_nodes_of<Part<E, M, n, R>> = turns_nodes<E>();

template <class Thing>
concept HasAVerb =
    requires(Thing thing, Nodes<double> nodes) { thing.begin(nodes); } ||
    requires(Thing thing, Nodes<double> nodes) { thing.apply_loads(nodes, 0.0); } ||
    requires(Thing thing, Nodes<double> nodes, Step step, Ledger ledger) { thing.constrain(nodes, step, ledger); } ||
    requires(Thing thing, Nodes<double> nodes, Step step, Ledger ledger) {
      thing.resolve_contact(nodes, step, ledger);
    } || requires(Thing thing, std::vector<bool> alive) { thing.remove(std::size_t{}, alive); };

/// Says what it remembers; see strike/output/archive.hpp.
template <class Thing, class Archive>
concept Serializes = requires(Thing& thing, Archive& archive) { thing.serialize(archive); };

template <class Thing>
constexpr bool is_sound() {
  if constexpr (is_part<Thing>)
    return Thing::flaw == Flaw::none;
  else
    return HasAVerb<Thing>;
}

}  // namespace detail

/// What a scene holds: its nodes and the things that act on them, parts, loads and contacts in any order.
///
/// A thing has some of these verbs, which a step calls in this order, and among things in the order of the scene:
/// - `begin(nodes)`, once: initial conditions, and a look at all nodes;
/// - `compute_forces(nodes, dt, ledger, execution)`: a part's forces at the new positions; returns its StableStep;
/// - `stable_step(dt)`: what the thing leaves of a stable step, after all parts have told theirs;
/// - `apply_loads(nodes, time)`: adds forces; `power(nodes)`: what these do at the present velocities;
/// - `constrain(nodes, step, ledger)`: gives the velocities of the step to come along the directions that the thing has
///   taken from its nodes by `nodes.hold` in `begin`;
/// - `resolve_contact(nodes, step, ledger)`: contact; corrects the velocities along what directions are `nodes.free`;
/// - `remove(part, alive)`: after a `deform` that has deleted elements, once for each such part, given by its number;
///   `alive[e]` says whether its element e is there;
/// - `serialize(archive)`: what it remembers, for a Checkpoint; see strike/output/archive.hpp.
template <class... Things>
struct Scene {
  static_assert(
      ((detail::is_part<Things> || detail::HasAVerb<Things>)&&...),
      "strike: one of the things in this Scene is neither a Part nor has one of the verbs begin(nodes), push(nodes, "
      "time), constrain(nodes, step, ledger), resolve_contact(nodes, step, ledger) and remove(part, alive).");
  static_assert((detail::is_part<Things> || ...), "strike: a Scene needs at least one Part.");
  /// Whether any of its elements turns its nodes.
  static constexpr bool nodes_turn = (detail::turns_nodes_of<Things> || ...);
  /// Whether the compiler has not complained about any of its things.
  static constexpr bool sound = (detail::is_sound<Things>() && ...) && (detail::is_part<Things> || ...);

  std::vector<Eigen::Vector3d> nodes;
  std::tuple<Things...> things;

  explicit Scene(std::vector<Eigen::Vector3d> positions, Things... pieces)
      : nodes(std::move(positions)), things(std::move(pieces)...) {}
};

namespace detail {

template <class Bound, class Thing>
inline constexpr bool is_bounded_thing = true;
template <class Bound, class E, class M, std::size_t n, class R>
  requires(Part<E, M, n, R>::flaw == Flaw::none)
inline constexpr bool is_bounded_thing<Bound, Part<E, M, n, R>> = Bound::template suits<E, M>;
/// Whether the bound of the step has what it needs from every part.
template <class Bound, class... Things>
inline constexpr bool is_bounded = (is_bounded_thing<Bound, Things> && ...);

/// A thing of a scene at work: parts take their lanes and what the bound of the step needs, the rest stays as it is.
template <class Thing, class Numbers, class Nodes, class Bound>
struct Running {
  using type = Thing;
  static Thing start(Thing thing, Nodes&, std::vector<std::vector<Index>>&, std::size_t&) { return thing; }
};
template <class E, class M, std::size_t n, class R, class Numbers, class Nodes, class Bound>
struct Running<Part<E, M, n, R>, Numbers, Nodes, Bound> {
  using RunningElement = typename Bound::template Element<E>;
  using RunningMaterial = typename Bound::template Material<M>;
  using type = RunningPart<RunningElement, RunningMaterial, typename Numbers::Number, Nodes, R>;
  static type start(Part<E, M, n, R> part, Nodes& nodes, std::vector<std::vector<Index>>& orders, std::size_t& number) {
    const std::size_t mine = number++;
    return type({RunningElement{std::move(part.element)}, RunningMaterial{std::move(part.material)},
                 std::move(part.cells), part.removal},
                nodes, mine, std::move(orders[mine]));
  }
};

}  // namespace detail

}  // namespace strike
