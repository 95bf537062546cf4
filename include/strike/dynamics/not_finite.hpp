#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <strike/dynamics/item.hpp>
#include <strike/error.hpp>
#include <strike/mesh/describe.hpp>
#include <strike/motion/ledger.hpp>
#include <strike/motion/nodes.hpp>
#include <strike/motion/step.hpp>
#include <strike/protocol.hpp>
#include <strike/range.hpp>
#include <strike/text.hpp>

namespace strike::detail {

/// "node 7 at (x, y, z)".
template <class Nodes>
[[gnu::cold]] std::string describe_node(const Nodes& nodes, std::size_t i) {
  return joined({"node ", std::to_string(i), " at ", text(Eigen::Vector3d(nodes.x(i).template cast<double>()))});
}

/// The nodes of a run that has to be given up, on which one item at a time is tried. Afterwards they are as before.
/// Nothing here depends on the other items of the scene, so that scenes share it.
template <class Nodes>
class TriedNodes {
 public:
  explicit TriedNodes(Nodes& nodes) : nodes_(nodes) {}

  [[gnu::cold]] bool have_positions() const {
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      if (!of(nodes_.x(i)).allFinite()) return false;
    return true;
  }
  [[gnu::cold]] bool have_nan() const {
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (!of(nodes_.x(i)).allFinite() || of(nodes_.v(i)).hasNaN() || of(nodes_.f(i)).hasNaN()) return true;
      if constexpr (Nodes::nodes_turn)
        if (of(nodes_.w(i)).hasNaN() || of(nodes_.moment(i)).hasNaN()) return true;
    }
    return false;
  }

  // Sentences; empty: nothing is wrong.
  /// A condition, on nodes at rest, that gives a velocity which is not finite.
  template <class Item>
  [[gnu::cold]] std::string fault_of_condition(Item& item, std::size_t place, const Step& step) {
    std::string found;
    Ledger ledger;
    on_clear_nodes([&] {
      item::Constrain::call(item, nodes_, step, ledger);
      found = first(name<Item>(place), "gives the velocity", &Nodes::v);
    });
    return found;
  }
  /// A load that gives a force which is not finite.
  template <class Item>
  [[gnu::cold]] std::string fault_of_load(Item& item, std::size_t place, double time) {
    std::string found;
    without_forces([&] {
      item::ApplyLoads::call(item, nodes_, time);
      found = first(name<Item>(place), "gives the force", &Nodes::f);
      if constexpr (Nodes::nodes_turn)
        if (found.empty()) found = first(name<Item>(place), "gives the moment", &Nodes::moment);
    });
    return found;
  }
  /// A load that tells another power than that of its forces.
  template <class Item>
  [[gnu::cold]] std::string fault_of_power(Item& item, std::size_t place, double time) {
    std::string found;
    without_forces([&] {
      item::ApplyLoads::call(item, nodes_, time);
      found = false_power(name<Item>(place), item.power(std::as_const(nodes_)));
    });
    return found;
  }
  /// A part with an element whose state is NaN.
  template <class Item>
  [[gnu::cold]] std::string fault_of_elements(const Item& item) const {
    const std::string element = item.describe_nan(nodes_);
    if (element.empty()) return {};
    return joined({"the state of ", element, " is nan: look at the formulas of its material, ",
                   class_name<std::decay_t<decltype(item.material())>>(), ", and of its element"});
  }
  /// The nodes' own numbers.
  [[gnu::cold]] std::string fault() const {
    const std::string position = first_nan("position", &Nodes::x);
    if (!position.empty()) return position + ": look at the contacts and conditions of your own, which set velocities";
    const std::string force = first_nan("force", &Nodes::f);
    if (!force.empty()) return force + ": look at the formulas of the elements and materials there";
    const std::string velocity = first_nan("velocity", &Nodes::v);
    if (!velocity.empty()) return velocity + ": look at the contacts and conditions of your own, which set velocities";
    return "a moment or an angular velocity of a node is nan: look at the formulas of the plates and their sections";
  }

 private:
  using Field = std::decay_t<decltype(std::declval<Nodes&>().force())>;
  using Value = const typename Nodes::Vector (Nodes::*)(std::size_t) const;

