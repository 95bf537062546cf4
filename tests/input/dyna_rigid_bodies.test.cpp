#include <string>

#include <strike/input/dyna.hpp>

#include "input/dyna_text.hpp"
#include "support/catch.hpp"

using namespace strike;
using decks::read;

namespace {

/// Two shells of parts 1 and 2, a node off them, and two sets of nodes.
const std::string mesh = R"(*NODE
1,0,0,0
2,1,0,0
3,1,1,0
4,0,1,0
5,2,0,0
6,2,1,0
9,0,0,3
*ELEMENT_SHELL
1,1,1,2,3,4
2,2,2,5,6,3
*SET_NODE_LIST
1
1,4,9
*SET_NODE_LIST
20
5,6
)";

}  // namespace

TEST_CASE("dyna rigid bodies: nodes, what holds them and their inertia") {
  const DynaDeck deck = read(R"(*CONSTRAINED_NODAL_RIGID_BODY
$      pid       cid      nsid
        10         0         1
        20
*CONSTRAINED_NODAL_RIGID_BODY_TITLE

11,0,1
*CONSTRAINED_NODAL_RIGID_BODY_SPC
12,0,1,0,0,0,0
1.,4,7
13,0,1
-1.,3,100011
14,0,1
0,7,7
*CONSTRAINED_NODAL_RIGID_BODY_INERTIA_TITLE
heavy
15,0,1,9,0,1
1.,2.,3.,5.
4.,.1,.2,6.,.3,8.
7.,0,0,0,0,9.
and turned
16,0,1
0,0,0,5.,1,9
1.,0,0,2.,0,3.
0,0,0
0,1.,0,-1.,0,0
*DEFINE_COORDINATE_VECTOR
3,0,1,0,-1,0,0
)" + mesh);
  REQUIRE(deck.rigid_bodies.size() == 8);
  CHECK(deck.rigid_bodies[0].number == 10);
  CHECK(deck.rigid_bodies[0].nodes == std::vector<Index>{0, 3});  // node 9 has no element
  CHECK(deck.rigid_bodies[0].held.directions().empty());
  CHECK(!deck.rigid_bodies[0].inertia);
  CHECK(deck.rigid_bodies[1].nodes == std::vector<Index>{4, 5});  // a set of the body's number
  CHECK(deck.rigid_bodies[2].number == 11);
  CHECK(deck.rigid_bodies[3].held.directions() == std::vector<Eigen::Vector3d>{{1, 0, 0}, {0, 1, 0}});
  CHECK(deck.rigid_bodies[3].held.axes().size() == 3);
  const SupportCard& held = deck.rigid_bodies[4].held;  // x, ry and rz of a system whose x is y, and y -x
  CHECK(held.held == std::array{true, false, false});
  CHECK(held.held_turns == std::array{false, true, true});
  CHECK(held.directions()[0].isApprox(Eigen::Vector3d(0, 1, 0)));
  CHECK(held.axes()[0].isApprox(Eigen::Vector3d(-1, 0, 0)));
  CHECK(deck.rigid_bodies[5].held.directions().empty());  // CMO 0
  const InertiaCard& heavy = deck.rigid_bodies[6].inertia.value();
  CHECK(heavy.part == 15);
  CHECK(heavy.mass == 5);
  CHECK(heavy.centre == Eigen::Vector3d(1, 2, 3));
  CHECK(heavy.inertia.diagonal() == Eigen::Vector3d(4, 6, 8));
  CHECK(heavy.inertia(1, 2) == 0.3);
  CHECK(heavy.velocity == Eigen::Vector3d(7, 0, 0));
  CHECK(heavy.spin == Eigen::Vector3d(0, 0, 9));
  const InertiaCard& turned = deck.rigid_bodies[7].inertia.value();
  CHECK(turned.centre == Eigen::Vector3d(0, 0, 3));  // at node 9, which no element has
  CHECK(turned.inertia.diagonal().isApprox(Eigen::Vector3d(2, 1, 3)));
  CHECK(deck.inertias.empty());
  CHECK(deck.warnings == std::vector<std::string>{
                             "Nodes without an element (1, the first has the number 9) were dropped.",
                             "PNODE of *CONSTRAINED_NODAL_RIGID_BODY_INERTIA_TITLE (1) had no effect: line 17.",
                             "DRFLAG of *CONSTRAINED_NODAL_RIGID_BODY_INERTIA_TITLE (1) had no effect: line 17.",
                         });
}

