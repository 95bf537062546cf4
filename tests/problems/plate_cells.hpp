#pragma once
#include <strike/mesh/mesh.hpp>
#include <strike/mesh/triangulated.hpp>

namespace strike::testing {

/// The mesh with the cells that an element of plates takes: the quadrilaterals, or two triangles of each.
template <class Element>
Mesh for_element(const Mesh& mesh) {
  if constexpr (Element::nodes == 3)
    return triangulated(mesh);
  else
    return mesh;
}
template <class Element>
const auto& plate_cells(const Mesh& mesh) {
  if constexpr (Element::nodes == 3)
    return mesh.triangles;
  else
    return mesh.quadrilaterals;
}

}  // namespace strike::testing
