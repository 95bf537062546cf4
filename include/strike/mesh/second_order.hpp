#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include <strike/mesh/measure.hpp>
#include <strike/mesh/mesh.hpp>

// Cells of second order, and the cells of first order that they are cut into. Pieces share their corners with those of
// a neighbour, because a face is cut by its own nodes alone.
namespace strike::detail {

/// Cells with nodes between their corners, by their number of nodes.
enum class SecondOrderKind : std::uint8_t {
  none,
  triangle6,
  quadrilateral8,
  quadrilateral9,
  tetrahedron10,
  hexahedron20,
  hexahedron27,
  wedge15,
  wedge18,
  pyramid13,
  pyramid14
};

/// The corners between which a mid node stands: of an edge, a face or the cell; a place in corners from 0.
struct MidNode {
  std::size_t count = 0;
  std::array<std::uint8_t, 8> corners = {};
};
constexpr MidNode between(std::uint8_t a, std::uint8_t b) { return {2, {a, b}}; }
constexpr MidNode between(std::uint8_t a, std::uint8_t b, std::uint8_t c, std::uint8_t d) { return {4, {a, b, c, d}}; }

/// Mid nodes in the order of Abaqus: edges around the bottom, around the top and up; the middles of faces; the centre.
inline constexpr std::array mid_nodes_of_triangle{between(0, 1), between(1, 2), between(2, 0)};
inline constexpr std::array mid_nodes_of_quadrilateral{between(0, 1), between(1, 2), between(2, 3), between(3, 0),
                                                       between(0, 1, 2, 3)};
inline constexpr std::array mid_nodes_of_tetrahedron{between(0, 1), between(1, 2), between(2, 0),
                                                     between(0, 3), between(1, 3), between(2, 3)};
inline constexpr std::array mid_nodes_of_hexahedron{between(0, 1),
                                                    between(1, 2),
                                                    between(2, 3),
                                                    between(3, 0),
                                                    between(4, 5),
                                                    between(5, 6),
                                                    between(6, 7),
                                                    between(7, 4),
                                                    between(0, 4),
                                                    between(1, 5),
                                                    between(2, 6),
                                                    between(3, 7),
                                                    between(0, 1, 2, 3),
                                                    between(4, 5, 6, 7),
                                                    between(0, 1, 5, 4),
                                                    between(1, 2, 6, 5),
                                                    between(2, 3, 7, 6),
                                                    between(3, 0, 4, 7),
                                                    MidNode{8, {0, 1, 2, 3, 4, 5, 6, 7}}};
inline constexpr std::array mid_nodes_of_wedge{
    between(0, 1), between(1, 2), between(2, 0), between(3, 4),       between(4, 5),       between(5, 3),
    between(0, 3), between(1, 4), between(2, 5), between(0, 1, 4, 3), between(1, 2, 5, 4), between(2, 0, 3, 5)};
inline constexpr std::array mid_nodes_of_pyramid{between(0, 1), between(1, 2), between(2, 3),
                                                 between(3, 0), between(0, 4), between(1, 4),
                                                 between(2, 4), between(3, 4), between(0, 1, 2, 3)};

constexpr std::span<const MidNode> mid_nodes(SecondOrderKind kind) {
  using Kind = SecondOrderKind;
  switch (kind) {
    case Kind::triangle6:
      return mid_nodes_of_triangle;
    case Kind::quadrilateral8:
      return std::span(mid_nodes_of_quadrilateral).first(4);
    case Kind::quadrilateral9:
      return mid_nodes_of_quadrilateral;
    case Kind::tetrahedron10:
      return mid_nodes_of_tetrahedron;
    case Kind::hexahedron20:
      return std::span(mid_nodes_of_hexahedron).first(12);
    case Kind::hexahedron27:
      return mid_nodes_of_hexahedron;
    case Kind::wedge15:
      return std::span(mid_nodes_of_wedge).first(9);
    case Kind::wedge18:
      return mid_nodes_of_wedge;
    case Kind::pyramid13:
      return std::span(mid_nodes_of_pyramid).first(8);
    case Kind::pyramid14:
      return mid_nodes_of_pyramid;
    default:
      return {};
  }
}

/// True of kinds that can be cut at their mid nodes: the others have none in the middles of their quadrilaterals, or,
/// as pyramids, would be cut into cells of two kinds.
constexpr bool has_pieces(SecondOrderKind kind) {
  using Kind = SecondOrderKind;
  return kind == Kind::triangle6 || kind == Kind::quadrilateral9 || kind == Kind::tetrahedron10 ||
         kind == Kind::hexahedron27 || kind == Kind::wedge18;
}

/// The pieces of a triangle by places among its nodes, corners first: three at the corners and one between them.
inline constexpr std::array<std::array<std::uint8_t, 3>, 4> pieces_of_triangle{
    {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}}};
