#pragma once
#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <strike/error.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/mesh/transform.hpp>
#include <strike/text.hpp>

namespace strike {

/// The cells, or values of cells, for which `alive[e]` is true, in their order; see RunningPart::alive. Error: another
/// number of flags than of cells.
template <class Row>
std::vector<Row> remaining(const std::vector<Row>& rows, const std::vector<bool>& alive) {
  if (rows.size() != alive.size())
    throw Error(detail::joined({"strike: there are ", std::to_string(rows.size()), " cells or values, but ",
                                std::to_string(alive.size()), " flags of which are left; give one for each."}));
  std::vector<Row> left;
  for (std::size_t e = 0; e < rows.size(); ++e)
    if (alive[e]) left.push_back(rows[e]);
  return left;
}

/// The mesh with the cells for which `alive` is true, all kinds counted together. It keeps all nodes: its
/// `orphan_nodes` have lost all their cells.
inline Mesh remaining(Mesh mesh, const std::vector<bool>& alive) {
  std::size_t first = 0;
  const auto next = [&](std::size_t count) {
    const std::size_t last = std::min(first + count, alive.size());
    const std::vector<bool> flags(alive.begin() + static_cast<std::ptrdiff_t>(first),
                                  alive.begin() + static_cast<std::ptrdiff_t>(last));
    first = last;
    return flags;
  };
  const auto keep = [&](auto& cells) { cells = remaining(cells, next(cells.size())); };
  keep(mesh.hexahedra), keep(mesh.tetrahedra), keep(mesh.quadrilaterals), keep(mesh.triangles);
  const std::vector<bool> left = next(mesh.particles.size());
  mesh.particles = {remaining(mesh.particles.cells, left), remaining(mesh.particles.volumes, left)};
  return mesh;
}

}  // namespace strike
