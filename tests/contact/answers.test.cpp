#include "conformance/answers.hpp"

#include <strike/contact.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {
template <class... Policies>
auto two_way(const Policies&... policies) {
  return [=](const Surface& one, const Surface& other) { return Contact{TwoWay{one, other}, policies...}; };
}
template <class... Policies>
auto everything(const Policies&... policies) {
  return [=](const Surface&, const Surface&) { return Contact{Everything{}, policies...}; };
}
const testing::Allowed soft{.depth = 0.02, .cut = 5e-3};
}  // namespace

TEST_CASE("conformance: TwoWay answers alike however its scene lies and is numbered") {
  testing::answers_alike(two_way());
}
TEST_CASE("conformance: TwoWay, Coulomb") { testing::answers_alike(two_way(Coulomb{0.3})); }
TEST_CASE("conformance: TwoWay, Penalty") { testing::answers_alike(two_way(Penalty{}), soft); }
TEST_CASE("conformance: TwoWay, Penalty, Coulomb") { testing::answers_alike(two_way(Penalty{}, Coulomb{0.3}), soft); }
TEST_CASE("conformance: SelfContact") {
  testing::answers_alike([](const Surface& one, const Surface& other) { return Contact{SelfContact{one + other}}; });
}
TEST_CASE("conformance: Everything") { testing::answers_alike(everything()); }
TEST_CASE("conformance: Everything, Penalty, Coulomb") {
  testing::answers_alike(everything(Penalty{}, Coulomb{0.3}), soft);
}
TEST_CASE("conformance: NodeToSurface") {
  testing::answers_alike(
      [](const Surface& one, const Surface& other) {
        return Contact{NodeToSurface{one.nodes(), other, one.pieces()[0].thickness}};
      },
      {.has_edges = false, .two_way = false});
}

namespace {
using testing::nodes_on;
const RigidPlane ground{{0, 0, 0}, {0, 0, 2}};
const RigidSphere ball{{0, 0, -2}, 2};
const RigidCylinder roll{{0, 0, -2}, {0, 3, 0}, 2}, short_roll{{0, -0.3, -2}, {0, 3, 0}, 2, 0.6};
RigidSurface ridge() {
  const Mesh mesh = box({.lower = {-0.8, -0.8, -1}, .size = {1.6, 1.6, 1}, .cells = {3, 3, 1}});
  return {mesh.nodes, surface(mesh)};
}
}  // namespace

TEST_CASE("conformance: a RigidWall answers alike however its scene lies and is numbered") {
  testing::answers_alike_on_rigid([](const std::vector<Index>& nodes, double, const testing::Placement& at) {
    return RigidWall{at.point({0, 0, 0}), at.direction({0, 0, 1}), nodes, 0.3};
  });
}
TEST_CASE("conformance: RigidPlane") { testing::answers_alike_on_rigid(nodes_on(ground)); }
TEST_CASE("conformance: RigidPlane, Penalty, Coulomb") {
  testing::answers_alike_on_rigid(nodes_on(ground, Penalty{}, Coulomb{0.3}));
}
TEST_CASE("conformance: RigidSphere, Coulomb") { testing::answers_alike_on_rigid(nodes_on(ball, Coulomb{0.3})); }
TEST_CASE("conformance: RigidSphere, Penalty") { testing::answers_alike_on_rigid(nodes_on(ball, Penalty{})); }
TEST_CASE("conformance: RigidCylinder") { testing::answers_alike_on_rigid(nodes_on(roll)); }
TEST_CASE("conformance: RigidCylinder, Penalty, Coulomb") {
  testing::answers_alike_on_rigid(nodes_on(roll, Penalty{}, Coulomb{0.3}));
}
TEST_CASE("conformance: RigidCylinder that ends, Coulomb") {
  testing::answers_alike_on_rigid(nodes_on(short_roll, Coulomb{0.3}));
}
TEST_CASE("conformance: RigidSurface, Coulomb") { testing::answers_alike_on_rigid(nodes_on(ridge(), Coulomb{0.3})); }
TEST_CASE("conformance: RigidSurface, Penalty") { testing::answers_alike_on_rigid(nodes_on(ridge(), Penalty{})); }
