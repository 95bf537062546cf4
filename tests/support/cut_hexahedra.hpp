#pragma once
// Meshes of wedges and of pyramids, cut from hexahedra.
#include <array>
#include <cstddef>

#include <strike/mesh/degenerate.hpp>
#include <strike/mesh/select.hpp>
#include <strike/mesh/surface.hpp>

namespace strike::testing {

/// Each hexahedron cut into two wedges along the diagonals from its corners 0 and 4.
inline Mesh cut_into_wedges(Mesh mesh) {
  Cells<8> wedges;
  for (const auto& [a, b, c, d, p, q, r, s] : mesh.hexahedra) {
    wedges.push_back(wedge_cell<Index>({a, b, c, p, q, r}));
    wedges.push_back(wedge_cell<Index>({a, c, d, p, r, s}));
  }
  mesh.hexahedra = wedges;
  return mesh;
}

/// Each hexahedron cut into six pyramids about its middle.
inline Mesh cut_into_pyramids(Mesh mesh) {
  Cells<8> pyramids;
  for (const auto& cell : mesh.hexahedra) {
    const auto middle = static_cast<Index>(mesh.nodes.size());
    mesh.nodes.push_back(centroid<8>(mesh.nodes, cell));
    for (const auto& [a, b, c, d] : detail::hexahedron_faces)
      pyramids.push_back(pyramid_cell<Index>({cell[a], cell[d], cell[c], cell[b], middle}));
  }
  mesh.hexahedra = pyramids;
  return mesh;
}

}  // namespace strike::testing
