#include <cmath>
#include <limits>
#include <string>

#include <strike/input/dyna.hpp>
#include <strike/load/body_force.hpp>
#include <strike/load/nodal_force.hpp>
#include <strike/load/prescribed_motion.hpp>
#include <strike/load/pressure.hpp>

#include "input/dyna_text.hpp"
#include "support/catch.hpp"

using namespace strike;
using decks::read;

namespace {

/// A shell, a triangle and a brick of parts 1 to 3, a set of two nodes and a curve.
const std::string mesh = R"(*NODE
1,0,0,0
2,1,0,0
3,1,1,0
4,0,1,0
5,2,0,0
11,0,0,5
12,1,0,5
13,1,1,5
14,0,1,5
15,0,0,6
16,1,0,6
17,1,1,6
18,0,1,6
*ELEMENT_SHELL
1,1,1,2,3,4
2,2,2,5,3
*ELEMENT_SOLID
1,3,11,12,13,14,15,16,17,18
*SET_NODE_LIST
1
1,4
)";
const std::string ramp = "*DEFINE_CURVE\n7\n0,0\n2,4\n";
constexpr double never = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("dyna loads: a history is linear in its life and nothing beside it, its integral is exact") {
  // 0 before 1; then 2 at s = 0 to 4 at s = 1, a jump to 10 there, 6 at s = 2 and beyond, s = t - 1; dead from 5 on
  const CardHistory h{7, 2, 1, 5, {{0, 1}, {1, 2}, {1, 5}, {2, 3}}};
  CHECK(h(0.999) == 0);
  CHECK(h(1) == 2);
  CHECK(h(1.5) == 3);
  CHECK(h(2) == 10);
  CHECK(h(2.5) == 8);
  CHECK(h(4) == 6);
  CHECK(h(5) == 0);
  CHECK(h.integral(1) == 0);
  CHECK(h.integral(1.5) == Approx(1.25));      // (2 + 3)/2 0.5
  CHECK(h.integral(2.5) == Approx(3 + 4.5));   // 3 of the first piece, (10 + 8)/2 0.5
  CHECK(h.integral(4) == Approx(3 + 8 + 6));   // and 6 for a time of 1
  CHECK(h.integral(9) == Approx(3 + 8 + 12));  // it ends at 5
  const CardHistory late{7, 1, 0, never, {{1, 3}, {2, 5}}};
  CHECK(late(0) == 3);
  CHECK(late.integral(0.5) == Approx(1.5));
  CHECK(late.integral(2) == Approx(3 + 4));
  CHECK(CardHistory{}.integral(3) == 3);
}

TEST_CASE("dyna loads: a body load pushes against its axis") {
  const DynaDeck deck = read(mesh + R"(*LOAD_BODY_Z
         7    9810.0
*LOAD_BODY_X
7,0,0,0,0,0,3
*LOAD_BODY_Y
7,,8
*LOAD_BODY_Y
0,1,8
*LOAD_BODY_PARTS
2
*SET_PART
2
3,1
*DEFINE_COORDINATE_VECTOR
3,0,1,0,-1,0,0
)" + ramp);
  REQUIRE(deck.body_loads.size() == 3);
  CHECK(deck.body_loads[0].direction == Eigen::Vector3d(0, 0, -1));
  CHECK(deck.body_loads[0].history(1) == 2 * 9810);
  CHECK(deck.body_loads[0].history.curve == 7);
  CHECK(deck.body_loads[0].parts == std::vector<FileNumber>{1, 3});
  CHECK(deck.body_loads[1].direction.isApprox(Eigen::Vector3d(0, -1, 0)));  // against the x axis of system 3
  CHECK(deck.body_loads[1].history(1) == 2);                                // a scale of 0 is 1
  CHECK(deck.warnings == std::vector<std::string>{"LCIDDR of *LOAD_BODY_Y (2) had no effect: lines 28, 30."});
  const BodyForce gravity{deck.body_loads[0].direction, deck.body_loads[0].history};
  (void)gravity;
}

