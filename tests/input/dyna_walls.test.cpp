#include <cmath>
#include <string>
#include <variant>

#include <strike/contact/rigid_wall.hpp>
#include <strike/input/dyna.hpp>

#include "input/dyna_text.hpp"
#include "support/catch.hpp"

using namespace strike;
using decks::read;

namespace {

/// A shell, two sets of nodes and a curve.
const std::string mesh = R"(*NODE
1,0,0,0
2,1,0,0
3,1,1,0
4,0,1,0
*ELEMENT_SHELL
1,1,1,2,3,4
*SET_NODE_LIST
1
1,2,3
*SET_NODE_LIST
2
2
*DEFINE_CURVE
7
0,0
2,4
)";

}  // namespace

TEST_CASE("dyna walls: planes that end and move") {
  const DynaDeck deck = read(R"(*RIGIDWALL_PLANAR
         1         2
       1.0       2.0       3.0       1.0       2.0       5.0        .3
*RIGIDWALL_PLANAR_FINITE_ID
         9a square
         0
1.,2.,3.,1.,2.,4.
2.,2.,7.,4.,5.
*RIGIDWALL_PLANAR_MOVING_FORCES_DISPLAY
1
0,0,0,0,-3.,0,1.
800.,15.
0,0,1
3,7e-6,200.
*RIGIDWALL_PLANAR_FINITE_MOVING

0,0,0,0,0,1,2.
1,0,0
5.,-1.
)" + mesh);
  REQUIRE(deck.walls.size() == 4);
  CHECK(deck.walls[0].nodes == std::vector<Index>{0, 2});  // less those of NSIDEX
  CHECK(deck.walls[0].normal == Eigen::Vector3d(0, 0, 1));
  CHECK(deck.walls[0].friction == 0.3);
  CHECK(!deck.walls[0].edges);
  CHECK(deck.walls[0].corners().empty());
  const WallCard& square = deck.walls[1];
  CHECK(square.nodes.size() == 4);
  const auto corners = square.corners();
  REQUIRE(corners.size() == 4);
  CHECK(corners[0] == Eigen::Vector3d(1, 2, 3));
  CHECK(corners[1].isApprox(Eigen::Vector3d(5, 2, 3)));  // the head of the edge, brought into the plane
  CHECK(corners[3].isApprox(Eigen::Vector3d(1, 7, 3)));
  CHECK((corners[1] - corners[0]).cross(corners[3] - corners[0]).isApprox(20 * square.normal));
  CHECK(deck.walls[2].mass == 800);
  CHECK(deck.walls[2].speed == 15);
  CHECK(deck.walls[2].sticks);
  CHECK(deck.walls[2].normal == Eigen::Vector3d(0, -1, 0));
  CHECK(deck.walls[3].edges->length == 0);  // endless
  CHECK(deck.walls[3].corners().empty());
  CHECK(deck.walls[3].speed == -1);
  CHECK(deck.walls[3].friction == 0);
  CHECK(deck.warnings ==
        std::vector<std::string>{
            "FINITE (a RigidWall has no edges) of *RIGIDWALL_PLANAR_FINITE_ID (1) had no effect: line 8.",
            "FRIC 1 (no sliding; a coefficient of 1 is taken) of *RIGIDWALL_PLANAR_MOVING_FORCES_DISPLAY (1) had no "
            "effect: line 11.",
            "MOVING (a RigidWall stands) of *RIGIDWALL_PLANAR_MOVING_FORCES_DISPLAY (1) had no effect: line 12.",
            "The card of FORCES of *RIGIDWALL_PLANAR_MOVING_FORCES_DISPLAY (1) had no effect: line 13.",
            "FRIC 2 or 3 (what has touched stays) of *RIGIDWALL_PLANAR_FINITE_MOVING (1) had no effect: line 17.",
            "FINITE (a RigidWall has no edges) of *RIGIDWALL_PLANAR_FINITE_MOVING (1) had no effect: line 18.",
            "MOVING (a RigidWall stands) of *RIGIDWALL_PLANAR_FINITE_MOVING (1) had no effect: line 19.",
        });
}

