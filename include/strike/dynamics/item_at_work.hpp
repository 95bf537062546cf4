#pragma once
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include <strike/dynamics/faces_of_part.hpp>
#include <strike/dynamics/item.hpp>
#include <strike/dynamics/not_finite.hpp>
#include <strike/dynamics/part_checks.hpp>
#include <strike/dynamics/plate_stretch.hpp>
#include <strike/dynamics/running_item.hpp>
#include <strike/mesh/part_faces.hpp>
#include <strike/motion/ledger.hpp>
#include <strike/motion/step.hpp>
#include <strike/protocol.hpp>

namespace strike::detail {

/// The functions of an item at work, which know its type and are given its address; null: it has no such function. A
/// run that asks so knows nothing of its scene: the compiler makes it once for all scenes, and what is here once for
/// each type of an item. A step calls them, the elements' loops do not.
template <class Method, class Nodes>
struct ItemFunctions {
  using Execution = typename Method::Execution;
  using Cycle = typename Method::Cycle::template Running<Nodes>;
  using Damping = typename Method::Damping::Running;

  // Those of strike/dynamics/item.hpp.
  void (*begin)(void*, Nodes&, std::span<const PartFaces>) = nullptr;
  bool takes_parts = false;  // begin does
  double (*stable_step)(void*, double, const Nodes&) = nullptr;
  void (*apply_loads)(void*, Nodes&, double) = nullptr;
  double (*power)(void*, const Nodes&) = nullptr;
  void (*constrain)(void*, Nodes&, const Step&, Ledger&) = nullptr;
  void (*resolve_contact)(void*, Nodes&, const Step&, Ledger&, const Execution&) = nullptr;
  void (*remove)(void*, std::size_t, const std::vector<bool>&) = nullptr;
  std::string (*warning)(const void*) = nullptr;

  // Of an item that acts on nodes in a step: those that it names; null: it may name any.
  std::vector<Index> (*nodes_named)(const void*) = nullptr;
  void (*find_places)(void*, const Nodes&) = nullptr;

  // Of a RigidBody.
  void (*add_body)(void*, Nodes&) = nullptr;
  void (*start_body)(void*, Nodes&) = nullptr;
  void (*move_body)(void*, Nodes&, const Step&, Ledger&) = nullptr;
  void (*add_faces)(const void*, std::vector<PartFaces>&) = nullptr;

  // Of a RunningPart, all of them.
  bool is_part = false, sees_neighbours = false;
  std::size_t (*number)(const void*) = nullptr;
  StableStep (*compute_forces)(void*, Cycle&, Nodes&, double, Ledger&, const Execution&) = nullptr;
  std::size_t (*newly_deleted)(const void*) = nullptr;
  std::vector<bool> (*alive)(const void*) = nullptr;
  double (*stored_energy)(const void*) = nullptr;
  double (*wave_speed)(const void*) = nullptr;
  PartFaces (*faces)(const void*, const Nodes&) = nullptr;
  std::string (*describe)(const void*, const Nodes&, std::size_t) = nullptr;
  std::string (*stretch_warning)(const void*, const Nodes&) = nullptr;
  void (*add_damping_warning)(const void*, const Damping&, std::vector<std::string>&) = nullptr;

  // Of one on several processes.
  const Deal& (*deal)(const void*) = nullptr;
  bool (*can_share_nodes)(const void*) = nullptr;
  void (*add_needs)(const void*, NodeShare&) = nullptr;
  void (*share_nodes)(void*, const std::shared_ptr<const NodeShare>&, std::vector<Index>&) = nullptr;

  // Sentences of TriedNodes on an item, some with its place in the scene.
  std::string (*fault_of_elements)(const void*, const TriedNodes<Nodes>&) = nullptr;
  std::string (*fault_of_condition)(void*, TriedNodes<Nodes>&, std::size_t, const Step&) = nullptr;
  std::string (*fault_of_load)(void*, TriedNodes<Nodes>&, std::size_t, double) = nullptr;
  std::string (*fault_of_power)(void*, TriedNodes<Nodes>&, std::size_t, double) = nullptr;

  // Asked at run time: a function's address is no constant to g++ under -fsanitize=undefined.
  bool acts_on_nodes() const { return stable_step || apply_loads || constrain || resolve_contact || move_body; }
};

/// The functions of one type of item.
template <class Item, class Method, class Nodes>
struct FunctionsOf {
  using All = ItemFunctions<Method, Nodes>;
  using Execution = typename All::Execution;

  static void begin(void* item, Nodes& nodes, std::span<const PartFaces> parts) {
    item::Begin::call(at(item), nodes, parts);
  }
  static double stable_step(void* item, double dt, const Nodes& nodes) {
    return item::StableStep::call(at(item), dt, nodes);
  }
  static void apply_loads(void* item, Nodes& nodes, double time) { item::ApplyLoads::call(at(item), nodes, time); }
  static double power(void* item, const Nodes& nodes) { return item::Power::call(at(item), nodes); }
  static void constrain(void* item, Nodes& nodes, const Step& step, Ledger& ledger) {
    item::Constrain::call(at(item), nodes, step, ledger);
  }
  static void resolve_contact(void* item, Nodes& nodes, const Step& step, Ledger& ledger, const Execution& execution) {
    item::ResolveContact::call(at(item), nodes, step, ledger, execution);
  }
  static void remove(void* item, std::size_t part, const std::vector<bool>& alive) {
    item::Remove::call(at(item), part, alive);
  }
  static std::string warning(const void* item) { return at(item).warning(); }

