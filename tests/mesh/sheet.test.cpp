#include <cmath>
#include <numbers>

#include <strike/mesh/check.hpp>
#include <strike/mesh/measure.hpp>
#include <strike/mesh/sheet.hpp>

#include "support/catch.hpp"

using namespace strike;
using std::numbers::pi;

namespace {
double area(const Mesh& mesh) {
  double sum = 0;
  for (const auto& cell : mesh.quadrilaterals) sum += quadrilateral_area(mesh.nodes, cell);
  return sum;
}
}  // namespace

TEST_CASE("rectangle fills its area with quadrilaterals that face +z, x fastest") {
  const Mesh mesh = rectangle({.lower = {1, -2, 3}, .size = {2, 3}, .cells = {4, 3}});
  CHECK(mesh.nodes.size() == 5 * 4);
  CHECK(mesh.quadrilaterals.size() == 4 * 3);
  CHECK_NOTHROW(check(mesh));
  for (const auto& cell : mesh.quadrilaterals)
    CHECK((area_vector(mesh.nodes, Face{cell, 0}) - Eigen::Vector3d(0, 0, 0.5)).norm() < 1e-15);
  CHECK(mesh.nodes.front() == Eigen::Vector3d(1, -2, 3));  // corners are exact
  CHECK(mesh.nodes[1] == Eigen::Vector3d(1.5, -2, 3));
  CHECK(mesh.nodes.back() == Eigen::Vector3d(3, 1, 3));
  CHECK(mesh.quadrilaterals[5] == std::array<Index, 4>{6, 7, 12, 11});
}

TEST_CASE("a panel has n chords of 2 R sin(a/(2 n)), its nodes on the cylinder, and faces outward") {
  const PanelShape shape{.radius = 3, .length = 5, .arc = {-0.4, 1.1}, .cells = {7, 2}};
  const Mesh mesh = panel(shape);
  CHECK_NOTHROW(check(mesh));
  CHECK(area(mesh) == Approx(5 * 7 * 2 * 3 * std::sin(1.5 / 14)).epsilon(1e-14));
  for (const Eigen::Vector3d& x : mesh.nodes) CHECK(std::hypot(x.x(), x.z()) == Approx(3).epsilon(1e-15));
  CHECK((mesh.nodes.front() - Eigen::Vector3d(3 * std::sin(-0.4), 0, 3 * std::cos(0.4))).norm() < 1e-15);
  CHECK((mesh.nodes.back() - Eigen::Vector3d(3 * std::sin(1.1), 5, 3 * std::cos(1.1))).norm() < 1e-15);
  for (const auto& cell : mesh.quadrilaterals) {
    const Eigen::Vector3d middle = centroid<4>(mesh.nodes, cell), outward(middle.x(), 0, middle.z());
    CHECK(area_vector(mesh.nodes, Face{cell, 0}).normalized().dot(outward.normalized()) == Approx(1).epsilon(1e-14));
  }
}

TEST_CASE("the area of a panel tends to R a L as its squares") {
  const auto error = [](Index n) {
    return 1 - area(panel({.radius = 1, .length = 1, .arc = {0, pi / 3}, .cells = {n, 1}})) / (pi / 3);
  };
  CHECK(error(8) == Approx(std::pow(pi / 3 / 8, 2) / 24).epsilon(1e-3));  // the next term is a^2/80 of it
  CHECK(error(8) / error(16) == Approx(4).epsilon(1e-3));
}

TEST_CASE("a sheet lies where its function says") {
  const Mesh dome = sheet({2, 3}, [](double s, double t) { return Eigen::Vector3d(s, t, s * t); });
  CHECK(dome.nodes[7] == Eigen::Vector3d(0.5, 2. / 3, 0.5 * 2. / 3));
  CHECK(dome.quadrilaterals.size() == 6);
}
