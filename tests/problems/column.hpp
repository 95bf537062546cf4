#pragma once
// A column of hexahedra along x for waves in one direction.
#include <cmath>
#include <vector>

#include <strike/dynamics/explicit.hpp>
#include <strike/load/support.hpp>
#include <strike/mesh/box.hpp>
#include <strike/mesh/select.hpp>

namespace strike {

/// `cells` hexahedra of the given length along x, from x = 0, with a square section of `width`.
inline Mesh column(Index cells, double length, double width) {
  return box({.size = {length, width, width}, .cells = {cells, 1, 1}});
}

/// The nodes of a mesh at x.
inline std::vector<Index> section(const Mesh& mesh, double x) { return nodes_where(mesh.nodes, on_plane(Axis::x, x)); }

}  // namespace strike
