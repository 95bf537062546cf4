#pragma once
#include <cstddef>

#include <strike/element/element.hpp>
#include <strike/material/material.hpp>
#include <strike/mesh/part_faces.hpp>
#include <strike/mesh/surface.hpp>

namespace strike::detail {

/// The cells of a part at work, for other items of its scene. Plates are quadrilaterals or triangles whose section has
/// a thickness.
template <class Part, class Nodes>
PartFaces faces_of(const Part& part, const Nodes& nodes) {
  PartFaces known{.cells = part.size(), .faces = {}, .erodes = Part::erodes};
  if constexpr (Part::n == 8) {
    append_faces(known.faces, part.cells(nodes), hexahedron_faces, 0);
  } else if constexpr (Part::n == 4 || Part::n == 3) {
    if constexpr (is_flat<typename Part::Element>) {
      if constexpr (requires { double{part.material().thickness()}; }) {
        if constexpr (Part::n == 4)
          known.faces = quadrilateral_surface(part.cells(nodes));
        else
          known.faces = triangle_surface(part.cells(nodes));
        known.thickness = part.material().thickness();
      }
      if constexpr (requires { double{part.material().offset()}; }) known.offset = part.material().offset();
    } else if constexpr (Part::n == 4) {
      append_faces(known.faces, part.cells(nodes), tetrahedron_faces, 0);
    }
  }
  if constexpr (Part::sees_neighbours && !Part::is_born) {  // which are the nodes of other cells
    known.thickness = part.spacing();
    for (const auto& [node] : part.cells(nodes)) known.particles.push_back(node);
  }
  if constexpr (Part::n == 8 || Part::n == 4 || Part::n == 3) {
    if constexpr (requires { double{moduli_at_rest(part.material()).wave()}; })
      known.wave_modulus = moduli_at_rest(part.material()).wave();
  }
  return known;
}

}  // namespace strike::detail
