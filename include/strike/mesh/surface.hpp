#pragma once
#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <strike/ascending.hpp>
#include <strike/error.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/tensor/tensor.hpp>
#include <strike/text.hpp>

namespace strike {

/// A face of a cell: corners counter-clockwise seen from outside; a triangle repeats its third corner.
struct Face {
  std::array<Index, 4> nodes;
  Index cell;  ///< its cell, by the number in the list that the faces were made of

  bool is_triangle() const { return nodes[2] == nodes[3]; }
};

/// Area of a face times its outward unit normal [length^2]; of a warped face the vector area.
inline Eigen::Vector3d area_vector(std::span<const Eigen::Vector3d> nodes, const Face& face) {
  using namespace detail;
  const auto& [a, b, c, d] = face.nodes;
  return 0.5 * cross<double>(nodes[c] - nodes[a], nodes[d] - nodes[b]);
}

/// Mean position of the corners of a face [length].
inline Eigen::Vector3d centroid(std::span<const Eigen::Vector3d> nodes, const Face& face) {
  using namespace detail;
  const std::size_t corners = face.is_triangle() ? 3 : 4;
  Eigen::Vector3d sum{0, 0, 0};
  for (std::size_t i = 0; i < corners; ++i) sum += nodes[face.nodes[i]];
  return (1.0 / double(corners)) * sum;
}

namespace detail {

// Faces of a cell by their corners, counter-clockwise seen from outside; a triangle repeats its third corner.
inline constexpr std::array<std::array<unsigned, 4>, 6> hexahedron_faces{
    {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
inline constexpr std::array<std::array<unsigned, 4>, 4> tetrahedron_faces{
    {{0, 2, 1, 1}, {0, 1, 3, 3}, {1, 2, 3, 3}, {2, 0, 3, 3}}};

/// The face with its repeated corner, if it has one, in the last two places; false if it has fewer than three corners.
inline bool is_face(Face& face) {
  auto& n = face.nodes;
  if (n[0] == n[2] || n[1] == n[3]) return false;
  int alike = 0;
  for (std::size_t i = 0; i < 4; ++i) alike += n[i] == n[(i + 1) % 4];
  if (alike == 1)
    while (n[2] != n[3]) std::rotate(n.begin(), n.begin() + 1, n.end());
  return alike <= 1;
}

/// Appends all faces of all cells, which are numbered from `first_cell`; of a wedge or a pyramid not those of a
/// hexahedron that have become an edge or a point.
template <std::size_t N, std::size_t F>
void append_faces(std::vector<Face>& faces, const Cells<N>& cells,
                  const std::array<std::array<unsigned, 4>, F>& corners, std::size_t first_cell) {
  for (std::size_t e = 0; e < cells.size(); ++e)
    for (const auto& [a, b, c, d] : corners) {
      Face face{{cells[e][a], cells[e][b], cells[e][c], cells[e][d]}, static_cast<Index>(first_cell + e)};
      if (N == 4 || is_face(face)) faces.push_back(face);
    }
}

/// The places of the faces that no other face of the list coincides with, in ascending order; linear in their number.
/// Error: a face shared by three cells.
inline std::vector<std::size_t> places_of_unshared(const std::vector<Face>& faces) {
  // Two cells share a face if it has the same corners in any order: bucket the faces by their lowest corner (counting
  // sort), then compare the few in each bucket.
  using Key = std::array<Index, 4>;
  std::vector<Key> key;
  Index nodes = 0;
  for (const Face& face : faces) {
    Key k = face.nodes;
    std::sort(k.begin(), k.end());
    if (face.is_triangle()) {  // one form for the repeated corner, whichever it is
      const auto last = std::unique(k.begin(), k.end());
      std::fill(last, k.end(), std::numeric_limits<Index>::max());
    }
    nodes = std::max(nodes, k[0] + 1);
    key.push_back(k);
  }
  std::vector<std::size_t> begin(std::size_t(nodes) + 1, 0), order(faces.size());
  for (const Key& k : key) ++begin[k[0] + 1];
  for (std::size_t n = 0; n < nodes; ++n) begin[n + 1] += begin[n];
  std::vector<std::size_t> end(begin.begin(), begin.end() - 1);
  for (std::size_t f = 0; f < faces.size(); ++f) order[end[key[f][0]]++] = f;

  std::vector<unsigned char> copies(faces.size(), 1);
  for (std::size_t n = 0; n < nodes; ++n)
    for (std::size_t i = begin[n]; i < begin[n + 1]; ++i)
      for (std::size_t j = begin[n]; j < begin[n + 1]; ++j)
        if (i != j && key[order[i]] == key[order[j]] && ++copies[order[i]] > 2)
          throw Error(detail::joined(
              {"strike: cells ", std::to_string(faces[order[i]].cell), " and ", std::to_string(faces[order[j]].cell),
               " share a face (nodes ", std::to_string(key[order[i]][0]), ", ", std::to_string(key[order[i]][1]), ", ",
               std::to_string(key[order[i]][2]), ", ...) with a third cell; remove the duplicate."}));

  std::vector<std::size_t> places;
  for (std::size_t f = 0; f < faces.size(); ++f)
    if (copies[f] == 1) places.push_back(f);
  return places;
}
/// The faces that no other face of the list coincides with.
inline std::vector<Face> unshared(const std::vector<Face>& faces) {
  std::vector<Face> boundary;
  for (const std::size_t f : places_of_unshared(faces)) boundary.push_back(faces[f]);
  return boundary;
}

}  // namespace detail

/// Outer faces of hexahedra, in the order of their cells. Error: a face shared by three cells.
inline std::vector<Face> hexahedron_surface(const Cells<8>& cells) {
  std::vector<Face> faces;
  detail::append_faces(faces, cells, detail::hexahedron_faces, 0);
  return detail::unshared(faces);
}

/// Outer faces of tetrahedra, in the order of their cells. Error: a face shared by three cells.
inline std::vector<Face> tetrahedron_surface(const Cells<4>& cells) {
  std::vector<Face> faces;
  detail::append_faces(faces, cells, detail::tetrahedron_faces, 0);
  return detail::unshared(faces);
}

/// Quadrilaterals as faces, which face the side from which their corners run counter-clockwise.
inline std::vector<Face> quadrilateral_surface(const Cells<4>& cells) {
  std::vector<Face> faces;
  for (std::size_t e = 0; e < cells.size(); ++e) faces.push_back({cells[e], static_cast<Index>(e)});
  return faces;
}

/// Triangles as faces, which face the side from which their corners run counter-clockwise.
inline std::vector<Face> triangle_surface(const Cells<3>& cells) {
  std::vector<Face> faces;
  for (std::size_t e = 0; e < cells.size(); ++e) {
    const auto& [a, b, c] = cells[e];
    faces.push_back({{a, b, c, c}, static_cast<Index>(e)});
  }
  return faces;
}

/// Outer faces of all cells of a mesh; `Face::cell` counts hexahedra first, then tetrahedra, then quadrilaterals, then
/// triangles. Error: a face shared by three cells.
inline std::vector<Face> surface(const Mesh& mesh) {
  std::vector<Face> faces;
  detail::append_faces(faces, mesh.hexahedra, detail::hexahedron_faces, 0);
  detail::append_faces(faces, mesh.tetrahedra, detail::tetrahedron_faces, mesh.hexahedra.size());
  faces = detail::unshared(faces);
  std::size_t first = mesh.hexahedra.size() + mesh.tetrahedra.size();
  const auto add = [&](const std::vector<Face>& plates) {
    for (const Face& plate : plates) faces.push_back({plate.nodes, static_cast<Index>(first + plate.cell)});
    first += plates.size();
  };
  add(quadrilateral_surface(mesh.quadrilaterals)), add(triangle_surface(mesh.triangles));
  return faces;
}

/// Numbers of the nodes of a surface, in ascending order.
inline std::vector<Index> surface_nodes(std::span<const Face> faces) {
  std::vector<Index> nodes;
  for (const Face& face : faces) nodes.insert(nodes.end(), face.nodes.begin(), face.nodes.end());
  return detail::ascending(std::move(nodes));
}

}  // namespace strike
