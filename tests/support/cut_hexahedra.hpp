#pragma once
// Meshes of wedges and of pyramids, cut from hexahedra.
#include <algorithm>
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
    for (const auto& [a, b, c, d] : strike::detail::hexahedron_faces)
      pyramids.push_back(pyramid_cell<Index>({cell[a], cell[d], cell[c], cell[b], middle}));
  }
  mesh.hexahedra = pyramids;
  return mesh;
}

/// Some hexahedra as they are, the second third of them along x cut into wedges and the last into pyramids.
inline Mesh cut_by_thirds(const Mesh& mesh) {
  double low = mesh.nodes[0].x(), high = low;
  for (const auto& x : mesh.nodes) low = std::min(low, x.x()), high = std::max(high, x.x());
  std::array<Mesh, 3> third;
  for (Mesh& part : third) part.nodes = mesh.nodes;
  for (const auto& cell : mesh.hexahedra) {
    const double share = (centroid<8>(mesh.nodes, cell).x() - low) / (high - low);
    third[share < 1. / 3 ? 0 : share < 2. / 3 ? 1 : 2].hexahedra.push_back(cell);
  }
  Mesh cut = cut_into_pyramids(third[2]);
  const Cells<8> wedges = cut_into_wedges(third[1]).hexahedra;
  cut.hexahedra.insert(cut.hexahedra.begin(), wedges.begin(), wedges.end());
  cut.hexahedra.insert(cut.hexahedra.begin(), third[0].hexahedra.begin(), third[0].hexahedra.end());
  return cut;
}

}  // namespace strike::testing
