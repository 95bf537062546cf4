#pragma once
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <strike/each_of.hpp>

namespace strike {

/// A part of which the run knows only when it starts which of some it is:
///   using BarPart = AnyPart<PartOf<Hex8<>, Elastic>, PartOf<Tet4<>, Elastic>>;
///   std::vector<BarPart> parts;
///   parts.push_back(Part{Hex8{}, steel, bar.hexahedra});
///   Explicit run{Scene{bar.nodes, parts, RigidWall{...}}};
/// Any item of a scene may be such a std::variant of items, or a std::vector of items or of variants: a run treats what
/// is in them, in its order, as if it stood in the scene itself, to the bit. A step asks once for each of them which it
/// is; the elements know nothing of it.
template <class... Parts>
using AnyPart = std::variant<Parts...>;

namespace detail {

/// The types that an item may have when the run starts, as a tuple.
template <class Item>
struct KindsOf : std::type_identity<std::tuple<Item>> {};
template <class Item>
struct KindsOf<std::vector<Item>> : KindsOf<Item> {};
template <class... Items>
struct KindsOf<std::variant<Items...>>
    : std::type_identity<decltype(std::tuple_cat(std::declval<typename KindsOf<Items>::type>()...))> {};

/// f.operator()<Kind>() is true for a type, or for each type, that one of the items may have.
template <class... Items, class F>
constexpr bool any_kind(const F& f) {
  const auto any = [&]<class... Kinds>(const std::tuple<Kinds...>*) { return (f.template operator()<Kinds>() || ...); };
  return (any(static_cast<const typename KindsOf<Items>::type*>(nullptr)) || ...);
}
template <class... Items, class F>
constexpr bool every_kind(const F& f) {
  return !any_kind<Items...>([&]<class Kind>() { return !f.template operator()<Kind>(); });
}
/// It stands for items that are chosen, or counted, when the run starts.
template <class Item>
inline constexpr bool is_chosen_late = !std::is_same_v<typename KindsOf<Item>::type, std::tuple<Item>>;

/// f(the alternative that a variant holds, its number as a constant).
template <class Variant, class F>
constexpr void with_alternative(Variant&& variant, const F& f) {
  [&]<std::size_t... i>(std::index_sequence<i...>) {
    (void)((variant.index() == i && (f(*std::get_if<i>(&variant), std::integral_constant<std::size_t, i>{}), true)) ||
           ...);
  }(std::make_index_sequence<std::variant_size_v<std::remove_cvref_t<Variant>>>{});
}

template <class T>
inline constexpr bool is_variant = false;
template <class... Ts>
inline constexpr bool is_variant<std::variant<Ts...>> = true;
template <class T>
inline constexpr bool is_vector = false;
template <class T>
inline constexpr bool is_vector<std::vector<T>> = true;

/// f(item) of each that stands in an item of a scene: itself, those of a list, the one of a variant.
template <class Item, class F>
constexpr void each_within(Item& item, const F& f) {
  if constexpr (is_vector<std::remove_const_t<Item>>)
    for (auto& one : item) each_within(one, f);
  else if constexpr (is_variant<std::remove_const_t<Item>>)
    with_alternative(item, [&](auto& one, auto) { each_within(one, f); });
  else
    f(item);
}
/// Adds the sizes of the lists, and the numbers of the alternatives, that stand in an item.
template <class Item>
void add_chosen(const Item& item, std::vector<std::size_t>& all) {
  if constexpr (is_vector<Item>) {
    all.push_back(item.size());
    for (const auto& one : item) add_chosen(one, all);
  } else if constexpr (is_variant<Item>) {
    all.push_back(item.index());
    with_alternative(item, [&](const auto& one, auto) { add_chosen(one, all); });
  }
}
/// f(item) of each that stands in the items of a tuple.
template <class Tuple, class F>
constexpr void each_item(Tuple& items, const F& f) {
  each_of(items, [&](auto& item) { each_within(item, f); });
}

}  // namespace detail

}  // namespace strike
