#pragma once
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <strike/element/cell_shape.hpp>
#include <strike/error.hpp>
#include <strike/mesh/check_cell.hpp>
#include <strike/mesh/describe.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/mesh/select.hpp>
#include <strike/mesh/transform.hpp>
#include <strike/range.hpp>
#include <strike/text.hpp>

namespace strike {
namespace detail {

/// Error: a cell names a node that does not exist.
template <std::size_t N>
void check_names(std::string_view kind, std::span<const Eigen::Vector3d> nodes, const Cells<N>& cells) {
  for (std::size_t e = 0; e < cells.size(); ++e)
    for (const Index node : cells[e])
      if (node >= nodes.size())
        throw Error(joined({"strike: ", kind, " ", std::to_string(e), " names node ", std::to_string(node),
                            ", but the mesh has ", std::to_string(nodes.size()),
                            " nodes; count them from 0 and correct the cell."}));
}
/// Error: a cell names a node that does not exist, or breaks a law of its shape.
template <CellShape shape, std::size_t N>
void check_cells(std::span<const Eigen::Vector3d> nodes, const Cells<N>& cells) {
  check_names(CellLaws<shape>::name, nodes, cells);
  for (std::size_t e = 0; e < cells.size(); ++e)
    if (const CellCorners<N> x = corners_of(nodes, cells[e]); !is_sound<shape>(cells[e], x))
      throw Error(joined({"strike: ", CellLaws<shape>::name, " ", std::to_string(e), " at ",
                          text(centroid<N>(nodes, cells[e])), " ", fault_of<shape>(cells[e], x)}));
}

/// Error: another number of volumes than of particles; one that is not positive; a node that does not exist.
inline void check_particles(std::span<const Eigen::Vector3d> nodes, const Particles& particles) {
  check_names("particle", nodes, particles.cells);
  const std::vector<double>& V = particles.volumes;
  if (V.size() != particles.size())
    throw Error(joined({"strike: a mesh has ", std::to_string(particles.size()), " particles, but ",
                        std::to_string(V.size()), " volumes of particles; give one for each."}));
  for (std::size_t e = 0; e < V.size(); ++e)
    if (!range::positive.holds(V[e]))
      throw Error(joined({"strike: the volume of particle ", std::to_string(e), " is ", text(V[e]), "; it must be ",
                          range::positive.words(V[e]), "."}));
}

}  // namespace detail

/// Throws an Error that names the first fault of a mesh: a position that is not finite; a cell that names a node which
/// does not exist, or one twice, but for a quadrilateral that is a triangle and a hexahedron that is a wedge or a
/// pyramid (strike/mesh/degenerate.hpp); a hexahedron or tetrahedron that is flat
/// or inside out at a corner; a hexahedron twisted by 60 degrees or more; a quadrilateral that is crossed, concave or
/// without area; a triangle without area; a particle without volume; a node that belongs to no cell. A run checks the
/// cells of its parts by the same laws.
inline void check(const Mesh& mesh) {
  const std::span<const Eigen::Vector3d> nodes = mesh.nodes;
  for (std::size_t n = 0; n < nodes.size(); ++n)
    if (!std::isfinite(nodes[n](0) + nodes[n](1) + nodes[n](2)))
      throw Error(detail::joined({"strike: node ", std::to_string(n), " at ", detail::text(nodes[n]),
                                  " has no finite position; correct its coordinates."}));
  detail::check_cells<CellShape::hexahedron>(nodes, mesh.hexahedra);
  detail::check_cells<CellShape::tetrahedron>(nodes, mesh.tetrahedra);
  detail::check_cells<CellShape::quadrilateral>(nodes, mesh.quadrilaterals);
  detail::check_cells<CellShape::triangle>(nodes, mesh.triangles);
  detail::check_particles(nodes, mesh.particles);

  const std::vector<Index> orphans = orphan_nodes(mesh);
  if (!orphans.empty())
    throw Error(detail::joined({"strike: node ", std::to_string(orphans[0]), " at ", detail::text(nodes[orphans[0]]),
                                " belongs to no cell, so it has no mass (one of ", std::to_string(orphans.size()),
                                "); call remove_orphan_nodes(mesh)."}));
}

}  // namespace strike
