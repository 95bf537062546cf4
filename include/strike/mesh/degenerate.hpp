#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include <strike/mesh/mesh.hpp>

namespace strike {

/// The wedge between the triangles c0 c1 c2 and c3 c4 c5 above it, counter-clockwise seen from above, as a degenerate
/// hexahedron of a Mesh.
template <class Node = Index>
constexpr std::array<Node, 8> wedge_cell(const std::array<Node, 6>& c) {
  return {c[0], c[1], c[2], c[2], c[3], c[4], c[5], c[5]};
}
/// The pyramid on the base c0 c1 c2 c3, counter-clockwise seen from its apex c4, in the same way.
template <class Node = Index>
constexpr std::array<Node, 8> pyramid_cell(const std::array<Node, 5>& c) {
  return {c[0], c[1], c[2], c[3], c[4], c[4], c[4], c[4]};
}

namespace detail {

/// Kinds of cells in the list of hexahedra.
enum class HexahedronKind { brick, wedge, pyramid, other };

/// Number of different nodes among N.
template <class Node, std::size_t N>
constexpr std::size_t count_different(const std::array<Node, N>& cell) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < N; ++i) {
    bool is_new = true;
    for (std::size_t j = 0; j < i; ++j) is_new = is_new && cell[i] != cell[j];
    count += is_new;
  }
  return count;
}

using CornerOrder = std::array<unsigned, 8>;

/// The 24 numberings of the corners of a hexahedron that are turned against each other, the usual one first.
constexpr std::array<CornerOrder, 24> turned_numberings() {
  const CornerOrder about_z{1, 2, 3, 0, 5, 6, 7, 4}, about_x{3, 2, 6, 7, 0, 1, 5, 4};
  std::array<CornerOrder, 24> found{CornerOrder{0, 1, 2, 3, 4, 5, 6, 7}};
  std::size_t count = 1;
  for (std::size_t k = 0; k < count; ++k)
    for (const CornerOrder& turn : {about_z, about_x}) {
      CornerOrder next{};
      for (std::size_t i = 0; i < 8; ++i) next[i] = found[k][turn[i]];
      bool is_new = true;
      for (std::size_t j = 0; j < count; ++j) is_new = is_new && found[j] != next;
      if (is_new) found[count++] = next;
    }
  return found;
}

/// The kind of a hexahedron, and the order of its corners in which it is that of wedge_cell or pyramid_cell.
struct DegenerateHexahedron {
  HexahedronKind kind = HexahedronKind::brick;
  CornerOrder order{0, 1, 2, 3, 4, 5, 6, 7};

  template <class Node>
  explicit constexpr DegenerateHexahedron(const std::array<Node, 8>& cell) {
    const std::size_t different = count_different(cell);
    if (different == 8) return;
    kind = HexahedronKind::other;
    if (different != 6 && different != 5) return;
    constexpr auto numberings = turned_numberings();
    for (const CornerOrder& turned : numberings) {
      const auto alike = [&](std::size_t i, std::size_t j) { return cell[turned[i]] == cell[turned[j]]; };
      const bool fits = different == 6 ? alike(2, 3) && alike(6, 7) : alike(4, 5) && alike(4, 6) && alike(4, 7);
      if (!fits) continue;
      kind = different == 6 ? HexahedronKind::wedge : HexahedronKind::pyramid;
      order = turned;
      return;
    }
  }
};

/// The values at the corners in another order.
template <class Value>
constexpr std::array<Value, 8> in_order(const std::array<Value, 8>& values, const CornerOrder& order) {
  std::array<Value, 8> ordered{};
  for (std::size_t i = 0; i < 8; ++i) ordered[i] = values[order[i]];
  return ordered;
}

/// Shares of the corners of a cell in its mass over that of N equal ones, so that a node has the sum over its corners.
/// Of a hexahedron, and for an element that does not merge corners, they are 1; of a wedge and a pyramid those of
/// MergedCorners (strike/element/merged_corners.hpp).
template <std::size_t N>
constexpr std::array<double, N> corner_shares(const std::array<Index, N>& cell, bool merges = true) {
  std::array<double, N> shares;
  shares.fill(1);
  if constexpr (N == 8) {
    const std::size_t different = count_different(cell);
    if (!merges || (different != 6 && different != 5)) return shares;
    for (std::size_t i = 0; i < 8; ++i) {
      const auto alike = static_cast<double>(std::count(cell.begin(), cell.end(), cell[i]));
      shares[i] = different == 6 ? 8.0 / (6 * alike) : alike > 1 ? 0.5 : 1.5;
    }
  }
  return shares;
}

}  // namespace detail

/// The numbering of a hexahedron with 6 or 5 different corners as wedge_cell or pyramid_cell has it, from any that is
/// turned or mirrored, such as a b c d e e f f and a b c d e e e e of LS-DYNA; of 8 different corners as it is. Nothing
/// if corners are repeated in another way: the shape is then neither.
template <class Node>
constexpr std::optional<std::array<Node, 8>> canonical_hexahedron(const std::array<Node, 8>& cell) {
  const detail::DegenerateHexahedron degenerate(cell);
  if (degenerate.kind == detail::HexahedronKind::other) return std::nullopt;
  return detail::in_order(cell, degenerate.order);
}

}  // namespace strike
