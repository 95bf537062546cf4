#include <limits>
#include <utility>

#include <strike/mesh/box.hpp>
#include <strike/mesh/check.hpp>

#include "support/catch.hpp"

using namespace strike;

TEST_CASE("check: a sound mesh passes, slender cells too") {
  CHECK_NOTHROW(check(box({.size = {1, 1, 1}, .cells = {3, 3, 3}})));
  CHECK_NOTHROW(check(box({.size = {1, 1e4, 1e-4}})));  // 1e8 to 1 and still a brick
  CHECK_NOTHROW(check(Mesh{}));
}

TEST_CASE("check names a node that does not exist") {
  Mesh mesh = box({.size = {1, 1, 1}, .cells = {2, 1, 1}});
  mesh.hexahedra[1][6] = 12;
  CHECK_THROWS_WITH(check(mesh),
                    "strike: hexahedron 1 names node 12, but the mesh has 12 nodes; count them from 0 and correct "
                    "the cell.");
}

TEST_CASE("check names a node that a cell has twice") {
  Mesh mesh = box({.size = {2, 2, 2}, .cells = {2, 1, 1}});
  mesh.hexahedra[0][2] = mesh.hexahedra[0][1];
  CHECK_THROWS_WITH(check(mesh),
                    "strike: hexahedron 0 at (0.5, 0.75, 1) names node 1 twice; give it 8 different corners.");
}

TEST_CASE("check names a hexahedron that is inside out, flat or crossed, and where") {
  Mesh mesh = box({.size = {2, 2, 2}, .cells = {2, 1, 1}});
  const Mesh sound = mesh;
  for (unsigned i = 0; i < 4; ++i) std::swap(mesh.hexahedra[1][i], mesh.hexahedra[1][i + 4]);
  CHECK_THROWS_WITH(
      check(mesh),
      "strike: hexahedron 1 at (1.5, 1, 1) is flat or inside out at corner 0 (volume -4); order its corners 0-3 "
      "around the bottom and 4-7 above them, right-handed.");
  mesh = sound;
  for (auto& x : mesh.nodes) x[1] = 0;
  CHECK_THROWS_WITH(check(mesh), Catch::Matchers::ContainsSubstring("flat or inside out at corner 0 (volume 0)"));
  mesh = sound;
  std::swap(mesh.hexahedra[0][2], mesh.hexahedra[0][3]);  // bow tie
  CHECK_THROWS_WITH(check(mesh),
                    Catch::Matchers::ContainsSubstring("strike: hexahedron 0 at (0.5, 1, 1) is flat or inside out"));
  mesh = sound;
  mesh.nodes[4][2] = 3;  // a bottom corner pushed through the top: only the corner shows it, not the volume
  CHECK_THROWS_WITH(check(mesh), Catch::Matchers::ContainsSubstring("(volume 2.5"));
}

TEST_CASE("check names a tetrahedron that is inside out") {
  const Mesh mesh{.nodes = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}}, .tetrahedra = {{0, 2, 1, 3}}};
  CHECK_THROWS_WITH(
      check(mesh),
      "strike: tetrahedron 0 at (1, 1, 1) is flat or inside out (volume -10.6667); order its corners so that 3 "
      "lies above the counter-clockwise 0-1-2.");
}

TEST_CASE("check names a quadrilateral that is crossed or concave") {
  Mesh mesh{.nodes = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}, .quadrilaterals = {{0, 1, 2, 3}}};
  CHECK_NOTHROW(check(mesh));
  mesh.quadrilaterals[0] = {3, 2, 1, 0};
  CHECK_NOTHROW(check(mesh));  // the other side is no fault
  mesh.quadrilaterals[0] = {0, 2, 1, 3};
  CHECK_THROWS_WITH(
      check(mesh),
      "strike: quadrilateral 0 at (1, 1, 0) is crossed, concave or flat at corner 0; list its corners in order "
      "around a convex shape.");
  mesh.quadrilaterals[0] = {0, 1, 2, 3};
  mesh.nodes[2] = {0.5, 0.5, 0};
  CHECK_THROWS_WITH(check(mesh), Catch::Matchers::ContainsSubstring("flat at corner 2"));
}

TEST_CASE("check names nodes without a cell and nodes without a place") {
  Mesh mesh = box({.size = {1, 1, 1}});
  mesh.nodes.emplace_back(5, 6, 7);
  CHECK_THROWS_WITH(check(mesh),
                    "strike: node 8 at (5, 6, 7) belongs to no cell, so it has no mass (one of 1); call "
                    "remove_orphan_nodes(mesh).");
  CHECK_NOTHROW(check(remove_orphan_nodes(mesh)));
  mesh.nodes[3][1] = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH(check(mesh),
                    Catch::Matchers::ContainsSubstring("strike: node 3 at (1, nan, 0) has no finite position"));
}