TEST_CASE("dyna loads: nodal loads add up, and follow curves and sets that stand after them") {
  const DynaDeck deck = read("*LOAD_NODE_SET\n1,3,7,0\n*LOAD_NODE_POINT\n" + std::string(R"(
         2         1         7      -5.0
         3         1         7      -5.0
         2         1         7      -5.0
         2         6         7
         3         1         7      -5.0
$ nothing
         0         0
         5         4         7
)") + "*LOAD_NODE_POINT_ID\n         3a push\n4,2,7,.5,3\n*DEFINE_COORDINATE_VECTOR\n3,0,1,0,-1,0,0\n" +
                             mesh + ramp);
  REQUIRE(deck.nodal_loads.size() == 5);
  CHECK(deck.nodal_loads[0].nodes == std::vector<Index>{0, 3});
  CHECK(deck.nodal_loads[0].direction == Eigen::Vector3d(0, 0, 1));
  CHECK(deck.nodal_loads[0].history(2) == 4);
  CHECK(deck.nodal_loads[1].nodes == std::vector<Index>{1, 2});
  CHECK(deck.nodal_loads[1].history(2) == -20);
  CHECK(deck.nodal_loads[2].nodes == std::vector<Index>{1, 2});  // again: their forces count twice
  CHECK(deck.nodal_loads[2].history(2) == -20);
  CHECK(deck.nodal_loads[3].turns);
  CHECK(deck.nodal_loads[3].direction == Eigen::Vector3d(0, 1, 0));
  CHECK(deck.nodal_loads[4].direction.isApprox(Eigen::Vector3d(-1, 0, 0)));  // y of system 3
  CHECK(deck.nodal_loads[4].history(2) == 2);
  CHECK(deck.warnings == std::vector<std::string>{
                             "A force that follows its nodes (DOF 4 or 8) of *LOAD_NODE_POINT (1) had no effect: "
                             "line 12.",
                         });
  const NodalForce force{deck.nodal_loads[0].direction, deck.nodal_loads[0].nodes, deck.nodal_loads[0].history};
  (void)force;
}

TEST_CASE("dyna loads: pressures on segments and shells push against the normal") {
  const DynaDeck deck = read(mesh + R"(*LOAD_SEGMENT_SET
         4         7       3.0       0.5
*LOAD_SEGMENT
7,3,.5,15,16,17,18
7,3,0,1,2,3,4
7,3,.5,2,5,3
*LOAD_SHELL_ELEMENT
         2         7
         1         7
         2         7
*LOAD_SHELL_SET_ID
         6the whole canopy
5,7,2
*SET_SHELL_LIST
5
2,1
*SET_SEGMENT
4
1,4,3,2
)" + ramp);
  REQUIRE(deck.pressures.size() == 5);
  CHECK(deck.pressures[0].segments == Cells<4>{{0, 3, 2, 1}});
  CHECK(deck.pressures[0].history(0.4) == 0);  // it arrives at 0.5, where the curve begins
  CHECK(deck.pressures[0].history(1.5) == 6);
  CHECK(deck.pressures[1].segments == Cells<4>{{9, 10, 11, 12}, {1, 4, 2, 2}});
  CHECK(deck.pressures[1].history.birth == 0.5);
  CHECK(deck.pressures[2].segments == Cells<4>{{0, 1, 2, 3}});
  CHECK(deck.pressures[3].segments == Cells<4>{{1, 4, 2, 2}, {0, 1, 2, 3}, {1, 4, 2, 2}});  // named twice: twice
  CHECK(deck.pressures[4].segments == Cells<4>{{0, 1, 2, 3}, {1, 4, 2, 2}});
  CHECK(deck.pressures[4].history(1) == 4);
  CHECK(deck.warnings.empty());
  const std::vector<Face> faces = deck.pressures[2].faces();
  CHECK(area_vector(deck.mesh.nodes, faces[0]).isApprox(Eigen::Vector3d(0, 0, 1)));  // which a pressure pushes down
  const Pressure pressure{faces, deck.pressures[2].history};
  (void)pressure;
}

