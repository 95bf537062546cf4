#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

#include <Eigen/Core>

#include <strike/dynamics/any_part.hpp>
#include <strike/dynamics/explicit_options.hpp>
#include <strike/dynamics/part.hpp>
#include <strike/dynamics/running_item.hpp>
#include <strike/dynamics/scene.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/motion/ledger.hpp>

namespace strike::detail {

/// A part or contact of an ill-formed run: has the functions of any, so that no second message follows the first.
struct IllFormedItem {
  template <class F>
  std::vector<double> field(F) const {
    return {};
  }
  template <class F>
  std::vector<double> field(std::size_t, F) const {
    return {};
  }
  std::size_t number() const { return 0; }
  std::size_t size() const { return 0; }
  std::size_t deleted() const { return 0; }
  std::size_t newly_deleted() const { return 0; }
  std::vector<bool> alive() const { return {}; }
  double added_mass() const { return 0; }
  double stored_energy() const { return 0; }
  std::string warning() const { return {}; }
  std::string describe(const auto&, std::size_t) const { return {}; }
  Eigen::Vector3d force() const { return Eigen::Vector3d::Zero(); }
  std::vector<Eigen::Vector3d> forces(std::size_t) const { return {}; }
  Eigen::Vector3d impulse() const { return Eigen::Vector3d::Zero(); }
  double penetration() const { return 0; }
};

inline IllFormedItem ill_formed_item;

/// Nodes of an ill-formed run.
struct IllFormedNodes {
  std::size_t size() const { return 0; }
  Eigen::Vector3d x(std::size_t) const { return Eigen::Vector3d::Zero(); }
  Eigen::Vector3d v(std::size_t) const { return Eigen::Vector3d::Zero(); }
  Eigen::Vector3d f(std::size_t) const { return Eigen::Vector3d::Zero(); }
  Eigen::Vector3d w(std::size_t) const { return Eigen::Vector3d::Zero(); }
  double mass(std::size_t) const { return 0; }
  void set_position(std::size_t, const Eigen::Vector3d&) {}
  void set_velocity(std::size_t, const Eigen::Vector3d&) {}
};

/// The interface of a run, for one that a static_assert has reported: nothing follows that message.
template <std::size_t count>
class IllFormedRun {
 public:
  explicit IllFormedRun(const auto&...) {}

  void step() {}
  void until(auto&&...) {}
  double time() const { return 0; }
  double end() const { return 0; }
  std::size_t steps() const { return 0; }
  double dt() const { return 0; }
  StableStep stable_step() const { return {}; }
  int damping() const { return 0; }
  int cycle() const { return 0; }
  int step_bound() const { return 0; }
  std::vector<std::string> warnings() const { return {}; }
  Energy energy() const { return {}; }
  Eigen::Vector3d momentum() const { return Eigen::Vector3d::Zero(); }
  IllFormedNodes& nodes() { return nodes_; }
  const IllFormedNodes& nodes() const { return nodes_; }
  std::vector<Eigen::Vector3d> positions() const { return {}; }
  std::vector<Eigen::Vector3d> velocities() const { return {}; }
  double imbalance() const { return 1; }
  void each_part(const auto&) const {}
  void each_body(const auto&) const {}
  template <std::size_t>
  IllFormedItem& item() {
    return items_[0];
  }
  template <std::size_t>
  const IllFormedItem& item() const {
    return items_[0];
  }
  template <std::size_t>
  IllFormedItem& part() {
    return items_[0];
  }
  template <std::size_t>
  const IllFormedItem& part() const {
    return items_[0];
  }
  template <std::size_t>
  IllFormedItem& contact() {
    return items_[0];
  }
  template <std::size_t>
  const IllFormedItem& contact() const {
    return items_[0];
  }
  auto& items() { return items_; }
  const auto& items() const { return items_; }

 private:
  IllFormedNodes nodes_;
  std::array<IllFormedItem, count> items_;
};

}  // namespace strike::detail

namespace strike {

template <class Method, class... Items>
class Explicit;

/// Fallback for a scene or method that cannot run: the static_asserts of its pieces are the one message.
template <class Method, class... Items>
  requires(!detail::can_run<Method, Items...>)
class Explicit<Method, Items...> : public detail::IllFormedRun<sizeof...(Items)> {
  static_assert(detail::every_kind<Items...>([]<class Kind>() { return detail::suits<typename Method::Bound, Kind>; }),
                "strike: an element of this Scene lacks what the bound of the step needs: for GlobalStep{} give it "
                "resistance(state, material, x, v, dt), as Hex8 has it, or leave the step to ElementStep{}.");
  template <class Item>
  using Checked =
      std::conditional_t<Scene<Items...>::sound,
                         detail::CheckedItem<Item, typename Method::template Nodes<Scene<Items...>::nodes_turn>>,
                         Item*>;
  static_assert((sizeof(Checked<Items>) + ... + 0) > 0);

 public:
  explicit Explicit(const auto&...) {}
  explicit Explicit(const Scene<Items...>&, const ExplicitOptions&, const auto&...) {}
};

}  // namespace strike
