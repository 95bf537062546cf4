#pragma once
#include <algorithm>
#include <array>
#include <utility>

#include <strike/mesh/mesh.hpp>
#include <strike/mesh/surface.hpp>

namespace strike {

/// The mesh with each hexahedron split into six tetrahedra that fit those of its neighbours: every face is cut along
/// the diagonal from its node of lowest number (rule of Dompierre et al. 1999), and the cell is the cone from its
/// lowest node over the three faces that do not touch it. It keeps all nodes. Hexahedron e gives six tetrahedra in a
/// row, after the tetrahedra of the mesh.
inline Mesh tetrahedralized(Mesh mesh) {
  for (const auto& cell : mesh.hexahedra) {
    const Index apex = *std::min_element(cell.begin(), cell.end());
    for (const auto& corners : detail::hexahedron_faces) {
      std::array<Index, 4> face;
      for (std::size_t i = 0; i < 4; ++i) face[i] = cell[corners[i]];
      std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
      if (face[0] == apex) continue;
      const auto& [a, b, c, d] = face;  // clockwise seen from the apex, which is inside
      mesh.tetrahedra.push_back({a, c, b, apex});
      mesh.tetrahedra.push_back({a, d, c, apex});
    }
  }
  mesh.hexahedra.clear();
  return mesh;
}

}  // namespace strike
