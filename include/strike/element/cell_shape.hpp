#pragma once
#include <concepts>
#include <cstddef>

#include <strike/cxx20.hpp>

namespace strike {

/// Shape of the cells of an element, which has corners as many and in the order as those of a Mesh.
enum class CellShape { hexahedron, tetrahedron, quadrilateral, triangle };

namespace detail {

constexpr std::size_t corner_count(CellShape shape) {
  return shape == CellShape::hexahedron ? 8 : shape == CellShape::triangle ? 3 : 4;
}

/// The element tells the shape of its cells.
template <class E>
concept HasCellShape = requires {
  { E::shape } -> std::same_as<const CellShape&>;
};

}  // namespace detail
}  // namespace strike
