#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <strike/mesh/bird.hpp>
#include <strike/mesh/box.hpp>
#include <strike/mesh/check.hpp>
#include <strike/mesh/cylinder.hpp>
#include <strike/mesh/measure.hpp>
#include <strike/mesh/sphere.hpp>
#include <strike/mesh/tetrahedra.hpp>

#include "support/catch.hpp"

using namespace strike;

TEST_CASE("tetrahedralized fits neighbours for any numbering of nodes and cell corners") {
  std::mt19937 random(7);
  Mesh mesh = cylinder({.radius = 1, .length = 2, .cells = 3, .layers = 4, .sector = Sector::full});
  const std::size_t boundary = surface(mesh).size();
  const double V = volume(mesh);
  // Random node numbers, and cells that begin at any of four corners.
  std::vector<Index> number(mesh.nodes.size());
  for (Index n = 0; n < number.size(); ++n) number[n] = n;
  std::shuffle(number.begin(), number.end(), random);
  Mesh shuffled{.nodes = mesh.nodes};
  for (Index n = 0; n < number.size(); ++n) shuffled.nodes[number[n]] = mesh.nodes[n];
  for (auto cell : mesh.hexahedra) {
    for (Index& node : cell) node = number[node];
    const auto turn = static_cast<std::ptrdiff_t>(random() % 4);
    std::rotate(cell.begin(), cell.begin() + turn, cell.begin() + 4);
    std::rotate(cell.begin() + 4, cell.begin() + 4 + turn, cell.end());
    shuffled.hexahedra.push_back(cell);
  }
  const Mesh split = tetrahedralized(shuffled);
  CHECK(split.tetrahedra.size() == 6 * mesh.hexahedra.size());
  CHECK(split.hexahedra.empty());
  CHECK_NOTHROW(check(split));  // all right side out
  // Conforming: no triangle is left over inside.
  CHECK(surface(split).size() == 2 * boundary);
  CHECK(volume(split) == Approx(V).epsilon(1e-13));
}

TEST_CASE("tetrahedralized keeps the volume of cells with flat faces") {
  const Mesh split = tetrahedralized(box({.size = {2, 3, 5}}));
  for (const auto& cell : split.tetrahedra) CHECK(tetrahedron_volume(split.nodes, cell) == Approx(5));
}

namespace {

/// Of each inner triangle two cells, of each outer one a face of the hexahedra; and no corner is inside out.
void fits(const Mesh& mesh, const Mesh& split) {
  CHECK(split.tetrahedra.size() == 5 * mesh.hexahedra.size());
  CHECK(split.hexahedra.empty());
  CHECK_NOTHROW(check(split));
  CHECK(surface(split).size() == 2 * surface(mesh).size());
}

}  // namespace

TEST_CASE(
    "five tetrahedra to a hexahedron fit: boxes, the round meshes of all sectors, birds, and 192 make X3D's 960") {
  const Mesh bricks = box({.size = {2, 3, 5}, .cells = {3, 2, 4}});
  fits(bricks, tetrahedralized(bricks, Split::five));
  CHECK(volume(tetrahedralized(bricks, Split::five)) == Approx(30).epsilon(1e-13));
  for (const Sector sector : {Sector::quarter, Sector::half, Sector::full})
    for (const Index cells : {1u, 2u, 3u}) {
      CAPTURE(static_cast<int>(sector), cells);
      const Mesh bar = cylinder({.radius = 1, .length = 2, .cells = cells, .layers = 3, .sector = sector});
      fits(bar, tetrahedralized(bar, Split::five));
      CHECK(volume(tetrahedralized(bar, Split::five)) == Approx(volume(bar)).epsilon(1e-13));  // flat faces
      const Mesh ball = sphere({.radius = 1, .cells = cells, .sector = sector});
      fits(ball, tetrahedralized(ball, Split::five));
      for (const BirdForm form : {BirdForm::hemispherical_ends, BirdForm::ellipsoid}) {
        const Mesh mesh = bird({.mass = 1, .density = 1, .form = form, .cells = cells, .layers = 2, .sector = sector});
        fits(mesh, tetrahedralized(mesh, Split::five));
      }
    }
  const Mesh mesh = bird({.mass = 1.8, .density = 950, .cells = 2, .layers = 4, .sector = Sector::full});
  CHECK(mesh.hexahedra.size() == 192);
  CHECK(tetrahedralized(mesh, Split::five).tetrahedra.size() == 960);
}

TEST_CASE(
    "five tetrahedra to a hexahedron: warped faces are lost and won in turn, so that the volume is of second order") {
  double last = 0;
  for (const Index cells : {2u, 4u, 8u}) {
    const Mesh ball = sphere({.radius = 1, .cells = cells});
    const double error = std::abs(volume(tetrahedralized(ball, Split::five)) / (4. / 3 * std::numbers::pi) - 1);
    CHECK(error < 0.6 / (cells * cells));
    if (last > 0) CHECK(last / error == Approx(4).epsilon(0.15));
    last = error;
  }
}

TEST_CASE("five tetrahedra to a hexahedron: the same for any corner that cells begin at, in any order of cells") {
  std::mt19937 random(3);
  const auto edges = [](const Mesh& mesh) {
    std::vector<std::array<Index, 4>> cells = tetrahedralized(mesh, Split::five).tetrahedra;
    for (auto& cell : cells) std::sort(cell.begin(), cell.end());
    std::sort(cells.begin(), cells.end());
    return cells;
  };
  Mesh mesh = box({.size = {1, 1, 1}, .cells = {3, 3, 2}});
  const auto natural = edges(mesh);
  for (auto& cell : mesh.hexahedra) {
    const auto turn = static_cast<std::ptrdiff_t>(random() % 4);
    std::rotate(cell.begin(), cell.begin() + turn, cell.begin() + 4);
    std::rotate(cell.begin() + 4, cell.begin() + 4 + turn, cell.end());
  }
  CHECK(edges(mesh) == natural);
  std::shuffle(mesh.hexahedra.begin(), mesh.hexahedra.end(), random);
  CHECK(edges(mesh) == natural);
  CHECK(edges(mirrored(mesh, {1, 2, 3})) == natural);
  // Two bodies apart have each its own.
  Mesh two = mesh;
  append(two, mesh);
  CHECK(edges(two).size() == 2 * natural.size());
}

TEST_CASE("five tetrahedra to a hexahedron are refused around a hole in an odd number, and made in an even one") {
  for (const Index around : {3u, 4u, 5u, 8u}) {
    Mesh plan;
    for (Index i = 0; i < around; ++i) {
      const double angle = 2 * std::numbers::pi * i / around;
      for (const double r : {1.0, 2.0}) plan.nodes.emplace_back(r * std::cos(angle), r * std::sin(angle), 0);
      const Index next = (i + 1) % around;
      plan.quadrilaterals.push_back({2 * i, 2 * i + 1, 2 * next + 1, 2 * next});
    }
    const std::array<double, 2> levels{0, 1};
    const Mesh ring = extruded(plan, levels);
    CAPTURE(around);
    if (around % 2 == 0)
      fits(ring, tetrahedralized(ring, Split::five));
    else
      CHECK_THROWS_WITH(tetrahedralized(ring, Split::five),
                        Catch::Matchers::ContainsSubstring("do not fit at the face of hexahedra ") &&
                            Catch::Matchers::ContainsSubstring("closes a ring of an odd number of them"));
  }
}
