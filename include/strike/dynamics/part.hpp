#pragma once
#include <array>
#include <concepts>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

#include <strike/dynamics/debris.hpp>
#include <strike/dynamics/erosion.hpp>
#include <strike/dynamics/removal.hpp>
#include <strike/element/element.hpp>
#include <strike/mesh/mesh.hpp>

namespace strike {

namespace detail {

template <class E>
concept HasNodesAndKinematics = requires {
  typename E::Kinematics;
  E::nodes;
};
template <class M>
concept HasKinematics = requires { typename M::Kinematics; };

/// The faults of a part, in the order in which they are looked for.
enum class Flaw {
  none,
  reported,
  element,
  material,
  pair,
  corners,
  fibres,
  material_members,
  element_members,
  debris,
  keeps,
  removal
};

template <class E, class M, std::size_t n, class Removal>
constexpr Flaw flaw() {
  if constexpr (!HasNodesAndKinematics<E>)
    return Flaw::element;
  else if constexpr (is_reported<E>() || is_reported<M>())
    return Flaw::reported;
  else if constexpr (!HasKinematics<M> || HasNodesAndKinematics<M>)
    return Flaw::material;
  else if constexpr (!std::same_as<typename E::Kinematics, typename M::Kinematics>)
    return Flaw::pair;
  else if constexpr (static_cast<std::size_t>(E::nodes) != n)
    return Flaw::corners;
  else if constexpr (requires { requires M::has_fibres && E::physical; })
    return Flaw::fibres;
  else if constexpr (!Material<M>)
    return Flaw::material_members;
  else if constexpr (!sees_neighbours<E>() && !Element<E, M>)
    return Flaw::element_members;
  else if constexpr (is_born<Removal> && !sees_neighbours<E>())
    return Flaw::debris;
  else if constexpr (std::same_as<Removal, NoErosion> || RemovalLaw<Removal, E, M>)
    return Flaw::none;
  else if constexpr (HasName<Keeps, Removal>)
    return Flaw::keeps;
  else
    return Flaw::removal;
}

/// The cells of elements with n nodes: those of one node are particles, which have volumes.
template <std::size_t n>
struct CellsWith {
  using type = Cells<n>;
};
template <>
struct CellsWith<1> {
  using type = Particles;
};
template <class Cells>
const Cells& connectivity(const Cells& cells) {
  return cells;
}
inline const Cells<1>& connectivity(const Particles& particles) { return particles.cells; }

template <class C>
inline constexpr bool is_cells = false;
template <std::size_t n>
inline constexpr bool is_cells<Cells<n>> = true;

/// The pieces of a Part that stand where its cells belong.
template <class... Pieces>
struct NotCells {};

}  // namespace detail

/// The elements of one kind and one material in a scene, and the law by which they are deleted, if they are.
template <class E, class M, std::size_t n = 8, class Removal = NoErosion>
struct Part {
  static_assert(instantiates(static_cast<detail::Report<M>*>(nullptr)));
  static constexpr detail::Flaw flaw = detail::flaw<E, M, n, Removal>();
  static_assert(flaw != detail::Flaw::element, "strike: the first piece of a Part is its element, such as Hex8{}.");
  static_assert(flaw != detail::Flaw::material,
                "strike: the second piece of a Part is its material, such as Solid{...} or Elastic{...}.");
  static_assert(
      flaw != detail::Flaw::pair,
      "strike: this element and this material do not fit: their Kinematics differ, so one measures what the other "
      "does not know.");
  static_assert(flaw != detail::Flaw::corners,
                "strike: these cells do not have as many nodes as the element of the Part.");
  static_assert(flaw != detail::Flaw::fibres,
                "strike: PhysicalHourglass knows isotropic layers alone: give plates with fibres Plate4{}, whose "
                "control is PlateHourglass.");
  static_assert(flaw != detail::Flaw::material_members,
                "strike: this material lacks one of State<T>, density(), stress(state, rate, dt), stress(state) and "
                "moduli(state, rate), or it returns another type; see strike/material/material.hpp.");
  static_assert(
      flaw != detail::Flaw::element_members,
      "strike: this element lacks one of State<M, T>, begin(state, material, x) and advance(state, material, x, v, "
      "dt), or it returns another type; see strike/element/element.hpp.");
  static_assert(flaw != detail::Flaw::debris,
                "strike: Debris is the law of a part of particles: Part{Particle{}, material, "
                "particles_at_nodes(nodes, cells), Debris{.of = 0}}.");
  static_assert(
      flaw != detail::Flaw::keeps,
      "strike: keeps of a removal law is called as keeps(state, element) and returns a comparison, true where "
      "an element stays; see strike/dynamics/removal.hpp.");
  static_assert(flaw != detail::Flaw::removal,
                "strike: the fourth piece of a Part is the law by which its elements are deleted, such as "
                "Erosion{.strain = 5}; see strike/dynamics/removal.hpp.");

  E element;
  M material;
  typename detail::CellsWith<n>::type cells;
  [[no_unique_address]] Removal removal{};

  void ranges(const auto& number) const { number(element), number(material), number(removal); }
};
template <class E, class M, std::size_t n>
Part(E, M, std::vector<std::array<Index, n>>) -> Part<E, M, n>;
template <class E, class M, std::size_t n, class Removal>
Part(E, M, std::vector<std::array<Index, n>>, Removal) -> Part<E, M, n, Removal>;
template <class E, class M>
Part(E, M, Particles) -> Part<E, M, 1>;
template <class E, class M, class Removal>
Part(E, M, Particles, Removal) -> Part<E, M, 1, Removal>;

/// The type of a part of these elements.
template <class E, class M, class Removal = NoErosion>
using PartOf = Part<E, M, static_cast<std::size_t>(E::nodes), Removal>;

/// Fallback for a part without cells in the third place: its static_assert is the one message.
template <class E, class M, class... Pieces>
struct Part<E, M, 0, detail::NotCells<Pieces...>> {
  static constexpr detail::Flaw flaw = detail::Flaw::reported;
  static_assert(
      sizeof...(Pieces) != sizeof...(Pieces),
      "strike: the third piece of a Part is its cells, such as bar.hexahedra of the mesh bar; the law by which "
      "they are deleted, such as Erosion{.strain = 5}, comes after them.");
  Part(const auto&...) {}
};
template <class E, class M, class... Pieces>
Part(E, M, Pieces...) -> Part<E, M, 0, detail::NotCells<Pieces...>>;

/// The least stable step of some elements and the element that has it.
struct StableStep {
  double dt = std::numeric_limits<double>::infinity();
  std::size_t element = 0;
  std::size_t part = 0;
  double of_elements = dt;  ///< before contacts and other items of the scene have lowered it
};

}  // namespace strike
