#include <algorithm>
#include <random>

#include <strike/mesh/box.hpp>
#include <strike/mesh/check.hpp>
#include <strike/mesh/cylinder.hpp>
#include <strike/mesh/measure.hpp>
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
