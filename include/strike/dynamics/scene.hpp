#pragma once
#include <concepts>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <strike/dynamics/any_part.hpp>
#include <strike/dynamics/item.hpp>
#include <strike/dynamics/part.hpp>
#include <strike/motion/nodes.hpp>

namespace strike {

namespace detail {

template <class Item>
inline constexpr bool is_part = false;
template <class E, class M, std::size_t n, class R>
inline constexpr bool is_part<Part<E, M, n, R>> = true;

template <class Item>
inline constexpr bool is_rigid_body = requires { requires Item::is_rigid_body; };

/// The item gives nodes masses: a part or a rigid body.
template <class Item>
inline constexpr bool has_mass = is_part<Item> || is_rigid_body<Item>;

template <class Item>
inline constexpr bool turns_nodes_of = false;
template <class E, class M, std::size_t n, class R>
  requires(Part<E, M, n, R>::flaw == Flaw::none)
inline constexpr bool turns_nodes_of<Part<E, M, n, R>> = turns_nodes<E>();

/// The item can be put into a scene: a part without a fault, or a class. Its functions are looked at when the numbers
/// of the run are known.
template <class Item>
constexpr bool is_sound() {
  if constexpr (is_part<Item>)
    return Item::flaw == Flaw::none;
  else
    return std::is_class_v<Item>;
}

/// An argument that stands where the positions of the nodes belong.
template <class Argument>
struct NotPositions {};

}  // namespace detail

/// A scene: the positions of its nodes, and the items that act on them, parts, loads and contacts in any order. The
/// functions that an item may have are listed in strike/dynamics/item.hpp; items known only when the run starts stand
/// in a std::vector, or as AnyPart.
template <class... Items>
struct Scene {
  static_assert(detail::every_kind<Items...>([]<class Kind>() { return std::is_class_v<Kind>; }),
                "strike: one of the items in this Scene is a number or a pointer: a Scene takes its nodes, then parts, "
                "loads, supports and contacts.");
  static constexpr bool has_mass = detail::any_kind<Items...>([]<class Kind>() { return detail::has_mass<Kind>; });
  static_assert(has_mass, "strike: a Scene needs at least one Part or RigidBody.");
  /// Some of its elements turn their nodes.
  static constexpr bool nodes_turn =
      detail::any_kind<Items...>([]<class Kind>() { return detail::turns_nodes_of<Kind>; });
  /// No static_assert has reported any of its items.
  static constexpr bool sound =
      detail::every_kind<Items...>([]<class Kind>() { return detail::is_sound<Kind>(); }) && has_mass;

  std::vector<Eigen::Vector3d> nodes;
  std::tuple<Items...> items;

  explicit Scene(std::vector<Eigen::Vector3d> positions, Items... pieces)
      : nodes(std::move(positions)), items(std::move(pieces)...) {}
};

/// Fallback for a scene without positions in the first place: its static_assert is the one message.
template <class Argument, class... Items>
struct Scene<detail::NotPositions<Argument>, Items...> {
  static_assert(!std::same_as<Argument, Argument>,
                "strike: the first piece of a Scene is the positions of its nodes, such as bar.nodes of the mesh bar.");
  static constexpr bool nodes_turn = false, sound = false;
  explicit Scene(const auto&...) {}
};
template <class... Items>
Scene(std::vector<Eigen::Vector3d>, Items...) -> Scene<Items...>;
template <class Argument, class... Items>
  requires(!std::convertible_to<Argument, std::vector<Eigen::Vector3d>>)
Scene(Argument, Items...) -> Scene<detail::NotPositions<Argument>, Items...>;

}  // namespace strike
