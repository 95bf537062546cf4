#include "examples/own_contact/own_contact.hpp"

#include <numbers>

#include <Eigen/Geometry>

#include "conformance/answers.hpp"
#include "conformance/contact.hpp"

using namespace strike;

TEST_CASE("conformance: a law and a friction of one's own") {
  testing::conforms_as_contact(Restitution{0.7});
  testing::conforms_as_contact(Restitution{1}, LimitedFriction{0.3, 0.1});
}

TEST_CASE("conformance: a law of one's own answers alike") {
  testing::answers_alike(
      [](const Surface& one, const Surface& other) {
        return Contact{TwoWay{one, other}, Restitution{0.7}};
      },
      {.order = 0.02});  // it takes each pair once
}

TEST_CASE("conformance: a rigid body of one's own answers alike") {
  // A wheel whose top is the origin.
  const testing::Placement upright{.turn = Eigen::AngleAxisd(0.5 * std::numbers::pi, Eigen::Vector3d::UnitX()).matrix(),
                                   .moved = {0, 0, -2.5}};
  testing::answers_alike_on_rigid(testing::nodes_on(testing::placed(RigidTorus{2, 0.5}, upright), Coulomb{0.3}));
}

TEST_CASE("a ball jumps on a rigid body of one's own with the restitution of its law") {
  testing::Balls run({{2, 0, 1}}, {{0, 0, -1}}, {1},
                     Contact{NodeToRigid{std::vector<Index>{0}, RigidTorus{2, 0.5}}, Restitution{0.7}});
  for (int n = 0; n < 100; ++n) run.step(1e-2);
  CHECK(run.nodes.v(0).z() == Approx(0.7));
}
