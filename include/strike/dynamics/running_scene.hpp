#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <span>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <strike/dynamics/any_part.hpp>
#include <strike/dynamics/arrangement.hpp>
#include <strike/dynamics/faces_of_part.hpp>
#include <strike/dynamics/ill_formed_run.hpp>
#include <strike/dynamics/not_finite.hpp>
#include <strike/dynamics/part_checks.hpp>
#include <strike/dynamics/plate_stretch.hpp>
#include <strike/dynamics/running_item.hpp>
#include <strike/dynamics/scene.hpp>
#include <strike/error.hpp>
#include <strike/mesh/describe.hpp>
#include <strike/mesh/part_faces.hpp>
#include <strike/motion/central_differences.hpp>
#include <strike/text.hpp>

namespace strike::detail {

/// Error: a node without mass.
template <class Nodes>
[[gnu::cold]] void check_masses(const Nodes& nodes) {
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (!(nodes.mass(i) > 0))
      throw Error(joined({"strike: node ", std::to_string(i), " at ", text(nodes.x(i).template cast<double>()),
                          " has no mass, for it belongs to no element; remove it."}));
}

/// Gives nodes that no element turns a moment of inertia.
template <class Nodes>
void complete_inertia(Nodes& nodes) {
  if constexpr (Nodes::nodes_turn)
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (!(nodes.inertia(i) > 0)) nodes.add_inertia(i, nodes.mass(i));
}

/// sum of m spacing^2/2, of nodes that move by the largest spacing of the numbers [energy time^2].
template <class Nodes>
double moved_by_rounding(const Nodes& nodes) {
  double mass = 0, spacing = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    mass += nodes.mass(i);
    spacing = std::max(spacing, nodes.resolution(i));
  }
  return 0.5 * mass * spacing * spacing;
}

/// A scene at work: its nodes in the numbers of a run and its items, and the ways to reach them.
template <class Method, class... Items>
class RunningScene {
 public:
  using Numbers = typename Method::Numbers;
  using Nodes = typename Numbers::template Nodes<Scene<Items...>::nodes_turn>;

  Eigen::Vector3d momentum() const { return detail::momentum(nodes_); }

  const Nodes& nodes() const { return nodes_; }
  Nodes& nodes() { return nodes_; }
  /// By the numbers of the nodes as given.
  std::vector<Eigen::Vector3d> positions() const {
    return of_nodes([&](std::size_t i) { return nodes_.x(i); });
  }
  std::vector<Eigen::Vector3d> velocities() const {
    return of_nodes([&](std::size_t i) { return nodes_.v(i); });
  }

  /// The items at work, in the order of the scene: `auto& [bar, wall] = run.items()`.
  auto& items() { return items_; }
  const auto& items() const { return items_; }
  /// Item i of the scene at work: a RunningPart, a load, a contact.
  template <std::size_t i>
  auto& item() {
    return chosen<i, sizeof...(Items)>(*this);
  }
  template <std::size_t i>
  const auto& item() const {
    return chosen<i, sizeof...(Items)>(*this);
  }
  /// Part i of the scene, counted among the parts from 0.
  template <std::size_t i>
  auto& part() {
    return chosen<place_of(i, is_part<Items>...), sizeof...(Items)>(*this);
  }
  template <std::size_t i>
  const auto& part() const {
    return chosen<place_of(i, is_part<Items>...), sizeof...(Items)>(*this);
  }
  /// f(part) for each RunningPart.
  template <class F>
  void each_part(const F& f) const {
    each([&](const auto& item) {
      if constexpr (is_running_part<std::remove_cvref_t<decltype(item)>>) f(item);
    });
  }
  /// f(body) for each RigidBody.
  template <class F>
  void each_body(const F& f) const {
    each(of_bodies(f));
  }
  /// Contact i of the scene, counted among the items that resolve contact from 0, walls and ties among them.
  template <std::size_t i>
  auto& contact() {
    return chosen<place_of(i, is_contact<Items, Nodes>...), sizeof...(Items)>(*this);
  }
  template <std::size_t i>
  const auto& contact() const {
    return chosen<place_of(i, is_contact<Items, Nodes>...), sizeof...(Items)>(*this);
  }

  /// Sentences that the user should read before the results.
  std::vector<std::string> warnings() const {
    std::vector<std::string> all;
    each([&](const auto& item) {
      if constexpr (requires { item.warning(); })
        if (std::string warning = item.warning(); !warning.empty()) all.push_back(std::move(warning));
    });
    std::size_t clouds = 0;
    each_part([&](const auto& part) { clouds += std::remove_cvref_t<decltype(part)>::sees_neighbours; });
    if (clouds > 1)
      all.push_back("Particles of different parts do not touch each other; those that shall meet belong in one part.");
    for (std::string& sentence : stretch_warnings()) all.push_back(std::move(sentence));
    return all;
  }

 protected:
  template <class Item>
  static constexpr bool is_debris = requires { requires std::remove_cvref_t<Item>::is_born; };
  using RunningItems = std::tuple<typename RunningItem<Items, Method, Nodes>::type...>;

  RunningScene(Scene<Items...>& scene, Arrangement arrangement)
      : nodes_(scene.nodes, std::move(arrangement.nodes)),
        items_(start(std::move(scene.items), nodes_, std::move(arrangement.cells))) {}

