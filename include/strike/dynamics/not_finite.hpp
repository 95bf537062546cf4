#pragma once
#include <cmath>
#include <cstddef>
#include <string>
#include <type_traits>
#include <vector>

#include <Eigen/Core>

#include <strike/dynamics/item.hpp>
#include <strike/each_of.hpp>
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

/// Finds who has made the numbers of a run wrong, when it has to be given up: each item is tried alone, on nodes at
/// rest or without forces, which then are as before.
template <class Nodes, class Items>
class Culprit {
 public:
  Culprit(Nodes& nodes, Items& items, const Step& step, double time)
      : nodes_(nodes), items_(items), step_(step), time_(time) {}

  /// A sentence on a number that is NaN, at the first place on its way through a step; empty: there is none.
  std::string of_nan() {
    if (!is_any_nan()) return {};
    for (const auto& found : {of_conditions(), of_loads(), of_elements(), of_nodes()})
      if (!found.empty()) return found;
    return {};
  }
  /// The same if a position is not finite; an element that is inverted may spoil its own state.
  std::string of_lost_position() { return has_positions() ? std::string{} : of_nan(); }
  /// A load that tells another power than that of its forces; empty: there is none.
  std::string of_power() {
    std::string found;
    each_load([&](auto& item, const std::string& name) {
      if (!found.empty()) return;
      const double power = power_of_forces(), told = item.power(std::as_const(nodes_));
      if (std::abs(power - told) > 1e-3 * std::max(std::abs(power), std::abs(told)))
        found = joined({name, " tells the power ", text(told), " where its forces have ", text(power),
                        ": correct its power(nodes)"});
    });
    return found;
  }

 private:
  using Field = std::decay_t<decltype(std::declval<Nodes&>().force())>;

  bool is_any_nan() const {
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      if (!of(nodes_.x(i)).allFinite() || of(nodes_.v(i)).hasNaN() || of(nodes_.f(i)).hasNaN()) return true;
    return !of_elements().empty() || turns_by_nan();
  }
  bool turns_by_nan() const {
    if constexpr (Nodes::nodes_turn)
      for (std::size_t i = 0; i < nodes_.size(); ++i)
        if (of(nodes_.w(i)).hasNaN() || of(nodes_.moment(i)).hasNaN()) return true;
    return false;
  }

  std::string of_conditions() {
    std::string found;
    each_item([&](auto& item, const std::string& name) {
      if constexpr (answers<item::Constrain, std::remove_reference_t<decltype(item)>, Nodes, const Step, Ledger>) {
        Ledger ledger;
        on_clear_nodes([&] {
          item::Constrain::call(item, nodes_, step_, ledger);
          if (found.empty()) found = first(name, "gives the velocity", [&](std::size_t i) { return of(nodes_.v(i)); });
        });
      }
    });
    return found;
  }
  std::string of_loads() {
    std::string found;
    if (!has_positions()) return found;
    each_load([&](auto&, const std::string& name) {
      if (found.empty()) found = first(name, "gives the force", [&](std::size_t i) { return of(nodes_.f(i)); });
      if constexpr (Nodes::nodes_turn)
        if (found.empty()) found = first(name, "gives the moment", [&](std::size_t i) { return of(nodes_.moment(i)); });
    });
    return found;
  }
  std::string of_elements() const {
    std::string found;
    if (!has_positions()) return found;
    each_item([&](auto& item, const std::string&) {
      if constexpr (requires { item.describe_nan(nodes_); }) {
        if (!found.empty()) return;
        if (const std::string element = item.describe_nan(nodes_); !element.empty())
          found = joined({"the state of ", element, " is nan: look at the formulas of its material, ",
                          class_name<std::decay_t<decltype(item.material())>>(), ", and of its element"});
      }
    });
    return found;
  }
  std::string of_nodes() const {
    const auto say = [&](const char* what, const auto& value) {
      for (std::size_t i = 0; i < nodes_.size(); ++i)
        if (const Eigen::Vector3d a = of(value(i)); a.hasNaN())
          return joined({"the ", what, " of ", describe_node(nodes_, i), " is ", text(a)});
      return std::string{};
    };
    const std::string position = say("position", [&](std::size_t i) { return nodes_.x(i); });
    if (!position.empty()) return position + ": look at the contacts and conditions of your own, which set velocities";
    const std::string force = say("force", [&](std::size_t i) { return nodes_.f(i); });
    if (!force.empty()) return force + ": look at the formulas of the elements and materials there";
    const std::string velocity = say("velocity", [&](std::size_t i) { return nodes_.v(i); });
    if (!velocity.empty()) return velocity + ": look at the contacts and conditions of your own, which set velocities";
    return "a moment or an angular velocity of a node is nan: look at the formulas of the plates and their sections";
  }

  /// f(item, its name).
  template <class F>
  void each_item(const F& f) const {
    std::size_t place = 0;
    each_of(items_, [&](auto& item) {
      f(item,
        joined({"item ", std::to_string(place++), " of the scene, ", class_name<std::decay_t<decltype(item)>>(), ","}));
    });
  }
  /// The same of each load, when its forces alone act on the nodes.
  template <class F>
  void each_load(const F& f) {
    each_item([&](auto& item, const std::string& name) {
      if constexpr (answers<item::ApplyLoads, std::remove_reference_t<decltype(item)>, Nodes, const double>) {
        without_forces([&] {
          item::ApplyLoads::call(item, nodes_, time_);
          f(item, name);
        });
      }
    });
  }
  template <class F>
  void without_forces(const F& f) {
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
  void on_clear_nodes(const F& f) {
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
  static Field clear(Field& field) {
    const Field before = field;
    for (auto& a : field) a = 0;
    return before;
  }

  template <class Value>
  std::string first(const std::string& name, const char* gives, const Value& value) const {
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      if (const Eigen::Vector3d a = value(i); !a.allFinite())
        return joined({name, " ", gives, " ", text(a), " to ", describe_node(nodes_, i), ": correct its numbers"});
    return {};
  }
  bool has_positions() const {
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      if (!of(nodes_.x(i)).allFinite()) return false;
    return true;
  }
  double power_of_forces() const {
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
  Items& items_;
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
