#include <strike/mesh/box.hpp>
#include <strike/mesh/mixed_cells.hpp>
#include <strike/mesh/tetrahedra.hpp>

#include "support/catch.hpp"

using namespace strike;
using Catch::Matchers::ContainsSubstring;

namespace {
using List = std::vector<std::vector<Index>>;
SortedCells sorted(const List& cells) { return sorted_by_kind(std::vector<Eigen::Vector3d>(10), cells); }
}  // namespace

TEST_CASE("mixed cells: five nodes are a tetrahedron, four a quadrilateral, eight a hexahedron, three a triangle") {
  const SortedCells s =
      sorted({{0, 1, 2, 3, 0}, {4, 5, 6, 7}, {0, 1, 2, 3, 4, 5, 6, 7}, {7, 8, 9}, {5, 6, 7, 8, 5}, {1, 2, 9, 9}});
  CHECK(s.mesh.nodes.size() == 10);
  CHECK(s.mesh.hexahedra == Cells<8>{{0, 1, 2, 3, 4, 5, 6, 7}});
  CHECK(s.mesh.tetrahedra == Cells<4>{{0, 1, 2, 3}, {5, 6, 7, 8}});
  CHECK(s.mesh.quadrilaterals == Cells<4>{{4, 5, 6, 7}, {1, 2, 9, 9}});
  CHECK(s.mesh.triangles == Cells<3>{{7, 8, 9}});
  CHECK(s.number == std::vector<Index>{2, 0, 4, 1, 5, 3});
}

TEST_CASE("mixed cells: a mesh that is written as one list comes back") {
  const Mesh mesh = tetrahedralized(box({.size = {1, 1, 1}, .cells = {2, 2, 2}}));
  List list;
  for (const auto& [a, b, c, d] : mesh.tetrahedra) list.push_back({a, b, c, d, a});
  CHECK(sorted_by_kind(mesh.nodes, list).mesh.tetrahedra == mesh.tetrahedra);
}

TEST_CASE("mixed cells: what is no cell is refused in a sentence") {
  const auto refused = [](const std::vector<Index>& cell, const char* sentence) {
    CHECK_THROWS_WITH(sorted({{0, 1, 2, 3}, cell}),
                      ContainsSubstring("strike: cell 1 ") && ContainsSubstring(sentence));
  };
  refused({0, 1, 2, 3, 4}, "names five nodes, and the last is not the first; write a tetrahedron as a b c d a.");
  refused({0, 1, 2, 2, 0}, "is a tetrahedron that names node 2 twice");
  refused({0, 1, 2, 2, 4, 4, 4, 4}, "is a hexahedron that names node 2 twice");
  refused({0, 1, 0, 2}, "is a quadrilateral of fewer than three corners");
  refused({0, 0, 1, 1}, "is a quadrilateral of fewer than three corners");
  refused({0, 1, 0}, "is a triangle that names node 0 twice; give it three different corners.");
  refused({0, 1},
          "names 2 nodes; give eight of a hexahedron, five of a tetrahedron (a b c d a), four of a quadrilateral or "
          "three of a triangle.");
  refused({}, "names 0 nodes");
  refused({0, 1, 2, 10}, "names node 10, but there are 10 nodes; count them from 0.");
}
