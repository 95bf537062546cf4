#include <cmath>
#include <utility>

#include <strike/contact/rigid_wall.hpp>
#include <strike/dynamics/explicit.hpp>
#include <strike/element/hex8.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/load/prescribed_motion.hpp>
#include <strike/load/support.hpp>
#include <strike/mesh/box.hpp>
#include <strike/mesh/select.hpp>

#include "support/catch.hpp"

using namespace strike;
using Catch::Matchers::ContainsSubstring;

namespace {

constexpr Elastic rubber{.density = 1000, .youngs_modulus = 1e8, .poissons_ratio = 0.3};

Mesh block() { return box({.size = {1, 1, 1}, .cells = {3, 3, 3}}); }
std::vector<Index> on(Axis axis) { return nodes_where(block().nodes, on_plane(axis, 0)); }

/// The run of a block at (3, -2, -5) m/s under these conditions in this order, for 20 ms.
template <class... Conditions>
auto struck(const Mesh& mesh, Conditions... conditions) {
  Explicit run{
      Scene{mesh.nodes, Part{Hex8{}, rubber, mesh.hexahedra}, InitialVelocity{{3, -2, -5}}, std::move(conditions)...},
      {},
      in<double>};
  run.until(0.02);
  return std::pair{run.positions(), run.energy()};
}

template <class A, class B>
void check_same(const A& a, const B& b) {
  double worst = 0;
  for (std::size_t i = 0; i < a.first.size(); ++i) worst = std::max(worst, (a.first[i] - b.first[i]).norm());
  CHECK(worst < 1e-12);
  CHECK(a.second.held() == Approx(b.second.held()).epsilon(1e-12));
  CHECK(std::abs(a.second.error()) < 0.02);
}

}  // namespace

TEST_CASE("D36: a wall with friction and planes of symmetry, in any order") {
  const Mesh mesh = block();
  const RigidWall wall{{0, 0, 0}, {0, 0, 1}, 0.3};
  const Symmetry x{Axis::x, on(Axis::x)}, y{Axis::y, on(Axis::y)};
  const auto first = struck(mesh, x, y, wall);
  check_same(first, struck(mesh, wall, x, y));
  check_same(first, struck(mesh, y, wall, x));
}

TEST_CASE("D36: nodes held on a wall, which is over-constrained") {
  const Mesh mesh = block();
  const RigidWall wall{{0, 0, 0}, {0, 0, 1}, 0.3};
  const Symmetry foot{Axis::z, on(Axis::z)};
  check_same(struck(mesh, foot, wall), struck(mesh, wall, foot));
}

TEST_CASE("D36: nodes that are driven along a wall with friction move as they are told") {
  const Mesh mesh = block();
  const RigidWall wall{{0, 0, 0}, {0, 0, 1}, 0.3};
  const PrescribedVelocity drive{Axis::x, on(Axis::z), Constant{1}};
  const auto first = struck(mesh, drive, wall);
  check_same(first, struck(mesh, wall, drive));
  for (const Index i : on(Axis::z)) CHECK(first.first[i].x() == Approx(mesh.nodes[i].x() + 0.02).epsilon(1e-12));
}

TEST_CASE("D36: planes of symmetry at 45 degrees, in any order, and their nodes stay in them") {
  const Mesh cube = block();
  const auto edge = nodes_where(cube.nodes, [](const Eigen::Vector3d& x) { return std::hypot(x[0], x[1]) < 1e-9; });
  const Eigen::Vector3d oblique(1, -1, 0);
  const Symmetry x{Axis::x, on(Axis::x)}, diagonal{oblique, edge};
  const auto first = struck(cube, x, diagonal);
  check_same(first, struck(cube, diagonal, x));
  for (const Index i : edge) {
    CHECK(std::abs(first.first[i].x()) < 1e-15);
    CHECK(std::abs(first.first[i].y()) < 1e-15);
  }
}

TEST_CASE("D36: a condition for a node that is not there is refused") {
  const Mesh mesh = block();
  CHECK_THROWS_WITH(struck(mesh, Symmetry{Axis::z, {64}}),
                    ContainsSubstring("a condition names node 64, but there are 64 nodes"));
}

TEST_CASE("D36: a node that is held where its motion is prescribed is refused, in any order") {
  const Mesh mesh = block();
  const Symmetry held{Axis::z, on(Axis::z)};
  const PrescribedVelocity moved{Eigen::Vector3d(0, 1, 1), on(Axis::z), Constant{1}};
  CHECK_THROWS_WITH(struck(mesh, held, moved), ContainsSubstring("node 0 at (0, 0, 0) has two conditions along "));
  CHECK_THROWS_WITH(struck(mesh, moved, held), ContainsSubstring("node 0 at (0, 0, 0) has two conditions along "));
}
