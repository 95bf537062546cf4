#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

#include <strike/mesh/mesh.hpp>

namespace strike::detail {

/// Corners of a face of a contact; a triangle repeats its third.
using FaceCorners = std::array<Index, 4>;

/// The same face seen from its other side.
inline FaceCorners turned_over(const FaceCorners& c) {
  return c[2] == c[3] ? FaceCorners{c[0], c[2], c[1], c[1]} : FaceCorners{c[0], c[3], c[2], c[1]};
}

/// Turns faces of plates over so that neighbours face the same side: a plate is touched from both, so the order of its
/// corners must not matter. The first face of each piece that hangs together by edges of two faces keeps its side;
/// edges of three and more, as in a T, separate pieces. On a band with one side only (Moebius) one seam remains.
inline void face_one_side(std::vector<FaceCorners>& faces) {
  struct Edge {
    Index low, high;
    Index face;
    bool ascends;
  };
  std::vector<Edge> edges;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const unsigned corners = faces[f][2] == faces[f][3] ? 3 : 4;
    for (unsigned i = 0; i < corners; ++i) {
      const Index from = faces[f][i], to = faces[f][(i + 1) % corners];
      edges.push_back({std::min(from, to), std::max(from, to), static_cast<Index>(f), from < to});
    }
  }
  const auto key = [](const Edge& edge) { return std::tie(edge.low, edge.high); };
  std::sort(edges.begin(), edges.end(), [&](const Edge& a, const Edge& b) { return key(a) < key(b); });

  struct Neighbour {
    Index face;
    bool faces_away;  // as the corners are numbered
  };
  std::vector<std::vector<Neighbour>> neighbours(faces.size());
  for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
    while (end < edges.size() && key(edges[end]) == key(edges[i])) ++end;
    if (end - i != 2) continue;
    const bool faces_away = edges[i].ascends == edges[i + 1].ascends;
    neighbours[edges[i].face].push_back({edges[i + 1].face, faces_away});
    neighbours[edges[i + 1].face].push_back({edges[i].face, faces_away});
  }

  enum class Side : unsigned char { unknown, kept, turned };
  std::vector<Side> side(faces.size(), Side::unknown);
  std::vector<Index> reached;
  for (std::size_t first = 0; first < faces.size(); ++first) {
    if (side[first] != Side::unknown) continue;
    side[first] = Side::kept;
    reached.push_back(static_cast<Index>(first));
    while (!reached.empty()) {
      const Index face = reached.back();
      reached.pop_back();
      for (const auto& [other, faces_away] : neighbours[face])
        if (side[other] == Side::unknown) {
          side[other] = (side[face] == Side::turned) != faces_away ? Side::turned : Side::kept;
          reached.push_back(other);
        }
    }
  }
  for (std::size_t f = 0; f < faces.size(); ++f)
    if (side[f] == Side::turned) faces[f] = turned_over(faces[f]);
}

}  // namespace strike::detail