TEST_CASE("dyna rigid bodies: bodies that move with others, and extra nodes") {
  const DynaDeck deck = read(R"(*CONSTRAINED_RIGID_BODIES
         1         2
         1        30
         0         0
*CONSTRAINED_EXTRA_NODES_NODE
1,5
1,6
1,5
2,1
*CONSTRAINED_EXTRA_NODES_SET
2,1
*CONSTRAINED_NODAL_RIGID_BODY
30,0,20
*BOUNDARY_PRESCRIBED_MOTION_RIGID
30,1,0,7
*DEFINE_CURVE
7
0,0
)" + mesh);
  REQUIRE(deck.rigid_merges.size() == 2);
  CHECK(deck.rigid_merges[0].lead == 1);
  CHECK(deck.rigid_merges[0].constrained == 2);
  CHECK(deck.rigid_merges[1].constrained == 30);
  REQUIRE(deck.extra_nodes.size() == 2);
  CHECK(deck.extra_nodes[0].part == 1);
  CHECK(deck.extra_nodes[0].nodes == std::vector<Index>{4, 5});  // a node named twice is one
  CHECK(deck.extra_nodes[1].nodes == std::vector<Index>{0, 3});
  CHECK(deck.motions[0].body == 30);
}

TEST_CASE("dyna rigid bodies: what is wrong is told with its line") {
  const auto refused = [](const std::string& text, const std::string& sentence) {
    decks::expect_refused(mesh + text, sentence);
  };
  refused("*CONSTRAINED_NODAL_RIGID_BODY\n5\n", "line 19: the set of nodes 5 is not in the file");
  refused("*CONSTRAINED_NODAL_RIGID_BODY\n,0,1\n", "line 19: a rigid body has no number: number from 1.");
  refused("*CONSTRAINED_NODAL_RIGID_BODY\n5,0,1\n5,0,1\n", "line 20: rigid body 5 is on line 19 already");
  refused("*CONSTRAINED_NODAL_RIGID_BODY_SPC\n5,0,1\n1,8\n", "the constraint 8 of a rigid body is none: give 0 to 7.");
  refused("*CONSTRAINED_NODAL_RIGID_BODY_SPC\n5,0,1\n-1,3,12\n", "six digits of 0 or 1");
  refused("*CONSTRAINED_NODAL_RIGID_BODY_SPC\n5,0,1\n-1,3,1000000\n", "six digits of 0 or 1");
  refused("*CONSTRAINED_NODAL_RIGID_BODY_SPC\n5,0,1\n-1,3,-1\n", "six digits of 0 or 1");
  refused("*CONSTRAINED_NODAL_RIGID_BODY_SPC\n5,0,1\n-1,3,1\n", "coordinate system 3 is not in the file");
  refused("*CONSTRAINED_NODAL_RIGID_BODY_INERTIA\n5,0,1\n0,0,0,1,0,77\n", "line 20: node 77 is not in the file");
  refused("*CONSTRAINED_RIGID_BODIES\n1,9\n", "line 19: part 9 is not in the file");
  refused("*CONSTRAINED_RIGID_BODIES\n1,1\n", "PIDL and PIDC are not two bodies");
  refused("*CONSTRAINED_EXTRA_NODES_NODE\n1,77\n", "line 19: node 77 is not in the file");
  refused("*CONSTRAINED_EXTRA_NODES_NODE\n9,1\n", "line 19: part 9 is not in the file");
  refused("*CONSTRAINED_EXTRA_NODES_SET\n1\n", "extra nodes have no part or no nodes");
}
