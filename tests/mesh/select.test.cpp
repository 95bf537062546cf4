#include <cmath>

#include <strike/mesh/box.hpp>
#include <strike/mesh/cylinder.hpp>
#include <strike/mesh/select.hpp>
#include <strike/mesh/transform.hpp>

#include "support/catch.hpp"

using namespace strike;

TEST_CASE("nodes_where finds planes, whatever the unit of length and the place of the mesh") {
  const Mesh bar = cylinder({.radius = 3.2, .length = 32.4, .cells = 3, .layers = 10});
  for (const double unit_of_length : {1e-3, 1.0, 1e3}) {
    const Mesh mesh = scaled(bar, Eigen::Vector3d::Constant(unit_of_length));
    CHECK(nodes_where(mesh.nodes, on_plane(Axis::z, 0)).size() == 37);
    CHECK(nodes_where(mesh.nodes, on_plane(Axis::z, 32.4 * unit_of_length)).size() == 37);
    CHECK(nodes_where(mesh.nodes, on_plane(Axis::x, 0)).size() == 11 * 7);
    CHECK(nodes_where(mesh.nodes, on_plane(Axis::y, 0)).size() == 11 * 7);
    CHECK(nodes_where(mesh.nodes, on_cylinder({0, 0, 0}, {0, 0, 1}, 3.2 * unit_of_length)).size() == 11 * 7);
  }
  const Mesh moved = translated(rotated(bar, {1, 2, 3}, 0.7), {5, -4, 1});
  const Eigen::Vector3d n = rotated(Mesh{.nodes = {{0, 0, 1}}}, {1, 2, 3}, 0.7).nodes[0];
  CHECK(nodes_where(moved.nodes, on_plane(3 * n, n.dot(Eigen::Vector3d(5, -4, 1)))).size() == 37);  // any length of n
}

TEST_CASE("nodes_where and cells_where take any condition on a position, and answer in ascending order") {
  const Mesh mesh = box({.size = {4, 1, 1}, .cells = {4, 1, 1}});
  CHECK(nodes_where(mesh.nodes, [](const Eigen::Vector3d& x) { return x[0] > 3.5; }) ==
        std::vector<Index>{4, 9, 14, 19});
  CHECK(cells_where(mesh.nodes, mesh.hexahedra, [](const Eigen::Vector3d& x) { return x[0] < 2; }) ==
        std::vector<Index>{0, 1});
  CHECK(cells_of(mesh.hexahedra, std::vector<Index>{1})[0] == mesh.hexahedra[1]);
  CHECK(nodes_where(mesh.nodes, in_box({0, 0, 0}, {1, 1, 0})) == std::vector<Index>{0, 1, 5, 6});
  CHECK(nodes_where(mesh.nodes, in_sphere({0, 0, 0}, 1)) == std::vector<Index>{0, 1, 5, 10});
  CHECK(nodes_where(mesh.nodes, on_plane(Axis::x, 2.5)).empty());
}

TEST_CASE("nearest_node is the nearest, the lowest of several") {
  const Mesh mesh = box({.size = {4, 1, 1}, .cells = {4, 1, 1}});
  CHECK(nearest_node(mesh.nodes, {2.1, 0.9, -3}) == 7);
  CHECK(nearest_node(mesh.nodes, {0.5, 0, 0}) == 0);
  CHECK_THROWS_WITH(nearest_node({}, {0, 0, 0}),
                    "strike: a mesh without nodes has no nearest node; build or read the mesh first.");
}
