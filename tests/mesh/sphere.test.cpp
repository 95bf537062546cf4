#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <strike/mesh/check.hpp>
#include <strike/mesh/measure.hpp>
#include <strike/mesh/select.hpp>
#include <strike/mesh/sphere.hpp>
#include <strike/mesh/surface.hpp>
#include <strike/mesh/tetrahedra.hpp>

#include "support/catch.hpp"
#include "support/sanitized.hpp"

using namespace strike;
using std::numbers::pi;

namespace {

/// Scaled Jacobian of the worst corner, and the largest ratio of two edges of a cell.
std::pair<double, double> quality(const Mesh& mesh) {
  constexpr std::array<std::array<std::size_t, 3>, 8> neighbours{
      {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7}, {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}}};
  double worst = 1, slender = 1;
  for (const auto& cell : mesh.hexahedra) {
    double shortest = std::numeric_limits<double>::infinity(), longest = 0;
    for (std::size_t i = 0; i < 8; ++i) {
      const auto edge = [&](std::size_t k) {
        return Eigen::Vector3d(mesh.nodes[cell[neighbours[i][k]]] - mesh.nodes[cell[i]]);
      };
      worst = std::min(worst, detail::CornerJacobian<double>(edge(0), edge(1), edge(2)).scaled());
      for (std::size_t k = 0; k < 3; ++k)
        shortest = std::min(shortest, edge(k).norm()), longest = std::max(longest, edge(k).norm());
    }
    slender = std::max(slender, longest / shortest);
  }
  return {worst, slender};
}

}  // namespace

TEST_CASE("sphere: volume tends to 4/3 pi R^3, and every corner of every cell is far from flat") {
  const double R = 2.5;
  for (const auto& [sector, octants] : {std::pair{Sector::quarter, 2u}, {Sector::half, 4u}, {Sector::full, 8u}}) {
    double error = 0;
    for (const Index n : {1u, 2u, 4u, 8u}) {
      if (n == 8 && testing::is_sanitized()) continue;
      const Mesh ball = sphere({.radius = R, .cells = n, .sector = sector});
      CAPTURE(n, octants);
      CHECK(ball.hexahedra.size() == std::size_t(octants) * 4 * n * n * n);
      CHECK_NOTHROW(check(ball));
      const auto [worst, slender] = quality(ball);
      CHECK(worst > 0.74);
      CHECK(slender < 2.1);
      const double round = octants * pi / 6 * R * R * R, last = error;
      error = (round - volume(ball)) / round;
      CHECK(error < 0.271 / (n * n));
      if (n > 1) CHECK(last / error == Approx(4).epsilon(0.11));  // second order; from one cell to two 3.6
    }
  }
}

TEST_CASE("sphere: surface nodes lie on the radius, planes of symmetry are exact, and the skin is closed") {
  const Mesh ball = sphere({.radius = 3, .cells = 4});
  const auto skin = surface(ball);
  CHECK(skin.size() == 6 * 4 * 4 * 4);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Face& face : skin) {
    sum += area_vector(ball.nodes, face);
    CHECK(area_vector(ball.nodes, face).dot(centroid(ball.nodes, face)) > 0);
  }
  CHECK(sum.norm() < 1e-13);
  const auto outer = surface_nodes(skin);
  CHECK(outer.size() == skin.size() + 2);  // Euler
  for (const Index i : outer) CHECK(std::abs(ball.nodes[i].norm() - 3) < 1e-15);
  for (std::size_t i = 0; i < ball.nodes.size(); ++i) {
    if (!std::binary_search(outer.begin(), outer.end(), i)) CHECK(ball.nodes[i].norm() < 2.9);
    for (int axis = 0; axis < 3; ++axis) CHECK((ball.nodes[i][axis] == 0 || std::abs(ball.nodes[i][axis]) > 0.01));
  }
  CHECK_NOTHROW(check(tetrahedralized(ball)));
}

TEST_CASE("sphere: an octant is the upper half of a quarter") {
  Mesh ball = sphere({.radius = 1, .cells = 2, .sector = Sector::quarter});
  const auto above = [](const auto& x) { return x[2] > 0; };
  ball.hexahedra = cells_of(ball.hexahedra, cells_where(ball.nodes, ball.hexahedra, above));
  ball = remove_orphan_nodes(ball);
  CHECK(ball.hexahedra.size() == 4 * 8);
  CHECK_NOTHROW(check(ball));
  for (const auto& x : ball.nodes) CHECK(x.minCoeff() >= 0);
}