  template <class F>
  static auto of_bodies(const F& f) {
    return [&](auto& item) {
      if constexpr (requires { requires std::remove_cvref_t<decltype(item)>::is_rigid_body; }) f(item);
    };
  }
  template <class F>
  void each_body(const F& f) {
    each(of_bodies(f));
  }
  template <class F>
  void each(const F& f) {
    each_item(items_, f);
  }
  template <class F>
  void each(const F& f) const {
    each_item(items_, f);
  }
  /// The sizes of its lists and the numbers of its alternatives, in their order.
  std::vector<std::size_t> chosen_late() const {
    std::vector<std::size_t> all;
    each_of(items_, [&](const auto& item) { add_chosen(item, all); });
    return all;
  }
  template <class F>
  std::vector<Eigen::Vector3d> of_nodes(const F& f) const {
    std::vector<Eigen::Vector3d> values(nodes_.size());
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = f(i).template cast<double>();
    return values;
  }

  /// Errors: those of the items; a velocity that is not finite.
  void begin_items() {
    std::vector<PartFaces> parts;
    if constexpr (any_kind<Items...>([]<class Kind>() { return item::Begin::takes_parts<Kind, Nodes>; }))
      each_part([&](const auto& part) { parts.push_back(faces_of(part, nodes_)); });
    each_body([&](const auto& body) { body.add_faces(parts); });
    begin_debris();
    const std::span<const PartFaces> all(parts);
    each([&](auto& item) { call_if_present<item::Begin>(item, nodes_, all); });
    check_start(nodes_);
    each_body([&](auto& body) { body.start_body(nodes_); });
  }
  /// Makes the rigid bodies, whose nodes get their masses.
  void add_bodies() {
    each_body([&](auto& body) { body.add_body(nodes_); });
  }
  /// After contacts have pushed them.
  void move_bodies(const Step& step, Ledger& ledger) {
    each_body([&](auto& body) { body.move_body(nodes_, step, ledger); });
  }
  /// Errors: debris of a part that is not before it, that has debris already, or whose elements cannot become
  /// particles.
  void begin_debris() {
    std::vector<std::size_t> sources;
    each([&](auto& part) {
      if constexpr (is_debris<decltype(part)>) {
        const std::size_t of = part.source();
        const auto refuse = [&](const char* why) {
          throw Error(joined({"strike: part ", std::to_string(part.number()), " is Debris of part ", std::to_string(of),
                              ", which ", why}));
        };
        if (of >= part.number()) refuse("is not before it in the scene; put it there.");
        if (std::count(sources.begin(), sources.end(), of) > 0) refuse("has debris already; give a part one debris.");
        sources.push_back(of);
        each_part([&](const auto& source) {
          if (source.number() == of) part.follow(source, nodes_);
        });
      }
    });
  }
  /// Gives debris the elements that its source has lost in the step dt.
  template <class P>
  void take_debris(P& part, double dt, Ledger& ledger) {
    if constexpr (is_debris<P>)
      each_part([&](const auto& source) {
        if (source.number() == part.source()) part.take(source, nodes_, dt, ledger);
      });
  }
  /// Tells the items which elements the last step has deleted.
  void remove_deleted() {
    each_part([&](const auto& part) {
      if (part.newly_deleted() == 0) return;
      const std::vector<bool> alive = part.alive();
      each([&](auto& item) { call_if_present<item::Remove>(item, part.number(), alive); });
    });
  }
  /// The internal energy of its parts at rest.
  double stored_energy() const {
    double sum = 0;
    each_part([&](const auto& part) { sum += part.stored_energy(); });
    return sum;
  }
  /// At most one sentence on numbers of different units, with the number of steps to the end of the run.
  [[gnu::cold]] void add_unit_slip(std::vector<std::string>& warnings, double steps) const {
    std::string slip;
    each_part([&](const auto& part) {
      if (slip.empty()) slip = unit_slip(part.number(), wave_speed(part.material()), steps);
    });
    if (!slip.empty()) warnings.push_back(std::move(slip));
  }
  [[gnu::cold]] void print(const std::vector<std::string>& warnings) {
    prints_warnings_ = true;
    for (const std::string& warning : warnings) std::fprintf(stderr, "strike: warning: %s\n", warning.c_str());
  }
  /// Prints those on plates that have stretched in the run, once, if warnings are printed.
  void print_stretch() {
    if (!prints_warnings_ || has_told_stretch_) return;
    const std::vector<std::string> warnings = stretch_warnings();
    has_told_stretch_ = !warnings.empty();
    print(warnings);
  }
  /// An element of a part with its place, for a message.
  [[gnu::cold]] std::string describe(const StableStep& stable) const {
    std::string text;
    each_part([&](const auto& part) {
      if (part.number() == stable.part) text = part.describe(nodes_, stable.element);
    });
    return text;
  }

  Nodes nodes_;
  RunningItems items_;

 private:
  std::vector<std::string> stretch_warnings() const {
    std::vector<std::string> all;
    each_part([&](const auto& part) {
      if (std::string sentence = stretch_warning(part, nodes_); !sentence.empty()) all.push_back(std::move(sentence));
    });
    return all;
  }
  static RunningItems start(std::tuple<Items...> items, Nodes& nodes, std::vector<std::vector<Index>> orders) {
    std::size_t part = 0;
    return std::apply(
        [&](auto&... item) {
          return RunningItems{RunningItem<Items, Method, Nodes>::start(std::move(item), nodes, orders, part)...};
        },
        items);
  }

  template <std::size_t place, std::size_t count, class Run>
  static auto& chosen(Run& run) {
    static_assert(place < count,
                  "strike: the scene of this run has no such item: item<i>() counts all items from 0, part<i>() the "
                  "parts, contact<i>() the contacts.");
    if constexpr (place < count)
      return std::get<place>(run.items_);
    else
      return ill_formed_item;
  }

  bool prints_warnings_ = false, has_told_stretch_ = false;
};

}  // namespace strike::detail
