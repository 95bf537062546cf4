#include <algorithm>
#include <set>

#include <strike/mesh/box.hpp>
#include <strike/mesh/check.hpp>
#include <strike/mesh/measure.hpp>

#include "support/catch.hpp"

using namespace strike;

TEST_CASE("box fills the brick with right-handed hexahedra") {
  const Mesh mesh = box({.lower = {1, -2, 3}, .size = {2, 3, 5}, .cells = {4, 3, 2}});
  CHECK(mesh.nodes.size() == 5 * 4 * 3);
  CHECK(mesh.hexahedra.size() == 4 * 3 * 2);
  CHECK_NOTHROW(check(mesh));
  CHECK(volume(mesh) == Approx(2 * 3 * 5).epsilon(1e-14));  // rounding
  for (const auto& cell : mesh.hexahedra) CHECK(hexahedron_volume(mesh.nodes, cell) == Approx(1.25).epsilon(1e-13));
  CHECK(mesh.nodes.front() == Eigen::Vector3d(1, -2, 3));  // corners are exact
  CHECK(mesh.nodes.back() == Eigen::Vector3d(3, 1, 8));
}

TEST_CASE("box numbers nodes and cells with x fastest, z slowest") {
  const Mesh mesh = box({.size = {1, 1, 1}, .cells = {2, 1, 1}});
  CHECK(mesh.nodes[1] == Eigen::Vector3d(0.5, 0, 0));
  CHECK(mesh.nodes[3] == Eigen::Vector3d(0, 1, 0));
  CHECK(mesh.nodes[6] == Eigen::Vector3d(0, 0, 1));
  CHECK(mesh.hexahedra[1] == std::array<Index, 8>{1, 2, 5, 4, 7, 8, 11, 10});
}

TEST_CASE("box grades cells geometrically") {
  const Mesh mesh = box({.size = {7, 1, 1}, .cells = {3, 1, 1}, .grading = {4, 1, 1}});  // 1 + 2 + 4
  CHECK(mesh.nodes[1][0] == Approx(1).epsilon(1e-14));
  CHECK(mesh.nodes[2][0] == Approx(3).epsilon(1e-14));
  CHECK(mesh.nodes[3][0] == 7);
}
