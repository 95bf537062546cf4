#include <algorithm>
#include <array>
#include <limits>
#include <numbers>
#include <numeric>
#include <string>
#include <utility>

#include <Eigen/Geometry>

#include <strike/mesh/bird.hpp>
#include <strike/mesh/box.hpp>
#include <strike/mesh/canopy.hpp>
#include <strike/mesh/check.hpp>
#include <strike/mesh/cylinder.hpp>
#include <strike/mesh/disc.hpp>
#include <strike/mesh/sheet.hpp>
#include <strike/mesh/sphere.hpp>
#include <strike/mesh/tetrahedra.hpp>
#include <strike/mesh/transform.hpp>

#include "right.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"

using namespace strike;
using testing::is_right;

namespace {

/// Of all orders of the corners of a cell those that are right.
template <std::size_t N>
int right_orders(Mesh mesh, Cells<N> Mesh::*cells) {
  std::array<Index, N> order;
  std::iota(order.begin(), order.end(), Index{0});
  int right = 0;
  do {
    (mesh.*cells)[0] = order;
    right += is_right(mesh);
  } while (std::next_permutation(order.begin(), order.end()));
  return right;
}

/// A brick whose top is turned by an angle [rad].
Mesh twisted(double angle) {
  Mesh mesh = box({.lower = {-1, -1, -1}, .size = {2, 2, 2}});
  for (auto& x : mesh.nodes)
    if (x[2] > 0) x = Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()) * x;
  return mesh;
}

}  // namespace

TEST_CASE("check: of all orders of its corners a cell has those that turn it onto itself") {
  const Mesh skew = transformed(box({.size = {1, 1, 1}}), [](const auto& x) -> Eigen::Vector3d {
    return {x[0] + 0.6 * x[1], x[1] - 0.5 * x[2], x[2] * (2 + x[0])};
  });
  CHECK(right_orders(skew, &Mesh::hexahedra) == 24);
  CHECK(right_orders(Mesh{.nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, .tetrahedra = {{}}},
                     &Mesh::tetrahedra) == 12);
  CHECK(right_orders(Mesh{.nodes = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, .quadrilaterals = {{}}},
                     &Mesh::quadrilaterals) == 8);  // either side may face up
}

TEST_CASE("check names a hexahedron whose top is turned, which no corner shows") {
  for (const double degrees : {0, 30, -59}) CHECK(is_right(twisted(degrees * std::numbers::pi / 180)));
  for (const double degrees : {61, -75, 90, 180}) CHECK(!is_right(twisted(degrees * std::numbers::pi / 180)));
  Mesh mesh = box({.size = {1, 1, 1}});
  std::rotate(&mesh.hexahedra[0][4], &mesh.hexahedra[0][5], &mesh.hexahedra[0][7] + 1);
  CHECK_THROWS_WITH(check(mesh),
                    "strike: hexahedron 0 at (0.5, 0.5, 0.5) is twisted: corners 4 5 6 7 are turned against 0 1 2 3 by "
                    "90 degrees; order its corners 0-3 around the bottom and 4-7 above them, right-handed.");
}

TEST_CASE("check: size and place of a mesh do not matter") {
  for (const double size : {1e-6, 1.0, 1e6})
    for (const double away : {0.0, 1e3}) {
      const auto placed = [&](const Mesh& mesh) {
        return translated(transformed(mesh, [&](const auto& x) { return Eigen::Vector3d(size * x); }),
                          {away * size, -away * size, away});
      };
      CHECK(is_right(placed(box({.size = {1, 1, 1}, .cells = {2, 2, 2}}))));
      CHECK(is_right(placed(box({.size = {1, 1e-4, 1}}))));
      CHECK(is_right(placed(box({.size = {1, 1e-2, 1e-2}}))));
      CHECK(!is_right(placed(twisted(std::numbers::pi / 2))));
      if (size < 1 && away > 0 && !testing::is_sanitized())  // 8! orders, each an error with its sentence
        CHECK(right_orders(placed(box({.size = {1, 0.5, 2}})), &Mesh::hexahedra) == 24);
    }
}

TEST_CASE("check: a cell is right up to the edge, and wrong beyond it") {
  Mesh mesh = box({.size = {1, 1, 1}});
  const auto pushed = [&](double depth) {  // a corner, along the diagonal, to where its three edges are coplanar
    mesh.nodes[7] = (1 - depth) * Eigen::Vector3d(1, 1, 1);
    return mesh;
  };
  CHECK(is_right(pushed(1. / 3 - 1e-6)));  // at 1/3 it lies in the plane of its three neighbours
  CHECK(!is_right(pushed(1. / 3 + 1e-6)));
  CHECK(hexahedron_volume(mesh.nodes, mesh.hexahedra[0]) > 0);
}

TEST_CASE("check: the meshes of strike are right") {
  CHECK_NOTHROW(check(sphere({.radius = 1})));
  CHECK_NOTHROW(check(tetrahedralized(sphere({.radius = 1}))));
  CHECK_NOTHROW(check(cylinder({.radius = 1, .length = 2})));
  CHECK_NOTHROW(check(disc({.radius = 1})));
  CHECK_NOTHROW(check(bird({.mass = 1.8, .density = 950, .form = BirdForm::ellipsoid})));
  CHECK_NOTHROW(check(bird({.mass = 1.8, .density = 950, .form = BirdForm::hemispherical_ends})));
  CHECK_NOTHROW(
      check(canopy({.length = 5, .top = 2, .height = {0.5, 1, 0.3}, .half_width = {1, 1.2, 0.5}, .cells = {4, 8}})));
}

TEST_CASE("check: a quadrilateral that names a corner twice in a row is a triangle") {
  Mesh mesh{.nodes = {{0, 0, 0}, {2, 0, 0}, {1, 2, 0}}, .quadrilaterals = {{}}};
  for (const std::array<Index, 4> triangle :
       {std::array<Index, 4>{0, 1, 2, 2}, {0, 1, 1, 2}, {2, 0, 1, 2}, {1, 1, 0, 2}}) {
    mesh.quadrilaterals[0] = triangle;
    CHECK_NOTHROW(check(mesh));
  }
  for (const std::array<Index, 4> line : {std::array<Index, 4>{0, 1, 0, 2}, {0, 2, 1, 2}, {0, 0, 1, 1}, {2, 2, 2, 2}}) {
    mesh.quadrilaterals[0] = line;
    CHECK_THROWS_WITH(check(mesh), Catch::Matchers::ContainsSubstring(
                                       "twice; give it 4 different corners, or 3 of which one stands twice in a row."));
  }
  mesh.nodes[2] = {1, 0, 0};
  mesh.quadrilaterals[0] = {0, 1, 2, 2};
  CHECK_THROWS_WITH(check(mesh), Catch::Matchers::ContainsSubstring("is crossed, concave or flat at corner"));
}

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
  CHECK_THROWS_WITH(
      check(mesh),
      "strike: hexahedron 0 at (0.428571, 0.857143, 1.14286) names node 1 twice; give it 8 different corners, "
      "or make it a wedge a b c c d e f f or a pyramid a b c d e e e e.");
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
