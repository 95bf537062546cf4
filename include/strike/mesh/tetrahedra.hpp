#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <strike/error.hpp>
#include <strike/mesh/degenerate.hpp>
#include <strike/mesh/describe.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/mesh/select.hpp>
#include <strike/mesh/surface.hpp>
#include <strike/text.hpp>

namespace strike {

/// How many tetrahedra a hexahedron is split into.
enum class Split { six, five };

namespace detail {

/// Two hexahedra on both sides of a face, and a node that they share.
struct SharedFace {
  std::size_t first, second;
  Index node;
};
/// The inner faces of hexahedra, in no order that means anything.
inline std::vector<SharedFace> shared_faces(const Cells<8>& cells) {
  std::vector<Face> faces;
  append_faces(faces, cells, hexahedron_faces, 0);
  for (Face& face : faces) std::sort(face.nodes.begin(), face.nodes.end());
  std::sort(faces.begin(), faces.end(), [](const Face& one, const Face& other) {
    return std::pair(one.nodes, one.cell) < std::pair(other.nodes, other.cell);
  });
  std::vector<SharedFace> shared;
  for (std::size_t f = 1; f < faces.size(); ++f)
    if (faces[f].nodes == faces[f - 1].nodes) shared.push_back({faces[f - 1].cell, faces[f].cell, faces[f].nodes[0]});
  return shared;
}

/// Of a hexahedron one of two sets of four corners, no two of which share an edge: true where it is that of corner 1.
/// Its lines cut all six faces, each along one diagonal. Of two hexahedra that share a face it is the same diagonal:
/// the sets are chosen from cell to cell, so that the node of lowest number of the first cell of each connected piece
/// is in. Error: a ring of hexahedra that is closed by a face for which both diagonals are asked.
inline std::vector<char> alternating_corners(const Mesh& mesh) {
  const Cells<8>& cells = mesh.hexahedra;
  const auto is_odd = [&](std::size_t e, Index node) -> bool {
    const auto corner = std::find(cells[e].begin(), cells[e].end(), node) - cells[e].begin();
    return ((corner + (corner >= 4 ? 1 : 0)) & 1) != 0;  // 0, 2, 5 and 7 are even
  };
  struct Neighbour {
    std::size_t cell;
    bool differs;
  };
  std::vector<std::vector<Neighbour>> beside(cells.size());
  for (const auto& [a, b, node] : shared_faces(cells)) {
    const bool differs = is_odd(a, node) != is_odd(b, node);
    beside[a].push_back({b, differs}), beside[b].push_back({a, differs});
  }

  constexpr char open = 2;
  std::vector<char> odd(cells.size(), open);
  for (std::size_t first = 0; first < cells.size(); ++first) {
    if (odd[first] != open) continue;
    odd[first] = 0;
    std::vector<std::size_t> piece{first};
    for (std::size_t k = 0; k < piece.size(); ++k) {
      const std::size_t e = piece[k];
      for (const auto& [other, differs] : beside[e]) {
        const char asked = (odd[e] != 0) != differs;
        if (odd[other] == open)
          odd[other] = asked, piece.push_back(other);
        else if (odd[other] != asked)
          throw Error(joined({"strike: five tetrahedra to a hexahedron do not fit at the face of hexahedra ",
                              std::to_string(std::min(e, other)), " and ", std::to_string(std::max(e, other)), " near ",
                              text(centroid<8>(mesh.nodes, cells[other])),
                              ", which closes a ring of an odd number of them; give an even number around, or split "
                              "by Split::six."}));
      }
    }
    const auto lowest = [&](std::size_t e) { return *std::min_element(cells[e].begin(), cells[e].end()); };
    const std::size_t with_lowest = *std::min_element(
        piece.begin(), piece.end(), [&](std::size_t a, std::size_t b) { return lowest(a) < lowest(b); });
    if ((odd[with_lowest] != 0) != is_odd(with_lowest, lowest(with_lowest)))
      for (const std::size_t e : piece) odd[e] = !odd[e];
  }
  return odd;
}

}  // namespace detail

/// The mesh with each hexahedron split into tetrahedra that fit those of its neighbours. It keeps all nodes. Hexahedron
/// e gives six or five tetrahedra in a row, after the tetrahedra of the mesh.
/// - Split::six: every face is cut along the diagonal from its node of lowest number (rule of Dompierre et al. 1999),
///   and the cell is the cone from its lowest node over the faces that do not touch it, three of a hexahedron. A wedge
///   gives three tetrahedra and a pyramid two.
/// - Split::five: one between four corners of which no two share an edge, a third of a cube, and one at each of the
///   others. Neighbours alternate. All shapes here can be split so, round ones too: whatever has no hole.
/// Errors: five where hexahedra go around a hole in an odd number, or of a wedge or a pyramid.
inline Mesh tetrahedralized(Mesh mesh, Split split = Split::six) {
  if (split == Split::five) {
    for (std::size_t e = 0; e < mesh.hexahedra.size(); ++e)
      if (const std::size_t corners = detail::count_different(mesh.hexahedra[e]); corners != 8)
        throw Error(detail::joined({"strike: hexahedron ", std::to_string(e), " has ", std::to_string(corners),
                                    " different corners, so it is not split into five tetrahedra; split by "
                                    "Split::six."}));
    const std::vector<char> odd = detail::alternating_corners(mesh);
    for (std::size_t e = 0; e < mesh.hexahedra.size(); ++e) {
      const auto& c = mesh.hexahedra[e];
      // The cell turned by a right angle, if need be, so that its corners 0, 2, 5 and 7 are those of the set.
      const auto& [a, b, d, f, p, q, r, s] = odd[e] ? std::array{c[1], c[2], c[3], c[0], c[5], c[6], c[7], c[4]} : c;
      for (const std::array<Index, 4>& cell :
           {std::array{a, d, s, q}, {a, b, d, q}, {a, d, f, s}, {a, q, s, p}, {d, s, q, r}})
        mesh.tetrahedra.push_back(cell);
    }
    mesh.hexahedra.clear();
    return mesh;
  }
  for (const auto& cell : mesh.hexahedra) {
    const Index apex = *std::min_element(cell.begin(), cell.end());
    for (const auto& corners : detail::hexahedron_faces) {
      Face face{{cell[corners[0]], cell[corners[1]], cell[corners[2]], cell[corners[3]]}, 0};
      if (!detail::is_face(face) || std::find(face.nodes.begin(), face.nodes.end(), apex) != face.nodes.end()) continue;
      if (!face.is_triangle())
        std::rotate(face.nodes.begin(), std::min_element(face.nodes.begin(), face.nodes.end()), face.nodes.end());
      const auto& [a, b, c, d] = face.nodes;  // clockwise seen from the apex, which is inside
      mesh.tetrahedra.push_back({a, c, b, apex});
      if (!face.is_triangle()) mesh.tetrahedra.push_back({a, d, c, apex});
    }
  }
  mesh.hexahedra.clear();
  return mesh;
}

}  // namespace strike
