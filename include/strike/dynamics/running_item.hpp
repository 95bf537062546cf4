#pragma once
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <strike/dynamics/any_part.hpp>
#include <strike/dynamics/arrangement.hpp>
#include <strike/dynamics/item.hpp>
#include <strike/dynamics/method.hpp>
#include <strike/dynamics/running_part.hpp>
#include <strike/dynamics/scene.hpp>

namespace strike::detail {

/// An item of a scene at work, to which it is moved: a part takes its lanes and what the bound of the step needs, the
/// rest stays as it is.
template <class Item, class Method, class Nodes>
struct RunningItem {
  using type = Item;
  static void place(const Item&, Arrangement&) {}
  static Item start(Item& item, Nodes&, Arrangement&, std::size_t&) { return std::move(item); }
};
template <class E, class M, std::size_t n, class R, class Method, class Nodes>
struct RunningItem<Part<E, M, n, R>, Method, Nodes> {
  using Element = typename Method::Bound::template Element<E>;
  using Material = typename Method::Bound::template Material<M>;
  using type = RunningPart<Element, Material, typename Method::Numbers::Number, Nodes, R>;
  static void place(const Part<E, M, n, R>& part, Arrangement& arrangement) {
    arrangement.place(type::blocks_of(part.cells.size()), sizeof(typename type::Block));
  }
  static type start(Part<E, M, n, R>& part, Nodes& nodes, Arrangement& arrangement, std::size_t& number) {
    const std::size_t mine = number++;
    return type(
        {Element{std::move(part.element)}, Material{std::move(part.material)}, std::move(part.cells), part.removal},
        nodes, mine, std::move(arrangement.cells[mine]),
        arrangement.places.empty() ? std::nullopt : std::optional(arrangement.places[mine]));
  }
};

template <class Item, class Method, class Nodes>
struct RunningItem<std::vector<Item>, Method, Nodes> {
  using One = RunningItem<Item, Method, Nodes>;
  using type = std::vector<typename One::type>;
  static void place(const std::vector<Item>& items, Arrangement& arrangement) {
    for (const Item& item : items) One::place(item, arrangement);
  }
  static type start(std::vector<Item>& items, Nodes& nodes, Arrangement& arrangement, std::size_t& number) {
    type started;
    started.reserve(items.size());
    for (Item& item : items) started.push_back(One::start(item, nodes, arrangement, number));
    return started;
  }
};
template <class... Items, class Method, class Nodes>
struct RunningItem<std::variant<Items...>, Method, Nodes> {
  using type = std::variant<typename RunningItem<Items, Method, Nodes>::type...>;
  static void place(const std::variant<Items...>& item, Arrangement& arrangement) {
    with_alternative(
        item, [&]<class Item>(const Item& one, auto) { RunningItem<Item, Method, Nodes>::place(one, arrangement); });
  }
  static type start(std::variant<Items...>& item, Nodes& nodes, Arrangement& arrangement, std::size_t& number) {
    std::optional<type> started;
    with_alternative(item, [&]<class Item, std::size_t i>(Item& one, std::integral_constant<std::size_t, i>) {
      started.emplace(std::in_place_index<i>, RunningItem<Item, Method, Nodes>::start(one, nodes, arrangement, number));
    });
    return std::move(*started);
  }
};

template <class Item>
inline constexpr bool is_running_part = false;
template <class E, class M, class T, class N, class R>
inline constexpr bool is_running_part<RunningPart<E, M, T, N, R>> = true;

/// The item resolves contact, and is no part.
template <class Item, class Nodes>
inline constexpr bool is_contact = item::has<item::ResolveContact, Item, Nodes, const Step, Ledger>;

/// The places of the items that satisfy a condition.
template <class... Is>
constexpr std::size_t place_of(std::size_t number, Is... is) {
  std::size_t place = 0;
  for (const bool one : {is...}) {
    if (one && number-- == 0) return place;
    ++place;
  }
  return place;
}

/// The bound of the step finds in a part what it needs.
template <class Bound, class Item>
inline constexpr bool suits = true;
template <class Bound, class E, class M, std::size_t n, class R>
  requires(Part<E, M, n, R>::flaw == Flaw::none)
inline constexpr bool suits<Bound, Part<E, M, n, R>> = Bound::template suits<E, M>;

/// The fault of an item in a run with such nodes; parts have reported their own.
template <class Item, class N>
inline constexpr item::Fault item_fault = item::fault<Item, N>();
template <class E, class M, std::size_t n, class R, class N>
inline constexpr item::Fault item_fault<Part<E, M, n, R>, N> = item::Fault::none;

/// Reports the fault of an item, which the compiler names with it.
template <class Item, class N>
struct CheckedItem {
  static constexpr item::Fault fault = item_fault<Item, N>;
  static_assert(
      fault != item::Fault::no_function,
      "strike: an item of this Scene is neither a Part nor has one of the functions begin(nodes), "
      "stable_step(dt, nodes), apply_loads(nodes, time), constrain(nodes, step, ledger), resolve_contact(nodes, step, "
      "ledger) and remove(part, alive); see strike/dynamics/item.hpp.");
  static_assert(fault != item::Fault::begin,
                "strike: begin of an item is called as begin(nodes), or as begin(nodes, parts) with a std::span<const "
                "PartFaces>, with the nodes of the run: take their type as a template parameter.");
  static_assert(
      fault != item::Fault::stable_step,
      "strike: stable_step of an item is called as stable_step(dt, nodes) or stable_step(dt), and returns a step.");
  static_assert(
      fault != item::Fault::apply_loads,
      "strike: an item adds forces in apply_loads(nodes, time), with the nodes of the run: take their type as "
      "a template parameter, and the time as a double.");
  static_assert(fault != item::Fault::power,
                "strike: power of an item is called as power(nodes), with constant nodes, and returns a double.");
  static_assert(
      fault != item::Fault::power_missing,
      "strike: an item with apply_loads needs power(nodes), the power of its forces at the present velocities: "
      "without it the balance of energies would blame the mesh.");
  static_assert(fault != item::Fault::constrain,
                "strike: an item sets velocities in constrain(nodes, step, ledger), with the nodes of the run: take "
                "their type as a template parameter.");
  static_assert(fault != item::Fault::resolve_contact,
                "strike: a contact corrects velocities in resolve_contact(nodes, step, ledger), with the nodes of the "
                "run: take their type as a template parameter.");
  static_assert(fault != item::Fault::remove,
                "strike: remove of an item is called as remove(part, alive), with the number of a part and a "
                "std::vector<bool> by its elements.");
  static_assert(fault != item::Fault::warning,
                "strike: warning of an item is a constant function, called as warning(), that returns a sentence.");
  static_assert(fault != item::Fault::history,
                "strike: the history of a load is called with the time and returns a number: write [](double t) { "
                "return ...; }, a Curve or Constant{value}.");
};
template <class Item, class N>
struct CheckedItem<std::vector<Item>, N> : CheckedItem<Item, N> {};
template <class... Items, class N>
struct CheckedItem<std::variant<Items...>, N> {
  static_assert((sizeof(CheckedItem<Items, N>) + ... + 0) > 0);
};
/// The scene can run with the method. Nothing is reported here, where the compiler only chooses.
template <class Method, class... Items>
inline constexpr bool can_run = false;
template <class... Policies, class... Items>
  requires(method_fault<Policies...>() == MethodFault::none && Scene<Items...>::sound &&
           every_kind<Items...>([]<class Kind>() { return suits<PolicyOf<StepBoundKind, Policies...>, Kind>; }))
inline constexpr bool can_run<Method<Policies...>, Items...> = every_kind<Items...>([]<class Kind>() {
  using Nodes = typename PolicyOf<NumbersKind, Policies...>::template Nodes<Scene<Items...>::nodes_turn>;
  return item_fault<Kind, Nodes> == item::Fault::none;
});

}  // namespace strike::detail