TEST_CASE("dyna loads: prescribed motions") {
  using Kind = PrescribedMotionCard::Kind;
  const DynaDeck deck = read(R"(*BOUNDARY_PRESCRIBED_MOTION_SET_ID
         1the edge
$#    nsid       dof       vad      lcid        sf       vid     death     birth
         1         3         2         7      -1.0         0       3.0       1.0
*BOUNDARY_PRESCRIBED_MOTION_NODE
2,1,0,7
3,1,0,7,0,0,0
5,1,0,7,0,0,1e28
2,1,1,7
2,5,0,7
2,-4,0,7,1,8
*BOUNDARY_PRESCRIBED_MOTION_RIGID
3,8,0,7,2,9
3,9,0,7
1,1
3,1,4,7
0,0,3
0,0
*DEFINE_VECTOR
8,1,1,1,4,1,5
*DEFINE_VECTOR_NODES
9,11,15
)" + mesh + ramp);
  REQUIRE(deck.motions.size() == 6);
  const PrescribedMotionCard& edge = deck.motions[0];
  CHECK(edge.nodes == std::vector<Index>{0, 3});
  CHECK(edge.direction == Eigen::Vector3d(0, 0, 1));
  CHECK(edge.kind == Kind::displacement);
  CHECK(edge.history(0.5) == 0);
  CHECK(edge.history(2) == -2);
  CHECK(edge.history(3) == 0);
  CHECK(deck.motions[1].nodes == std::vector<Index>{1, 2, 4});  // a scale of 0 is 1, a death of 0 or 1e28 none
  CHECK(deck.motions[1].history.death == never);
  CHECK(deck.motions[1].history(1) == 2);
  CHECK(deck.motions[2].kind == Kind::acceleration);
  CHECK(deck.motions[2].history.integral(2) == 4);
  CHECK(deck.motions[3].turns);
  CHECK(deck.motions[3].direction == Eigen::Vector3d(1, 0, 0));
  CHECK(deck.motions[4].holds_others);
  CHECK(deck.motions[4].direction.isApprox(Eigen::Vector3d(0.6, 0, 0.8)));
  CHECK(deck.motions[5].body == 3);
  CHECK(deck.motions[5].nodes.empty());
  CHECK(deck.motions[5].turns);
  CHECK(deck.motions[5].direction.isApprox(Eigen::Vector3d(0, 0, 1)));
  CHECK(deck.warnings ==
        std::vector<std::string>{
            "A motion about an offset axis or along normals (DOF 9 to 12) of *BOUNDARY_PRESCRIBED_MOTION_RIGID (1) had "
            "no effect: line 14.",
            "A motion over displacements, or of one body to another (VAD 3 or 4) of *BOUNDARY_PRESCRIBED_MOTION_RIGID "
            "(1) had no effect: line 16.",
        });
  const PrescribedDisplacement moved{edge.direction, edge.nodes, edge.history};
  (void)moved;
}

TEST_CASE("dyna loads: a curve that ends before the run, or acts before it, is told") {
  const DynaDeck deck =
      read("*CONTROL_TERMINATION\n3.\n*LOAD_BODY_X\n7\n*LOAD_BODY_Y\n8\n*DEFINE_CURVE\n8,1\n0,1\n9,1\n" + ramp + mesh);
  CHECK(deck.body_loads[1].history(1) == 0);
  CHECK(deck.warnings ==
        std::vector<std::string>{
            "The end of curve 7 before that of the run (its last value goes on) (1) had no effect: line 4.",
            "A load by curve 8 (SIDR 1, before the run alone) (1) had no effect: line 6.",
        });
}

