#pragma once
#include <concepts>
#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

#include <strike/mesh/part_faces.hpp>
#include <strike/motion/execution.hpp>
#include <strike/motion/ledger.hpp>
#include <strike/motion/step.hpp>
#include <strike/protocol.hpp>

namespace strike {

// An item of a scene: a load, a support, a contact, or anything else that acts on its nodes.
//
// Requirements. An item has at least one of the functions 1 to 6, and may have the others. A step calls them in this
// order, and one function of all items in the order of the scene. `nodes` are strike/motion/nodes.hpp's, in the numbers
// of the run: take them as a template parameter.
//  1. begin(nodes)                           once, when the masses are known: initial velocities, held directions; or
//     begin(nodes, parts)                    with the std::span<const PartFaces> of the scene, from which it learns of
//                                            cells; throws an Error if the item names parts or cells of others
//  2. stable_step(dt, nodes) -> double       the step that is left of the elements' stable dt; `nodes` may be left out
//  3. apply_loads(nodes, time)               adds forces at the new positions, by nodes.add_force;
//     power(nodes) -> double                 and their power at the present velocities, for the balance: both or
//     neither
//  4. constrain(nodes, step, ledger)         sets the velocities of the coming step along directions that it has taken
//                                            from its nodes by nodes.hold in begin
//  5. resolve_contact(nodes, step, ledger)   corrects the velocities along directions that are nodes.free; or
//     resolve_contact(nodes, step, ledger, execution)
//                                            which may use the Execution of the run
//  6. remove(part, alive)                    after a step that has deleted elements, once for each such part: `part` is
//                                            its number, alive[e] is false once its element e is deleted
//  7. warning() -> std::string               a sentence that the user should read before the results; empty: none
//  8. serialize(archive)                     its memory, for a Checkpoint; see strike/output/archive.hpp
//  9. overlaps() -> std::vector<Overlap>      what pushed_apart moves before a run, known after begin; see
//                                            strike/contact/overlap.hpp
// 10. nodes_named() -> std::vector<Index>    the numbers of all nodes that its functions 2 to 5 read or change, known
//                                            after begin: where processes share the nodes, all have these; without it
//                                            all have all
// 11. find_places(nodes)                     when they begin to, after the start: nodes have come to other places in
//                                            memory, of which an item may keep nodes.place(i)
// 12. LoadHistory                             the type of what it calls as history(time) for a number, if it does
//
// Laws. Work that enters or leaves the nodes is booked, by the ledger or by power. The result does not depend on how
// nodes lie in memory: an item names them by their numbers. An item that changes no velocity and no force changes no
// bit of the run.
//
// Models: strike/load/, strike/contact/; examples/own_contact.

namespace detail::item {

struct Begin {
  struct Decoy {
    int begin;
  };
  template <class Item>
  using Member = decltype(&Item::begin);
  template <class Item, class N>
  static constexpr bool takes_parts =
      requires(Item& item, N& nodes, std::span<const PartFaces> parts) { item.begin(nodes, parts); };
  template <class Item, class N>
    requires takes_parts<Item, N>
  static void call(Item& item, N& nodes, std::span<const PartFaces> parts) {
    item.begin(nodes, parts);
  }
  template <class Item, class N>
    requires(!takes_parts<Item, N>)
  static auto call(Item& item, N& nodes, std::span<const PartFaces>) -> decltype(item.begin(nodes)) {
    return item.begin(nodes);
  }
};
struct StableStep {
  struct Decoy {
    int stable_step;
  };
  template <class Item>
  using Member = decltype(&Item::stable_step);
  static double call(auto& item, double dt, const auto& nodes)
    requires requires {
      { item.stable_step(dt, nodes) } -> std::convertible_to<double>;
    }
  {
    return item.stable_step(dt, nodes);
  }
  static double call(auto& item, double dt, const auto&)
    requires requires {
      { item.stable_step(dt) } -> std::convertible_to<double>;
    }
  {
    return item.stable_step(dt);
  }
};
struct ApplyLoads {
  struct Decoy {
    int apply_loads;
  };
  template <class Item>
  using Member = decltype(&Item::apply_loads);
  static auto call(auto& item, auto& nodes, double time) -> decltype(item.apply_loads(nodes, time)) {
    return item.apply_loads(nodes, time);
  }
};
struct Power {
  struct Decoy {
    int power;
  };
  template <class Item>
  using Member = decltype(&Item::power);
  static auto call(auto& item, const auto& nodes) -> decltype(double(item.power(nodes))) { return item.power(nodes); }
};
struct Constrain {
  struct Decoy {
    int constrain;
  };
  template <class Item>
  using Member = decltype(&Item::constrain);
  static auto call(auto& item, auto& nodes, const Step& step, Ledger& ledger)
      -> decltype(item.constrain(nodes, step, ledger)) {
    return item.constrain(nodes, step, ledger);
  }
};
struct ResolveContact {
  struct Decoy {
    int resolve_contact;
  };
  template <class Item>
  using Member = decltype(&Item::resolve_contact);
  template <class Item, class N, class E>
  static constexpr bool takes_execution =
      requires(Item& item, N& nodes, const Step& step, Ledger& ledger, const E& execution) {
        item.resolve_contact(nodes, step, ledger, execution);
      };
  template <class Item, class N, class E = Serial>
    requires takes_execution<Item, N, E>
  static void call(Item& item, N& nodes, const Step& step, Ledger& ledger, const E& execution = {}) {
    item.resolve_contact(nodes, step, ledger, execution);
  }
  template <class Item, class N, class E = Serial>
    requires(!takes_execution<Item, N, E>)
  static auto call(Item& item, N& nodes, const Step& step, Ledger& ledger, const E& = {})
      -> decltype(item.resolve_contact(nodes, step, ledger)) {
    return item.resolve_contact(nodes, step, ledger);
  }
};
struct Remove {
  struct Decoy {
    int remove;
  };
  template <class Item>
  using Member = decltype(&Item::remove);
  static auto call(auto& item, std::size_t part, const std::vector<bool>& alive) -> decltype(item.remove(part, alive)) {
    return item.remove(part, alive);
  }
};
struct Warning {
  struct Decoy {
    int warning;
  };
  template <class Item>
  using Member = decltype(&Item::warning);
  static auto call(const auto& item) -> decltype(item.warning()) { return item.warning(); }
};

// Functions by a name that is mistaken for another, with that one's arguments.

template <class Item, class N>
concept MistakesApplyLoads = requires(Item& item, N& nodes) { item.push(nodes, 0.0); } ||
                             requires(Item& item, N& nodes) { item.apply_load(nodes, 0.0); } ||
                             requires(Item& item, N& nodes) { item.apply_forces(nodes, 0.0); };
template <class Item, class N>
concept MistakesConstrain = requires(Item& item, N& nodes, const Step& step, Ledger& ledger) {
  item.constrains(nodes, step, ledger);
} || requires(Item& item, N& nodes, const Step& step, Ledger& ledger) { item.constraint(nodes, step, ledger); };
template <class Item, class N>
concept MistakesResolveContact = requires(Item& item, N& nodes, const Step& step, Ledger& ledger) {
  item.touch(nodes, step, ledger);
} || requires(Item& item, N& nodes, const Step& step, Ledger& ledger) { item.resolve_contacts(nodes, step, ledger); };

template <class Function, class Item, class... Arguments>
inline constexpr bool has = answers<Function, Item, Arguments...>;
template <class Function, class Item, class... Arguments>
inline constexpr bool misses = nearly<Function, Item, Arguments...> && !is_number<Function, Item>;

/// The first fault of an item in a run whose nodes are N, in the order of the requirements.
enum class Fault {
  none,
  no_function,
  begin,
  stable_step,
  apply_loads,
  power,
  power_missing,
  constrain,
  resolve_contact,
  remove,
  warning,
  history
};

/// A history of a load: called with the time, returns a number.
template <class F>
concept History = requires(F& history, double time) {
  { history(time) } -> std::convertible_to<double>;
};

template <class Item, class N>
constexpr Fault fault() {
  using Part = const std::size_t;
  using Alive = const std::vector<bool>;
  if constexpr (misses<Begin, Item, N, const std::span<const PartFaces>>) return Fault::begin;
  if constexpr (misses<StableStep, Item, double, const N>) return Fault::stable_step;
  if constexpr (misses<ApplyLoads, Item, N, double>) return Fault::apply_loads;
  if constexpr (has<ApplyLoads, Item, N, double>) {
    if constexpr (nearly<Power, Item, const N>) return Fault::power;
    if constexpr (!has<Power, Item, const N>) return Fault::power_missing;
  } else if constexpr (MistakesApplyLoads<Item, N>) {
    return Fault::apply_loads;
  }
  if constexpr (misses<Constrain, Item, N, const Step, Ledger> ||
                (MistakesConstrain<Item, N> && !has<Constrain, Item, N, const Step, Ledger>))
    return Fault::constrain;
  if constexpr (misses<ResolveContact, Item, N, const Step, Ledger> ||
                (MistakesResolveContact<Item, N> && !has<ResolveContact, Item, N, const Step, Ledger>))
    return Fault::resolve_contact;
  if constexpr (misses<Remove, Item, Part, Alive>) return Fault::remove;
  if constexpr (misses<Warning, const Item>) return Fault::warning;
  if constexpr (requires { typename Item::LoadHistory; })
    if constexpr (!History<typename Item::LoadHistory>) return Fault::history;
  if constexpr (!(has<Begin, Item, N, const std::span<const PartFaces>> || has<StableStep, Item, double, const N> ||
                  has<ApplyLoads, Item, N, double> || has<Constrain, Item, N, const Step, Ledger> ||
                  has<ResolveContact, Item, N, const Step, Ledger> || has<Remove, Item, Part, Alive>))
    return Fault::no_function;
  return Fault::none;
}

}  // namespace detail::item

namespace detail {
/// Tells an archive what it remembers.
template <class Item, class Archive>
concept Serializable = requires(Item& item, Archive& archive) { item.serialize(archive); };
}  // namespace detail

}  // namespace strike
