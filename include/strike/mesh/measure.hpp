#pragma once
#include <array>
#include <cstddef>
#include <span>

#include <strike/mesh/mesh.hpp>
#include <strike/mesh/surface.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike {

/// Volume of the trilinear hexahedron [length^3], exact; negative if it is inside out.
inline double hexahedron_volume(std::span<const Eigen::Vector3d> nodes, const std::array<Index, 8>& cell) {
  using namespace detail;
  // Cones from corner 0 over its faces. Over a bilinear face the cone is the mean of those over its two pairs of
  // triangles: with a, b, c, d from the apex, 12 V = (a + b) . (c x d) + (c + d) . (a x b).
  const Eigen::Vector3d& apex = nodes[cell[0]];
  double volume = 0;
  for (const auto& corners : hexahedron_faces) {
    const Eigen::Vector3d a = nodes[cell[corners[0]]] - apex, b = nodes[cell[corners[1]]] - apex,
                          c = nodes[cell[corners[2]]] - apex, d = nodes[cell[corners[3]]] - apex;
    volume += (a + b).dot(cross(c, d)) + (c + d).dot(cross(a, b));
  }
  return volume / 12;
}

/// Volume of a tetrahedron [length^3]; negative if it is inside out.
inline double tetrahedron_volume(std::span<const Eigen::Vector3d> nodes, const std::array<Index, 4>& cell) {
  using namespace detail;
  const Eigen::Vector3d &a = nodes[cell[0]], &b = nodes[cell[1]], &c = nodes[cell[2]], &d = nodes[cell[3]];
  return cross<double>(b - a, c - a).dot(d - a) / 6;
}

/// Volume of a hexahedron or a tetrahedron [length^3], by its number of corners.
template <std::size_t n>
  requires(n == 8 || n == 4)
double solid_volume(std::span<const Eigen::Vector3d> nodes, const std::array<Index, n>& cell) {
  if constexpr (n == 8)
    return hexahedron_volume(nodes, cell);
  else
    return tetrahedron_volume(nodes, cell);
}

/// Area of a quadrilateral [length^2]; of a warped one the norm of its vector area.
inline double quadrilateral_area(std::span<const Eigen::Vector3d> nodes, const std::array<Index, 4>& cell) {
  return area_vector(nodes, Face{cell, 0}).norm();
}

/// Area of a triangle [length^2].
inline double triangle_area(std::span<const Eigen::Vector3d> nodes, const std::array<Index, 3>& cell) {
  return area_vector(nodes, Face{{cell[0], cell[1], cell[2], cell[2]}, 0}).norm();
}

/// Volume of all hexahedra, tetrahedra and particles of a mesh [length^3].
inline double volume(const Mesh& mesh) {
  double sum = 0;
  for (const auto& cell : mesh.hexahedra) sum += hexahedron_volume(mesh.nodes, cell);
  for (const auto& cell : mesh.tetrahedra) sum += tetrahedron_volume(mesh.nodes, cell);
  for (const double one : mesh.particles.volumes) sum += one;
  return sum;
}

}  // namespace strike