TEST_CASE("dyna walls: flats, cylinders and spheres") {
  const DynaDeck deck = read(R"(*RIGIDWALL_GEOMETRIC_SPHERE_ID
         1a ball
         1
       1.0       2.0       3.0       0.0       0.0       0.0       0.2
       5.0
*RIGIDWALL_GEOMETRIC_CYLINDER_MOTION
2,0,0,0.5
1,2,3,1,2,1,0.1
4.,7.
7,1,0,3.,4.
*RIGIDWALL_GEOMETRIC_CYLINDER_DISPLAY
2
1,2,3,4,2,3
4.
1,1e-6
*RIGIDWALL_GEOMETRIC_FLAT_MOTION
0
0,0,0,0,0,2
1,0,0
7,0,0,0,-1
)" + mesh);
  REQUIRE(deck.obstacles.size() == 3);
  const RigidSphere& ball = std::get<RigidSphere>(deck.obstacles[0].shape);
  CHECK(ball.centre == Eigen::Vector3d(1, 2, 3));  // a head that is the tail is no fault of a ball
  CHECK(ball.radius == 5);
  CHECK(deck.obstacles[0].nodes == std::vector<Index>{0, 1, 2});
  CHECK(deck.obstacles[0].friction == 0.2);
  CHECK(!deck.obstacles[0].motion);
  const RigidCylinder& cylinder = std::get<RigidCylinder>(deck.obstacles[1].shape);
  CHECK(cylinder.axis == Eigen::Vector3d(0, 0, -1));
  CHECK(cylinder.radius == 4);
  CHECK(cylinder.length == 7);
  const WallMotion& motion = deck.obstacles[1].motion.value();
  CHECK(motion.displaces);
  CHECK(motion.direction.isApprox(Eigen::Vector3d(0, 0.6, 0.8)));
  CHECK(motion.history(0.4) == 0);  // its curve begins with the wall, at 0.5
  CHECK(motion.history(1.5) == 2);
  CHECK(std::get<RigidCylinder>(deck.obstacles[2].shape).axis == Eigen::Vector3d(1, 0, 0));
  CHECK(std::isinf(std::get<RigidCylinder>(deck.obstacles[2].shape).length));
  REQUIRE(deck.walls.size() == 1);
  CHECK(deck.walls[0].normal == Eigen::Vector3d(0, 0, 1));
  CHECK(!deck.walls[0].motion->displaces);
  CHECK(deck.walls[0].motion->direction == Eigen::Vector3d(0, 0, -1));
  CHECK(deck.walls[0].motion->history(1) == 2);
  CHECK(deck.warnings ==
        std::vector<std::string>{
            "BIRTH of *RIGIDWALL_GEOMETRIC_CYLINDER_MOTION (1) had no effect: line 7.",
            "The motion (a RigidWall stands) of *RIGIDWALL_GEOMETRIC_CYLINDER_MOTION (1) had no effect: line 10.",
            "The motion (a RigidWall stands) of *RIGIDWALL_GEOMETRIC_FLAT_MOTION (1) had no effect: line 20.",
        });
  const RigidWall floor{deck.walls[0].point, deck.walls[0].normal, deck.walls[0].nodes, deck.walls[0].friction};
  (void)floor;
}

TEST_CASE("dyna walls: what is wrong is told with its line") {
  const auto refused = [](const std::string& text, const std::string& sentence) {
    decks::expect_refused(mesh + text, sentence);
  };
  refused("*RIGIDWALL_PLANAR_ORTHO_FINITE\n",
          "line 18: *RIGIDWALL_PLANAR_ORTHO_FINITE has a friction of its own along");
  refused("*RIGIDWALL_GEOMETRIC_PRISM\n", "*RIGIDWALL_GEOMETRIC_PRISM is not read: give FLAT, SPHERE or CYLINDER");
  refused("*RIGIDWALL_GEOMETRIC_SPHERE_INTERIOR\n", "touched from outside, or model it as a part that is rigid.");
  refused("*RIGIDWALL_PLANAR\n", "the normal of the wall has no length: give it a head that is not its tail.");
  refused("*RIGIDWALL_GEOMETRIC_CYLINDER\n0\n0,0,0,0,0,1\n1,-2\n", "LENCYL of the wall is negative");
  refused("*RIGIDWALL_PLANAR\n0\n0,0,0,0,0,1,-.1\n", "FRIC of a wall is negative");
  refused("*RIGIDWALL_PLANAR_FINITE\n0\n0,0,0,0,0,1\n", "the edge of the wall has no length");
  refused("*RIGIDWALL_PLANAR_FINITE\n0\n0,0,0,0,0,1\n0,0,3\n", "the edge of the wall lies along its normal");
  refused("*RIGIDWALL_PLANAR_FINITE\n0\n0,0,0,0,0,1\n1,0,0,-1\n", "LENL or LENM is negative");
  refused("*RIGIDWALL_PLANAR\n0,5\n0,0,0,0,0,1\n", "line 19: the set of nodes 5 is not in the file");
  refused("*RIGIDWALL_GEOMETRIC_CYLINDER\n0\n0,0,0,0,0,0\n", "the axis of the wall has no length");
  refused("*RIGIDWALL_GEOMETRIC_SPHERE\n0\n0,0,0,0,0,0\n", "the radius of the wall is not positive: give it one.");
  refused("*RIGIDWALL_GEOMETRIC_SPHERE_MOTION\n0\n0\n1.\n", "the motion of the wall has no LCID: give it a curve.");
  refused("*RIGIDWALL_GEOMETRIC_SPHERE_MOTION\n0\n0\n1.\n7\n", "the motion of the wall has no direction");
  refused("*RIGIDWALL_GEOMETRIC_SPHERE_MOTION\n0\n0\n1.\n7,2,1\n", "OPT 2 of a wall is none");
  refused("*RIGIDWALL_GEOMETRIC_SPHERE_MOTION\n0\n0\n1.\n8,0,1\n", "line 19: curve 8 is not in the file");
}
