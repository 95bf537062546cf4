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

/// The cells that are left, in their order; `alive[e]` says it of cell e (see RunningPart::alive). Also for values of
/// cells. Error: another number of them.
template <class Row>
std::vector<Row> remaining(const std::vector<Row>& rows, const std::vector<bool>& alive) {
  if (rows.size() != alive.size())
    throw Error(detail::joined({"There are ", std::to_string(rows.size()), " cells or values, but ",
                                std::to_string(alive.size()), " say whether they are left: give one for each."}));
  std::vector<Row> left;
  for (std::size_t e = 0; e < rows.size(); ++e)
    if (alive[e]) left.push_back(rows[e]);
  return left;
}

/// The mesh with the cells that are left, counted together; its nodes stay. `orphan_nodes` of it fly freely.
inline Mesh remaining(Mesh mesh, const std::vector<bool>& alive) {
  std::size_t first = 0;
  const auto keep = [&](auto& cells) {
    const std::size_t last = std::min(first + cells.size(), alive.size());
    cells = remaining(cells, std::vector<bool>(alive.begin() + static_cast<std::ptrdiff_t>(first),
                                               alive.begin() + static_cast<std::ptrdiff_t>(last)));
    first = last;
  };
  keep(mesh.hexahedra), keep(mesh.tetrahedra), keep(mesh.quadrilaterals);
  return mesh;
}

}  // namespace strike