  static std::vector<Index> nodes_named(const void* item) { return at(item).nodes_named(); }
  static void find_places(void* item, const Nodes& nodes) { at(item).find_places(nodes); }
  static const Deal& deal(const void* item) { return at(item).deal(); }
  static bool can_share_nodes(const void* item) { return at(item).can_share_nodes(); }
  static void add_needs(const void* item, NodeShare& share) { at(item).add_needs(share); }
  static void share_nodes(void* item, const std::shared_ptr<const NodeShare>& share, std::vector<Index>& ghosts) {
    at(item).share_nodes(share, ghosts);
  }

  static void add_body(void* item, Nodes& nodes) { at(item).add_body(nodes); }
  static void start_body(void* item, Nodes& nodes) { at(item).start_body(nodes); }
  static void move_body(void* item, Nodes& nodes, const Step& step, Ledger& ledger) {
    at(item).move_body(nodes, step, ledger);
  }
  static void add_faces(const void* item, std::vector<PartFaces>& parts) { at(item).add_faces(parts); }

  static std::size_t number(const void* item) { return at(item).number(); }
  static StableStep compute_forces(void* item, typename All::Cycle& cycle, Nodes& nodes, double dt, Ledger& ledger,
                                   const Execution& execution) {
    return cycle.compute_forces(at(item), nodes, dt, ledger, execution);
  }
  static std::size_t newly_deleted(const void* item) { return at(item).newly_deleted(); }
  static std::vector<bool> alive(const void* item) { return at(item).alive(); }
  static double stored_energy(const void* item) { return at(item).stored_energy(); }
  static double wave_speed(const void* item) { return detail::wave_speed(at(item).material()); }
  static PartFaces faces(const void* item, const Nodes& nodes) { return faces_of(at(item), nodes); }
  static std::string describe(const void* item, const Nodes& nodes, std::size_t e) {
    return at(item).describe(nodes, e);
  }
  static std::string stretch_warning(const void* item, const Nodes& nodes) {
    return detail::stretch_warning(at(item), nodes);
  }
  static void add_damping_warning(const void* item, const typename All::Damping& damping,
                                  std::vector<std::string>& warnings) {
    damping.add_warning(at(item), warnings);
  }

  static std::string fault_of_elements(const void* item, const TriedNodes<Nodes>& nodes) {
    return nodes.fault_of_elements(at(item));
  }
  static std::string fault_of_condition(void* item, TriedNodes<Nodes>& nodes, std::size_t place, const Step& step) {
    return nodes.fault_of_condition(at(item), place, step);
  }
  static std::string fault_of_load(void* item, TriedNodes<Nodes>& nodes, std::size_t place, double time) {
    return nodes.fault_of_load(at(item), place, time);
  }
  static std::string fault_of_power(void* item, TriedNodes<Nodes>& nodes, std::size_t place, double time) {
    return nodes.fault_of_power(at(item), place, time);
  }

  static constexpr All make() {
    All all;
    if constexpr (requires(const Item& item) { item.warning(); }) all.warning = &warning;
    if constexpr (is_running_part<Item>) {
      all.is_part = true, all.sees_neighbours = Item::sees_neighbours;
      all.number = &number, all.compute_forces = &compute_forces;
      all.newly_deleted = &newly_deleted, all.alive = &alive;
      all.stored_energy = &stored_energy, all.wave_speed = &wave_speed, all.faces = &faces;
      all.describe = &describe, all.stretch_warning = &stretch_warning;
      all.add_damping_warning = &add_damping_warning, all.fault_of_elements = &fault_of_elements;
      if constexpr (!std::is_same_v<typename Nodes::Ranks, Alone>) {
        all.deal = &deal, all.can_share_nodes = &can_share_nodes;
        all.add_needs = &add_needs, all.share_nodes = &share_nodes;
      }
    } else {
      if constexpr (answers<item::Begin, Item, Nodes, const std::span<const PartFaces>>) all.begin = &begin;
      all.takes_parts = item::Begin::takes_parts<Item, Nodes>;
      if constexpr (answers<item::StableStep, Item, double, const Nodes>) all.stable_step = &stable_step;
      if constexpr (answers<item::ApplyLoads, Item, Nodes, const double>) {
        all.apply_loads = &apply_loads, all.fault_of_load = &fault_of_load, all.fault_of_power = &fault_of_power;
      }
      if constexpr (answers<item::Power, Item, const Nodes>) all.power = &power;
      if constexpr (answers<item::Constrain, Item, Nodes, const Step, Ledger>) {
        all.constrain = &constrain, all.fault_of_condition = &fault_of_condition;
      }
      if constexpr (answers<item::ResolveContact, Item, Nodes, const Step, Ledger, const Execution>)
        all.resolve_contact = &resolve_contact;
      if constexpr (answers<item::Remove, Item, const std::size_t, const std::vector<bool>>) all.remove = &remove;
      if constexpr (is_rigid_body<Item>) {
        all.add_body = &add_body, all.start_body = &start_body, all.move_body = &move_body;
        all.add_faces = &add_faces;
      }
      if constexpr (requires(const Item& item) { item.nodes_named(); }) all.nodes_named = &nodes_named;
      if constexpr (requires(Item& item, const Nodes& nodes) { item.find_places(nodes); })
        all.find_places = &find_places;
    }
    return all;
  }

 private:
  static Item& at(void* item) { return *static_cast<Item*>(item); }
  static const Item& at(const void* item) { return *static_cast<const Item*>(item); }
};

template <class Item, class Method, class Nodes>
inline constexpr ItemFunctions<Method, Nodes> functions_of = FunctionsOf<Item, Method, Nodes>::make();

/// An item at work, whatever its type.
template <class Method, class Nodes>
struct ItemAtWork {
  void* item;
  std::size_t place;  ///< in the scene, with those of its list
  const ItemFunctions<Method, Nodes>* can;
};

}  // namespace strike::detail