TEST_CASE("dyna loads: parameters and wide formats") {
  const auto expect = [](const std::string& text) {
    const DynaDeck deck = read(text + "*PARAMETER\nRscale,9\n" + mesh + ramp);
    REQUIRE(deck.nodal_loads.size() == 1);
    CHECK(deck.nodal_loads[0].nodes == std::vector<Index>{1});
    CHECK(deck.nodal_loads[0].history(1) == 5);
    CHECK(deck.warnings.empty());
  };
  expect("*LOAD_NODE_POINT+\n                   2                   3                   7                 2.5\n");
  expect("*LOAD_NODE_POINT %\n         2         3         7       2.5\n");
  expect("*PARAMETER\nRf,2.5,Il,7\n*LOAD_NODE_POINT\n         2         3        &l        &f\n");
}

TEST_CASE("dyna loads: what is wrong is told with its line") {
  const auto refused = [](const std::string& text, const std::string& sentence) {
    decks::expect_refused(mesh + ramp + text, sentence);
  };
  refused("*LOAD_BODY_X\n", "*LOAD_BODY_X has no LCID: give it a curve.");
  refused("*LOAD_BODY_X\n8\n", "line 28: curve 8 is not in the file: define it or correct the card.");
  refused("*LOAD_BODY_X\n8\n*DEFINE_CURVE_FUNCTION\n8\nsin(TIME)\n",
          "line 28: curve 8 is not among those read (*DEFINE_CURVE_FUNCTION on line 29 was skipped)");
  refused("*LOAD_BODY_X\n8\n*DEFINE_CURVE\n8\n", "line 28: curve 8 has no points, as a history must");
  refused("*LOAD_BODY_X\n8\n*DEFINE_CURVE\n8,0,-1\n1,0\n2,0\n", "line 28: curve 8 does not go forward in time");
  refused("*LOAD_NODE_SET\n2,1,7\n", "line 28: the set of nodes 2 is not in the file");
  refused("*LOAD_NODE_POINT\n,1,7\n", "line 28: a nodal load has no NID: give it one.");
  refused("*LOAD_NODE_POINT\n77,1,7\n", "line 28: node 77 is not in the file");
  refused("*LOAD_NODE_POINT\n1,9,7\n", "DOF 9 of a nodal load is none: give 1 to 3, or 5 to 7 for a moment.");
  refused("*LOAD_SEGMENT\n7,1,0,1,2\n", "a segment has fewer than three corners");
  refused("*LOAD_SEGMENT\n7,1,0,1,2,3,4,5\n", "a segment has more than four corners: cut them with");
  refused("*LOAD_SEGMENT_SET\n7,7\n", "line 28: the set of segments 7 is not in the file");
  refused("*LOAD_SHELL_SET\n7,7\n", "line 28: the set of shells 7 is not in the file");
  refused("*LOAD_SHELL_ELEMENT\n3,7\n", "line 28: shell 3 is not in the file");
  refused("*LOAD_SHELL_ELEMENT\n,7\n", "line 28: a pressure has no EID: give it one.");
  refused("*LOAD_BODY_PARTS\n7\n", "line 28: the set of parts 7 is not in the file");
  refused("*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,0,0,7\n", "DOF 0 of a prescribed motion is none");
  refused("*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,-3,0,7\n", "DOF -3 of a prescribed motion is none");
  refused("*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,1,5,7\n", "VAD 5 is none: give 0 (velocity)");
  refused("*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,4,0,7\n", "DOF 4 of a prescribed motion has no VID");
  refused("*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,4,0,7,1,2\n", "line 28: vector 2 is not in the file");
  refused("*BOUNDARY_PRESCRIBED_MOTION_SET\n,1,0,7\n", "a prescribed motion has no NSID: give it one.");
  refused("*BOUNDARY_PRESCRIBED_MOTION_RIGID\n9,1,0,7\n", "line 28: part 9 is not in the file");
  refused("*DEFINE_VECTOR\n2,1,1,1,1,1,1\n*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,4,0,7,1,2\n",
          "line 28: vector 2 has no direction: give it a head that is not its tail.");
}
