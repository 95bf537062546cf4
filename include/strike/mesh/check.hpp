#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include <strike/error.hpp>
#include <strike/mesh/describe.hpp>
#include <strike/mesh/measure.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/mesh/select.hpp>
#include <strike/mesh/transform.hpp>
#include <strike/tensor/tensor.hpp>
#include <strike/text.hpp>

namespace strike {
namespace detail {

/// Sine below which three edges count as coplanar, or two as collinear.
inline constexpr double flat = 1e-9;

/// Scaled Jacobian: triple product of the edges that leave a corner over the product of their lengths; 1 at the corner
/// of a brick, 0 if they are coplanar, negative if the cell is inside out there.
inline double corner_sine(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const double lengths = a.norm() * b.norm() * c.norm();
  return lengths > 0 ? cross(a, b).dot(c) / lengths : 0;
}

/// The least scaled Jacobian of the corners of a cell, and the corner that has it; of a tetrahedron at corner 0, of a
/// quadrilateral the triple product with its normal.
struct CornerSine {
  double sine = std::numeric_limits<double>::infinity();
  std::size_t corner = 0;

  void take(double other, std::size_t at) {
    if (other < sine) sine = other, corner = at;
  }
};
inline CornerSine least_corner_sine(std::span<const Eigen::Vector3d> nodes, const std::array<Index, 8>& cell) {
  // The neighbours of each corner, so that their edges are right-handed.
  constexpr std::array<std::array<unsigned, 3>, 8> neighbours{
      {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7}, {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}}};
  CornerSine least;
  for (std::size_t i = 0; i < 8; ++i) {
    const Eigen::Vector3d& x = nodes[cell[i]];
    const auto& [a, b, c] = neighbours[i];
    least.take(corner_sine(nodes[cell[a]] - x, nodes[cell[b]] - x, nodes[cell[c]] - x), i);
  }
  return least;
}
inline CornerSine least_corner_sine_of_tetrahedron(std::span<const Eigen::Vector3d> nodes,
                                                   const std::array<Index, 4>& cell) {
  const Eigen::Vector3d& x = nodes[cell[0]];
  return {corner_sine(nodes[cell[1]] - x, nodes[cell[2]] - x, nodes[cell[3]] - x), 0};
}
inline CornerSine least_corner_sine_of_quadrilateral(std::span<const Eigen::Vector3d> nodes,
                                                     const std::array<Index, 4>& cell) {
  const Eigen::Vector3d area = area_vector(nodes, Face{cell, 0});
  CornerSine least;
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Vector3d& x = nodes[cell[i]];
    const Eigen::Vector3d next = nodes[cell[(i + 1) % 4]] - x, last = nodes[cell[(i + 3) % 4]] - x;
    least.take(corner_sine(next, last, area), i);
  }
  return least;
}

template <std::size_t N>
std::string cell_text(const char* shape, std::size_t number, std::span<const Eigen::Vector3d> nodes,
                      const std::array<Index, N>& cell) {
  return joined({"strike: ", shape, " ", std::to_string(number), " at ", text(centroid<N>(nodes, cell))});
}

/// Error: a cell names a node that does not exist, or one twice.
template <std::size_t N>
void check_numbers(const char* shape, std::span<const Eigen::Vector3d> nodes, const Cells<N>& cells) {
  for (std::size_t e = 0; e < cells.size(); ++e) {
    for (std::size_t i = 0; i < N; ++i)
      if (cells[e][i] >= nodes.size())
        throw Error(detail::joined({"strike: ", shape, " ", std::to_string(e), " names node ",
                                    std::to_string(cells[e][i]), ", but the mesh has ", std::to_string(nodes.size()),
                                    " nodes; count them from 0 and correct the cell."}));
    for (std::size_t i = 0; i < N; ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (cells[e][i] == cells[e][j])
          throw Error(
              detail::joined({cell_text<N>(shape, e, nodes, cells[e]), " names node ", std::to_string(cells[e][i]),
                              " twice; give it ", std::to_string(N), " different corners."}));
  }
}

}  // namespace detail

/// Throws an Error that names the first fault of a mesh: a position that is not finite; a cell that names a node which
/// does not exist, or one twice; a hexahedron or tetrahedron that is flat or inside out at a corner; a quadrilateral
/// that is crossed, concave or without area; a node that belongs to no cell.
inline void check(const Mesh& mesh) {
  using namespace detail;
  const std::span<const Eigen::Vector3d> nodes = mesh.nodes;
  for (std::size_t n = 0; n < nodes.size(); ++n)
    if (!std::isfinite(nodes[n](0) + nodes[n](1) + nodes[n](2)))
      throw Error(detail::joined({"strike: node ", std::to_string(n), " at ", detail::text(nodes[n]),
                                  " has no finite position; correct its coordinates."}));
  detail::check_numbers("hexahedron", nodes, mesh.hexahedra);
  detail::check_numbers("tetrahedron", nodes, mesh.tetrahedra);
  detail::check_numbers("quadrilateral", nodes, mesh.quadrilaterals);

  for (std::size_t e = 0; e < mesh.hexahedra.size(); ++e) {
    const auto& cell = mesh.hexahedra[e];
    if (const auto [sine, corner] = detail::least_corner_sine(nodes, cell); sine <= detail::flat)
      throw Error(
          detail::joined({detail::cell_text<8>("hexahedron", e, nodes, cell), " is flat or inside out at corner ",
                          std::to_string(corner), " (volume ", detail::text(hexahedron_volume(nodes, cell)),
                          "); order its corners 0-3 around the bottom and 4-7 above them, right-handed."}));
  }
  for (std::size_t e = 0; e < mesh.tetrahedra.size(); ++e) {
    const auto& cell = mesh.tetrahedra[e];
    if (detail::least_corner_sine_of_tetrahedron(nodes, cell).sine <= detail::flat)
      throw Error(detail::joined({detail::cell_text<4>("tetrahedron", e, nodes, cell),
                                  " is flat or inside out (volume ", detail::text(tetrahedron_volume(nodes, cell)),
                                  "); order its corners so that 3 lies above the counter-clockwise 0-1-2."}));
  }
  for (std::size_t e = 0; e < mesh.quadrilaterals.size(); ++e) {
    const auto& cell = mesh.quadrilaterals[e];
    if (const auto [sine, corner] = detail::least_corner_sine_of_quadrilateral(nodes, cell); !(sine > detail::flat))
      throw Error(detail::joined({detail::cell_text<4>("quadrilateral", e, nodes, cell),
                                  " is crossed, concave or flat at corner ", std::to_string(corner),
                                  "; list its corners in order around a convex shape."}));
  }

  const std::vector<Index> orphans = orphan_nodes(mesh);
  if (!orphans.empty())
    throw Error(detail::joined({"strike: node ", std::to_string(orphans[0]), " at ", detail::text(nodes[orphans[0]]),
                                " belongs to no cell, so it has no mass (one of ", std::to_string(orphans.size()),
                                "); call remove_orphan_nodes(mesh)."}));
}

}  // namespace strike
