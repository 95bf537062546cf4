#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include <strike/cxx20.hpp>

namespace strike {

/// Number of a node or an element, counted from zero.
using Index = std::uint32_t;

/// Connectivity of elements with N nodes: `cells[e][i]` is the node at corner i of element e.
template <std::size_t N>
using Cells = std::vector<std::array<Index, N>>;

/// Particles: the node of each, a cell of one corner, and its volume at rest [length^3].
struct Particles {
  Cells<1> cells = {};
  std::vector<double> volumes = {};

  std::size_t size() const { return cells.size(); }
  bool empty() const { return cells.empty(); }
  const std::array<Index, 1>& operator[](std::size_t e) const { return cells[e]; }
  auto begin() const { return cells.begin(); }
  auto end() const { return cells.end(); }
};

/// Nodes and the elements between them. Corners of a hexahedron: 0-3 around the bottom, 4-7 above them, right-handed;
/// of a tetrahedron: 3 above the counter-clockwise 0-1-2; of a quadrilateral or a triangle: around it. Hexahedra may be
/// degenerate: wedges a b c c d e f f and pyramids a b c d e e e e (strike/mesh/degenerate.hpp). Where all cells are
/// counted together, hexahedra come first, then tetrahedra, then quadrilaterals, then triangles, then particles.
struct Mesh {
  std::vector<Eigen::Vector3d> nodes;  ///< reference positions [length]
  Cells<8> hexahedra = {};
  Cells<4> tetrahedra = {};
  Cells<4> quadrilaterals = {};
  Cells<3> triangles = {};
  Particles particles = {};
};

}  // namespace strike
