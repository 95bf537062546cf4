#pragma once
// Taylor's bar of six tetrahedra a hexahedron, the foot held on the wall.
#include <strike/element/tet4.hpp>
#include <strike/mesh/tetrahedra.hpp>

#include "problems/taylor_bar.hpp"

namespace strike::taylor {

template <class E>
auto bar_of_tetrahedra(const E& element, Index cells, Index layers) {
  const Data& data = mm_ms_kg;
  const Mesh mesh =
      tetrahedralized(cylinder({.radius = data.radius, .length = data.length, .cells = cells, .layers = layers}));
  const auto on = [&](Axis axis) { return nodes_where(mesh.nodes, on_plane(axis, 0)); };
  return Explicit{Scene{mesh.nodes, Part{element, copper(data), mesh.tetrahedra}, InitialVelocity{{0, 0, -data.speed}},
                        Symmetry{Axis::x, on(Axis::x)}, Symmetry{Axis::y, on(Axis::y)},
                        Symmetry{Axis::z, on(Axis::z)}}};
}

}  // namespace strike::taylor