/// The pieces of a quadrilateral, one at each corner, which is the first of their own.
inline constexpr std::array<std::array<std::uint8_t, 4>, 4> pieces_of_quadrilateral{
    {{0, 4, 8, 7}, {1, 5, 8, 4}, {2, 6, 8, 5}, {3, 7, 8, 6}}};
/// The pieces of a tetrahedron at its corners.
inline constexpr std::array<std::array<std::uint8_t, 4>, 4> pieces_at_corners{
    {{0, 4, 6, 7}, {4, 1, 5, 8}, {6, 5, 2, 9}, {7, 8, 9, 3}}};
/// The octahedron between them as four tetrahedra about each of its diagonals, from the middle of an edge to that of
/// the opposite one.
using Octahedron = std::array<std::array<std::uint8_t, 4>, 4>;
inline constexpr std::array<Octahedron, 3> octahedra{
    Octahedron{{{4, 9, 7, 8}, {4, 9, 6, 7}, {4, 9, 5, 6}, {4, 9, 8, 5}}},
    Octahedron{{{5, 7, 6, 4}, {5, 7, 9, 6}, {5, 7, 8, 9}, {5, 7, 4, 8}}},
    Octahedron{{{6, 8, 4, 5}, {6, 8, 7, 4}, {6, 8, 9, 7}, {6, 8, 5, 9}}}};

/// The eight pieces of a hexahedron of 27 nodes, by places among its nodes, and those of a wedge of 18.
constexpr std::array<std::array<std::uint8_t, 8>, 8> pieces_of_hexahedron() {
  constexpr std::array<std::array<int, 3>, 8> at{
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};
  std::array<std::uint8_t, 27> lattice{};  // the node at x + 3 y + 9 z, each from 0 to 2
  for (std::size_t n = 0; n < 27; ++n) {
    std::array<int, 3> place{};
    for (std::size_t i = 0; i < 3; ++i)
      if (n < 8) {
        place[i] = 2 * at[n][i];
      } else {
        const MidNode& mid = mid_nodes_of_hexahedron[n - 8];
        int sum = 0;
        for (std::size_t c = 0; c < mid.count; ++c) sum += at[mid.corners[c]][i];
        place[i] = 2 * sum / static_cast<int>(mid.count);
      }
    lattice[static_cast<std::size_t>(place[0] + 3 * place[1] + 9 * place[2])] = static_cast<std::uint8_t>(n);
  }
  std::array<std::array<std::uint8_t, 8>, 8> pieces{};
  for (std::size_t p = 0; p < 8; ++p)
    for (std::size_t c = 0; c < 8; ++c)
      pieces[p][c] = lattice[static_cast<std::size_t>(at[p][0] + at[c][0] + 3 * (at[p][1] + at[c][1]) +
                                                      9 * (at[p][2] + at[c][2]))];
  return pieces;
}
inline constexpr std::array<std::array<std::uint8_t, 6>, 8> pieces_of_wedge{{{0, 6, 8, 12, 15, 17},
                                                                             {6, 1, 7, 15, 13, 16},
                                                                             {8, 7, 2, 17, 16, 14},
                                                                             {6, 7, 8, 15, 16, 17},
                                                                             {12, 15, 17, 3, 9, 11},
                                                                             {15, 13, 16, 9, 4, 10},
                                                                             {17, 16, 14, 11, 10, 5},
                                                                             {15, 16, 17, 9, 10, 11}}};

/// The pieces of a tetrahedron of ten nodes: four at its corners, and the octahedron between them about the shortest of
/// its diagonals (M. Bey, Computing 55, 1995, has the same pieces about a fixed one), of those that leave no piece
/// inside out. Diagonals that differ by less than 10^-9 are as short, so that a turned cell is cut in the same way.
template <class Position>
std::array<std::array<std::uint8_t, 4>, 8> pieces_of_tetrahedron(const Position& x) {
  const auto volume = [&](const std::array<std::uint8_t, 4>& p) {
    return dot(cross(Eigen::Vector3d(x(p[1]) - x(p[0])), Eigen::Vector3d(x(p[2]) - x(p[0]))),
               Eigen::Vector3d(x(p[3]) - x(p[0])));
  };
  std::size_t best = 0;
  bool best_is_sound = false;
  double shortest = 0;
  for (std::size_t d = 0; d < 3; ++d) {
    const double length = (x(octahedra[d][0][0]) - x(octahedra[d][0][1])).norm();
    const bool is_sound = std::all_of(octahedra[d].begin(), octahedra[d].end(), [&](auto& p) { return volume(p) > 0; });
    if (d == 0 || (is_sound && !best_is_sound) || (is_sound == best_is_sound && length < (1 - 1e-9) * shortest))
      best = d, best_is_sound = is_sound, shortest = length;
  }
  std::array<std::array<std::uint8_t, 4>, 8> pieces;
  for (std::size_t i = 0; i < 4; ++i) pieces[i] = pieces_at_corners[i], pieces[4 + i] = octahedra[best][i];
  return pieces;
}

}  // namespace strike::detail
