#include <cmath>
#include <numbers>
#include <random>

#include <strike/mesh/box.hpp>
#include <strike/mesh/check.hpp>
#include <strike/mesh/cylinder.hpp>
#include <strike/mesh/measure.hpp>
#include <strike/mesh/transform.hpp>

#include "support/catch.hpp"

using namespace strike;

TEST_CASE("motions keep volume and orientation, scaling multiplies it") {
  const Mesh bar = cylinder({.radius = 1, .length = 3, .cells = 2, .layers = 2});
  const double V = volume(bar);
  CHECK(volume(translated(bar, {1, 2, 3})) == Approx(V).epsilon(1e-13));
  CHECK(volume(rotated(bar, {1, 1, 1}, 0.3)) == Approx(V).epsilon(1e-13));
  CHECK(volume(scaled(bar, {2, 3, 4})) == Approx(24 * V).epsilon(1e-13));
  CHECK(volume(mirrored(bar, {1, 2, 0})) == Approx(V).epsilon(1e-13));
  CHECK_NOTHROW(check(mirrored(bar, {1, 2, 0})));
}

TEST_CASE("rotated is right-handed about the axis") {
  const Mesh mesh = rotated(Mesh{.nodes = {{1, 0, 0}}}, {0, 0, 5}, std::numbers::pi / 2);
  CHECK((mesh.nodes[0] - Eigen::Vector3d(0, 1, 0)).norm() < 1e-15);
}

TEST_CASE("append keeps both meshes and gives the offset of the second") {
  Mesh mesh = box({.size = {1, 1, 1}});
  CHECK(append(mesh, translated(mesh, {1, 0, 0})) == 8);
  CHECK(append(mesh, mesh) == 16);  // itself
  CHECK(mesh.nodes.size() == 32);
  CHECK(mesh.hexahedra.size() == 4);
  CHECK(mesh.hexahedra[3][0] == 24);
  CHECK(volume(mesh) == Approx(4));
}

TEST_CASE("merge_coincident_nodes joins what a shaken copy of a grid left apart, and nothing else") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> jitter(-1, 1);
  const double tolerance = 1e-6;
  Mesh mesh = box({.lower = {-1, -1, -1}, .size = {2, 2, 2}, .cells = {9, 9, 9}});
  const std::size_t nodes = mesh.nodes.size();
  append(mesh, transformed(mesh, [&](const Eigen::Vector3d& x) {
           const Eigen::Vector3d shake(jitter(random), jitter(random), jitter(random));
           return Eigen::Vector3d(x + 0.57 * tolerance * shake);  // at most 0.99 tolerance away
         }));
  const Mesh merged = merge_coincident_nodes(mesh, tolerance);
  CHECK(merged.nodes.size() == nodes);
  for (std::size_t n = 0; n < nodes; ++n) CHECK(merged.nodes[n] == mesh.nodes[n]);  // the first stays, in order
  for (std::size_t e = 0; e < 729; ++e) CHECK(merged.hexahedra[e] == merged.hexahedra[e + 729]);
  CHECK(merge_coincident_nodes(mesh, 1e-12).nodes.size() == 2 * nodes);
}

TEST_CASE("four mirrored quarters joined are the full cylinder") {
  Mesh half = cylinder({.radius = 2, .length = 5, .cells = 3, .layers = 2});
  append(half, mirrored(half, {1, 0, 0}));
  append(half, mirrored(half, {0, 1, 0}));
  const Mesh whole = merge_coincident_nodes(half, 1e-9);
  const Mesh full = cylinder({.radius = 2, .length = 5, .cells = 3, .layers = 2, .sector = Sector::full});
  CHECK(whole.nodes.size() == full.nodes.size());
  CHECK(volume(whole) == Approx(volume(full)).epsilon(1e-13));
  CHECK_NOTHROW(check(whole));
}

TEST_CASE("remove_orphan_nodes keeps the order of the rest") {
  Mesh mesh{.nodes = {{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {8, 8, 8}, {0, 1, 0}, {0, 0, 1}}, .tetrahedra = {{1, 2, 4, 5}}};
  CHECK(orphan_nodes(mesh) == std::vector<Index>{0, 3});
  mesh = remove_orphan_nodes(mesh);
  CHECK(mesh.nodes.size() == 4);
  CHECK(mesh.tetrahedra[0] == std::array<Index, 4>{0, 1, 2, 3});
  CHECK(tetrahedron_volume(mesh.nodes, mesh.tetrahedra[0]) == Approx(1.0 / 6));
  CHECK(orphan_nodes(mesh).empty());
}