  template <class Item>
  [[gnu::cold]] static std::string name(std::size_t place) {
    return joined({"item ", std::to_string(place), " of the scene, ", class_name<Item>(), ","});
  }
  template <class F>
  [[gnu::cold]] void without_forces(const F& f) {
    const Field force = clear(nodes_.force());
    if constexpr (Nodes::nodes_turn) {
      const Field moment = clear(nodes_.moment());
      f();
      nodes_.moment() = moment;
    } else {
      f();
    }
    nodes_.force() = force;
  }
  template <class F>
  [[gnu::cold]] void on_clear_nodes(const F& f) {
    without_forces([&] {
      const Field velocity = clear(nodes_.velocity());
      if constexpr (Nodes::nodes_turn) {
        const Field angular_velocity = clear(nodes_.angular_velocity());
        f();
        nodes_.angular_velocity() = angular_velocity;
      } else {
        f();
      }
      nodes_.velocity() = velocity;
    });
  }
  [[gnu::cold]] static Field clear(Field& field) {
    const Field before = field;
    for (auto& a : field) a = 0;
    return before;
  }

  [[gnu::cold]] std::string first(const std::string& name, const char* gives, Value value) const {
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      if (const Eigen::Vector3d a = of((nodes_.*value)(i)); !a.allFinite())
        return joined({name, " ", gives, " ", text(a), " to ", describe_node(nodes_, i), ": correct its numbers"});
    return {};
  }
  [[gnu::cold]] std::string first_nan(const char* what, Value value) const {
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      if (const Eigen::Vector3d a = of((nodes_.*value)(i)); a.hasNaN())
        return joined({"the ", what, " of ", describe_node(nodes_, i), " is ", text(a)});
    return {};
  }
  [[gnu::cold]] std::string false_power(const std::string& name, double told) const {
    const double power = power_of_forces();
    if (!(std::abs(power - told) > 1e-3 * std::max(std::abs(power), std::abs(told)))) return {};
    return joined(
        {name, " tells the power ", text(told), " where its forces have ", text(power), ": correct its power(nodes)"});
  }
  [[gnu::cold]] double power_of_forces() const {
    double power = 0;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      power += of(nodes_.f(i)).dot(of(nodes_.v(i)));
      if constexpr (Nodes::nodes_turn) power += of(nodes_.moment(i)).dot(of(nodes_.w(i)));
    }
    return power;
  }
  template <class Vector>
  static Eigen::Vector3d of(const Vector& a) {
    return a.template cast<double>();
  }

  Nodes& nodes_;
};

/// Finds who has made the numbers of a run wrong, when it has to be given up: each of its items at work is tried alone.
template <class Nodes, class Items>
class Culprit {
 public:
  Culprit(Nodes& nodes, const Items& items, const Step& step, double time)
      : nodes_(nodes), items_(items), step_(step), time_(time) {}

  /// A sentence on a number that is NaN, at the first place on its way through a step; empty: there is none.
  [[gnu::cold]] std::string of_nan() {
    const std::string of_elements = nodes_.have_positions() ? first([&](const auto& one) {
      return one.can->fault_of_elements ? one.can->fault_of_elements(one.item, nodes_) : "";
    })
                                                            : "";
    if (of_elements.empty() && !nodes_.have_nan()) return {};
    std::string found = first([&](const auto& one) {
      return one.can->fault_of_condition ? one.can->fault_of_condition(one.item, nodes_, one.place, step_) : "";
    });
    if (found.empty() && nodes_.have_positions())
      found = first([&](const auto& one) {
        return one.can->fault_of_load ? one.can->fault_of_load(one.item, nodes_, one.place, time_) : "";
      });
    if (found.empty()) found = of_elements;
    return found.empty() ? nodes_.fault() : found;
  }
  /// The same if a position is not finite; an element that is inverted may spoil its own state.
  [[gnu::cold]] std::string of_lost_position() { return nodes_.have_positions() ? std::string{} : of_nan(); }
  /// A load that tells another power than that of its forces; empty: there is none.
  [[gnu::cold]] std::string of_power() {
    return first([&](const auto& one) {
      return one.can->fault_of_power ? one.can->fault_of_power(one.item, nodes_, one.place, time_) : "";
    });
  }

 private:
  /// The first sentence f(item at work) that is not empty.
  template <class F>
  [[gnu::cold]] std::string first(const F& f) {
    for (const auto& one : items_)
      if (std::string found = f(one); !found.empty()) return found;
    return {};
  }

  TriedNodes<Nodes> nodes_;
  const Items& items_;
  const Step& step_;
  double time_;
};

/// Error: a node whose velocity at the start is not finite.
template <class Nodes>
[[gnu::cold]] void check_start(const Nodes& nodes) {
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (const Eigen::Vector3d v = nodes.v(i).template cast<double>(); !v.allFinite())
      throw Error(joined({"strike: the velocity of ", describe_node(nodes, i), " is ", text(v),
                          " at the start; correct the item that gives it."}));
}

}  // namespace strike::detail
