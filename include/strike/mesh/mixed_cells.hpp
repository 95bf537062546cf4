#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <strike/error.hpp>
#include <strike/mesh/degenerate.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/text.hpp>

namespace strike {

/// A mesh from a list of cells of several kinds.
struct SortedCells {
  Mesh mesh;
  std::vector<Index> number;  ///< number in the list of each cell of the mesh, all kinds counted together
};

/// The mesh of a list of cells of all kinds, told apart by the nodes that they name, counted from 0: eight are a
/// hexahedron (a wedge or pyramid repeats corners), four a quadrilateral, three a
/// triangle, and five of which the last repeats the first
/// a tetrahedron (the input of X3D). A quadrilateral may name two neighbouring corners
/// alike and stays one. Cells of
/// a kind keep their order. Errors: any other list of nodes; a node that is not there.
inline SortedCells sorted_by_kind(std::vector<Eigen::Vector3d> nodes, std::span<const std::vector<Index>> cells) {
  SortedCells sorted{{.nodes = std::move(nodes)}, {}};
  Mesh& mesh = sorted.mesh;
  std::vector<Index> hexahedra, tetrahedra, quadrilaterals, triangles;
  for (std::size_t e = 0; e < cells.size(); ++e) {
    const std::vector<Index>& cell = cells[e];
    const auto refuse = [&](const std::string& why) {
      throw Error(detail::joined({"strike: cell ", std::to_string(e), " ", why}));
    };
    const auto corners = [&]<std::size_t N>(std::array<Index, N> taken) {
      std::copy_n(cell.begin(), N, taken.begin());
      return taken;
    };
    const auto refuse_repeated = [&](std::size_t count, const char* kind, const char* advice) {
      for (std::size_t i = 0; i < count; ++i)
        if (std::find(cell.begin(), cell.begin() + static_cast<std::ptrdiff_t>(i), cell[i]) !=
            cell.begin() + static_cast<std::ptrdiff_t>(i))
          refuse(detail::joined({"is a ", kind, " that names node ", std::to_string(cell[i]), " twice; ", advice}));
    };
    for (const Index node : cell)
      if (node >= mesh.nodes.size())
        refuse(detail::joined({"names node ", std::to_string(node), ", but there are ",
                               std::to_string(mesh.nodes.size()), " nodes; count them from 0."}));
    const auto number = static_cast<Index>(e);
    if (cell.size() == 8) {
      const auto canonical = canonical_hexahedron(corners(std::array<Index, 8>{}));
      if (!canonical)
        refuse_repeated(8, "hexahedron",
                        "give it eight different corners, or make it a wedge a b c c d e f f or a pyramid a b c d e e "
                        "e e, and write a tetrahedron as a b c d a.");
      mesh.hexahedra.push_back(*canonical), hexahedra.push_back(number);
    } else if (cell.size() == 5) {
      if (cell[4] != cell[0])
        refuse("names five nodes, and the last is not the first; write a tetrahedron as a b c d a.");
      refuse_repeated(4, "tetrahedron", "give it four different corners.");
      mesh.tetrahedra.push_back(corners(std::array<Index, 4>{})), tetrahedra.push_back(number);
    } else if (cell.size() == 4) {
      std::size_t alike = 0;
      for (std::size_t i = 0; i < 4; ++i) alike += cell[i] == cell[(i + 1) % 4];
      if (alike > 1 || cell[0] == cell[2] || cell[1] == cell[3])
        refuse("is a quadrilateral of fewer than three corners; give it three or four different ones in order.");
      mesh.quadrilaterals.push_back(corners(std::array<Index, 4>{})), quadrilaterals.push_back(number);
    } else if (cell.size() == 3) {
      refuse_repeated(3, "triangle", "give it three different corners.");
      mesh.triangles.push_back(corners(std::array<Index, 3>{})), triangles.push_back(number);
    } else {
      refuse(detail::joined({"names ", std::to_string(cell.size()),
                             " nodes; give eight of a hexahedron, five of a tetrahedron (a b c d a), four of a "
                             "quadrilateral or three of a "
                             "triangle."}));
    }
  }
  for (const auto* kind : {&hexahedra, &tetrahedra, &quadrilaterals, &triangles})
    sorted.number.insert(sorted.number.end(), kind->begin(), kind->end());
  return sorted;
}

}  // namespace strike
