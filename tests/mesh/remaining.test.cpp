#include <strike/draw/picture.hpp>
#include <strike/mesh/box.hpp>
#include <strike/mesh/remaining.hpp>
#include <strike/mesh/surface.hpp>

#include "support/catch.hpp"

using namespace strike;

TEST_CASE("remaining: the cells that are left, their values, and the nodes of the others") {
  Mesh mesh = box({.size = {3, 1, 1}, .cells = {3, 1, 1}});
  mesh.quadrilaterals = {{0, 1, 5, 4}};
  mesh.triangles = {{0, 1, 5}, {0, 5, 4}};
  const std::vector<bool> alive{true, false, false, true, false, true};
  const Mesh left = remaining(mesh, alive);
  CHECK(left.nodes.size() == mesh.nodes.size());
  CHECK(left.hexahedra == Cells<8>{mesh.hexahedra[0]});
  CHECK(left.quadrilaterals == mesh.quadrilaterals);
  CHECK(left.triangles == Cells<3>{{0, 5, 4}});
  CHECK(remaining(std::vector<double>{1, 2, 3, 4, 5, 6}, alive) == std::vector<double>{1, 4, 6});
  CHECK(orphan_nodes(left).size() == 8);
  CHECK_THROWS(remaining(std::vector<double>{1}, alive));
}

TEST_CASE("picture: nodes without elements are small circles, mirrored with the rest") {
  const Mesh mesh = box({.size = {1, 1, 1}, .cells = {1, 1, 1}});
  Picture picture{{.mirror = {Axis::x}}};
  picture.add(surface(mesh), mesh.nodes);
  const std::vector<Eigen::Vector3d> debris{{2, 0, 0}, {3, 0, 0}};
  picture.add_particles(debris);
  const std::string svg = picture.svg();
  std::size_t circles = 0;
  for (std::size_t at = svg.find("<circle"); at != std::string::npos; at = svg.find("<circle", at + 1)) ++circles;
  CHECK(circles == 4);
}
