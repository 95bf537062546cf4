#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

#include <strike/mesh/box.hpp>
#include <strike/mesh/cylinder.hpp>
#include <strike/mesh/measure.hpp>
#include <strike/mesh/surface.hpp>
#include <strike/mesh/tetrahedra.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {

/// Each edge is run through once in each direction.
bool watertight(const std::vector<Face>& faces) {
  std::map<std::pair<Index, Index>, int> runs;
  for (const Face& face : faces)
    for (std::size_t i = 0; i < 4; ++i) {
      const Index a = face.nodes[i], b = face.nodes[(i + 1) % 4];
      if (a != b) ++runs[{a, b}];
    }
  for (const auto& [edge, count] : runs)
    if (count != 1 || !runs.contains({edge.second, edge.first})) return false;
  return !runs.empty();
}

/// Volume inside closed faces that are flat, by the divergence theorem: 3 V = sum x . A.
double enclosed_volume(const Mesh& mesh, const std::vector<Face>& faces) {
  double sum = 0;
  for (const Face& face : faces) sum += centroid(mesh.nodes, face).dot(area_vector(mesh.nodes, face));
  return sum / 3;
}

double area(const Mesh& mesh, const std::vector<Face>& faces) {
  double sum = 0;
  for (const Face& face : faces) sum += area_vector(mesh.nodes, face).norm();
  return sum;
}

}  // namespace

TEST_CASE("surface of a box of hexahedra: count, area, volume, closed") {
  const Mesh mesh = box({.lower = {-1, 2, 5}, .size = {2, 3, 5}, .cells = {4, 3, 2}});
  const auto faces = surface(mesh);
  CHECK(faces.size() == 2 * (4 * 3 + 3 * 2 + 2 * 4));
  CHECK(watertight(faces));
  CHECK(area(mesh, faces) == Approx(2 * (2 * 3 + 3 * 5 + 5 * 2)).epsilon(1e-14));
  CHECK(enclosed_volume(mesh, faces) == Approx(30).epsilon(1e-14));
  CHECK(surface_nodes(faces).size() == 5 * 4 * 3 - 3 * 2 * 1);  // all but the inner ones
}

TEST_CASE("surface of a cylinder: mantle of the polygon and two ends, closed, in every sector") {
  using std::numbers::pi;
  const double R = 3.2, L = 32.4;
  const Index n = 3;
  for (const Sector sector : {Sector::quarter, Sector::half, Sector::full}) {
    const Index quarters = sector == Sector::quarter ? 1 : sector == Sector::half ? 2 : 4;
    const Mesh bar = cylinder({.radius = R, .length = L, .cells = n, .layers = 10, .sector = sector});
    const auto faces = surface(bar);
    CHECK(watertight(faces));
    const double end = quarters * n * R * R * std::sin(pi / (4 * n));
    const double mantle = quarters * 2 * n * 2 * R * std::sin(pi / (8 * n)) * L;
    const double cuts = sector == Sector::full ? 0 : 2 * R * L;
    CHECK(area(bar, faces) == Approx(2 * end + mantle + cuts).epsilon(1e-13));
    CHECK(enclosed_volume(bar, faces) == Approx(end * L).epsilon(1e-13));
  }
}

TEST_CASE("surface of tetrahedra: triangles, closed, same volume as the hexahedra they came from") {
  const Mesh hexahedra = cylinder({.radius = 1, .length = 2, .cells = 2, .layers = 3, .sector = Sector::full});
  const Mesh mesh = tetrahedralized(hexahedra);
  const auto faces = surface(mesh);
  CHECK(faces.size() == 2 * surface(hexahedra).size());
  for (const Face& face : faces) CHECK(face.is_triangle());
  CHECK(watertight(faces));
  CHECK(enclosed_volume(mesh, faces) == Approx(volume(hexahedra)).epsilon(1e-13));
  CHECK(tetrahedron_surface(mesh.tetrahedra).size() == faces.size());
}

TEST_CASE("surface: a face names its cell, hexahedra before tetrahedra before quadrilaterals") {
  Mesh mesh = box({.size = {1, 1, 1}});
  mesh.nodes.emplace_back(0.5, 0.5, 2);
  mesh.tetrahedra = {{4, 5, 6, 8}};  // its foot is half of the top of the hexahedron: no common face
  mesh.quadrilaterals = {{0, 1, 3, 2}};
  const auto faces = surface(mesh);
  REQUIRE(faces.size() == 6 + 4 + 1);
  CHECK(faces[5].cell == 0);
  CHECK(faces[6].cell == 1);
  CHECK(faces[10].cell == 2);
  CHECK(faces[10].nodes == mesh.quadrilaterals[0]);
  CHECK(hexahedron_surface(mesh.hexahedra).size() == 6);
  CHECK(quadrilateral_surface(mesh.quadrilaterals)[0].cell == 0);
}

TEST_CASE("surface: every face of one hexahedron looks outward") {
  const Mesh mesh = box({.size = {1, 1, 1}});
  const Eigen::Vector3d centre(0.5, 0.5, 0.5);
  for (const Face& face : surface(mesh)) {
    const Eigen::Vector3d out = centroid(mesh.nodes, face) - centre, A = area_vector(mesh.nodes, face);
    CHECK(A.norm() == Approx(1).epsilon(1e-15));
    CHECK(A.dot(out) == Approx(0.5).epsilon(1e-15));
  }
}

TEST_CASE("surface: time grows as the number of cells") {
  const auto seconds = [](Index n) {
    const Mesh mesh = box({.size = {1, 1, 1}, .cells = {n, n, n}});
    std::clock_t best = std::numeric_limits<std::clock_t>::max();  // of the processor, so that neighbours do not count
    for (int run = 0; run < 5; ++run) {
      const std::clock_t start = std::clock();
      const auto faces = surface(mesh);
      best = std::min(best, std::clock() - start);
      REQUIRE(faces.size() == 6 * n * n);
    }
    return double(best) / CLOCKS_PER_SEC;
  };
  // 27 times the cells: 27 times the work if linear, 729 if quadratic; the room between is for caches.
  CHECK(seconds(36) < 200 * seconds(12));
}

TEST_CASE("surface: a cell that is there twice beside its neighbour is an error") {
  Mesh mesh = box({.size = {1, 1, 2}, .cells = {1, 1, 2}});
  mesh.hexahedra.push_back(mesh.hexahedra[1]);
  CHECK_THROWS_WITH(surface(mesh),
                    "strike: cells 0 and 2 share a face (nodes 4, 5, 6, ...) with a third cell; remove the duplicate.");
}
