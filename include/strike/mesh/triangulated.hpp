#pragma once
#include <strike/mesh/mesh.hpp>

namespace strike {

/// The mesh with each quadrilateral cut into two triangles along its shorter diagonal, that from its first corner if
/// both are alike; one of three corners becomes one triangle. They stand behind the triangles of the mesh, and face the
/// side that it faced.
inline Mesh triangulated(Mesh mesh) {
  for (const auto& [a, b, c, d] : mesh.quadrilaterals) {
    const auto square = [&](Index i, Index j) { return (mesh.nodes[i] - mesh.nodes[j]).squaredNorm(); };
    const auto add = [&](Index i, Index j, Index k) {
      if (i != j && j != k && k != i) mesh.triangles.push_back({i, j, k});
    };
    if (square(a, c) <= square(b, d) * (1 + 1e-9))
      add(a, b, c), add(a, c, d);
    else
      add(a, b, d), add(b, c, d);
  }
  mesh.quadrilaterals.clear();
  return mesh;
}

}  // namespace strike
