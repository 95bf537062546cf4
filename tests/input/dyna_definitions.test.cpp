#include <cmath>
#include <string>

#include <strike/input/dyna.hpp>

#include "support/catch.hpp"

using namespace strike;
using Catch::Matchers::ContainsSubstring;

namespace {

DynaDeck read(const std::string& text) { return read_dyna(text, "a.k"); }
void expect_refused(const std::string& text, const std::string& sentence) {
  CHECK_THROWS_WITH(read(text), ContainsSubstring("strike: the file 'a.k', line ") && ContainsSubstring(sentence));
}

/// Two shells of parts 1 and 2, and a node off them.
const std::string two = R"(*NODE
1,0,0,0
2,1,0,0
3,1,1,0
4,0,1,0
5,2,0,0
6,2,1,0
9,0,0,3
)";
const std::string shells = "*ELEMENT_SHELL\n1,1,1,2,3,4\n2,2,2,5,6,3\n";

}  // namespace

TEST_CASE("dyna definitions: curves are scaled and shifted, tables name theirs") {
  const DynaDeck deck = read(R"(*DEFINE_CURVE_TITLE
stress
         7         0       2.0      10.0       0.5      -1.0         0
                 0.0               300.0
                 0.1               400.0
*DEFINE_TABLE
        11       3.0       1.0
                 0.0
                 2.0
*DEFINE_CURVE
12
0,1
1,2
*DEFINE_CURVE
13,1
0,3
*DEFINE_TABLE_2D
        14
                1.e0                   7
               100.0                  13
*DEFINE_TABLE
15
1,12
*DEFINE_CURVE
16,0,0,0,0,0,1
2,0
1,0
*DEFINE_CURVE
17,0,-1
1,5
2,6
)");
  REQUIRE(deck.curves.size() == 5);
  CHECK(deck.curve(7).title == "stress");
  CHECK(deck.curve(7).points == std::vector<std::array<double, 2>>{{2 * 0.5, 10 * 299.0}, {2 * 0.6, 10 * 399.0}});
  CHECK(deck.curve(12).points == std::vector<std::array<double, 2>>{{0, 1}, {1, 2}});
  CHECK(deck.curve(13).phase == 1);
  CHECK(deck.curve(16).points[1][0] == 1);
  CHECK(deck.curve(17).points[1][0] == -2);
  CHECK(deck.table(11).values == std::vector<double>{3, 9});
  CHECK(deck.table(11).curves == std::vector<FileNumber>{12, 13});
  CHECK(deck.table(14).values == std::vector<double>{1, 100});
  CHECK(deck.table(14).curves == std::vector<FileNumber>{7, 13});
  CHECK(deck.table(15).curves == std::vector<FileNumber>{12});
  CHECK(deck.warnings.empty());
  CHECK_THROWS_WITH(deck.curve(11),
                    "strike: no curve has the number 11: read the warnings of the deck, or correct it.");

  expect_refused("*DEFINE_CURVE\n1\n1,0\n0,0\n", "line 4: the abscissa 0 of curve 1 is below the one before it");
  expect_refused("*DEFINE_CURVE\n1,,1e200\n1e200,0\n", "line 3: a point of curve 1 is not finite");
  expect_refused("*DEFINE_CURVE\n1\n*DEFINE_TABLE\n1\n", "line 4: curve or table 1 is on line 2 already");
  expect_refused("*DEFINE_TABLE\n1\n1\n2\n*DEFINE_CURVE\n2\n", "line 2: table 1 has 2 values and 1 curves after it");
  expect_refused("*DEFINE_TABLE\n1\n1\n2,7\n", "line 4: table 1 has 2 values and 1 curves");
  expect_refused("*DEFINE_TABLE_2D\n1\n1\n", "line 3: a value of table 1 names no curve");
}

TEST_CASE("dyna definitions: coordinate systems turn supports") {
  const DynaDeck deck = read(two + shells + R"(*DEFINE_COORDINATE_SYSTEM_TITLE
tilted
3,1,0,0,1,2,0
0,0,0
*DEFINE_COORDINATE_VECTOR
4,0,0,5,1,0,7
*DEFINE_COORDINATE_NODES
5,1,9,4,0,Z
6,1,2,4
*BOUNDARY_SPC_NODE
1,3,1,0,0,0,1
2,4,1
3,4,1
4,,1
)");
  REQUIRE(deck.coordinate_systems.size() == 4);
  const auto& systems = deck.coordinate_systems;
  Eigen::Matrix3d axes;  // x = (0, 1, 0), z = (0, 0, 1) as (0,0,0) lies to the left
  axes << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  CHECK(systems[0].title == "tilted");
  CHECK(systems[0].origin == Eigen::Vector3d(1, 0, 0));
  CHECK(systems[0].axes == axes);
  axes << 0, 1, 0, 0, 0, 1, 1, 0, 0;  // x = Z, y = X
  CHECK(systems[1].axes == axes);
  CHECK(systems[2].axes.col(2) == Eigen::Vector3d(0, 0, 1));  // node 9 lies along z, node 4 in the plane of z and x
  CHECK(systems[2].axes.col(0) == Eigen::Vector3d(0, 1, 0));
  CHECK(systems[3].axes == Eigen::Matrix3d::Identity());
  REQUIRE(deck.supports.size() == 3);
  CHECK(deck.supports[0].directions() == std::vector<Eigen::Vector3d>{{0, 1, 0}});
  CHECK(deck.supports[0].axes() == std::vector<Eigen::Vector3d>{{-1, 0, 0}});
  CHECK(deck.supports[1].directions() == std::vector<Eigen::Vector3d>{{0, 0, 1}});
  CHECK(deck.supports[1].nodes == std::vector<Index>{1, 2});
  CHECK(deck.supports[2].directions() == std::vector<Eigen::Vector3d>{{1, 0, 0}});

  expect_refused(two + shells + "*BOUNDARY_SPC_NODE\n1,3,1\n", "line 13: coordinate system 3 is not in the file");
  expect_refused("*DEFINE_COORDINATE_SYSTEM\n1,0,0,0,1,1,1\n2,2,2\n", "line 3: the axes of a coordinate system lie in");
  expect_refused("*DEFINE_COORDINATE_VECTOR\n1\n", "line 2: the axes of a coordinate system lie in a line");
  expect_refused(two + "*DEFINE_COORDINATE_NODES\n1,1,2,8\n", "line 10: node 8 is not in the file");
  expect_refused("*DEFINE_COORDINATE_NODES\n1,1,2,8,0,W\n", "line 2: DIR 'W' is no axis: give X, Y or Z.");
}

TEST_CASE("dyna definitions: parts with inertia, contact and layers") {
  const DynaDeck deck = read(two + shells + R"(*PART_INERTIA
ball
         1         7         8
       1.0       2.0       3.0       4.0
      10.0       1.0       2.0      20.0       3.0      30.0
       5.0       6.0       7.0        .1        .2        .3
block
         2         7         8
       0.0       0.0       0.0       2.0         1         9
       1.0       0.0       0.0       2.0       0.0       3.0
       5.0
       0.0       1.0       0.0      -1.0
*PART_INERTIA
by CID
         5         7         8
       0.0       0.0       0.0       2.0         1
       1.0       0.0       0.0       2.0       0.0       3.0
       5.0
                                                                   5
*DEFINE_COORDINATE_VECTOR
5,0,1,0,-1,0,0
*PART_CONTACT_INERTIA
both
         3         7         8
       0.0       0.0       0.0       2.0
       1.0       0.0       0.0       1.0       0.0       1.0
       5.0
        .3        .2        .1       0.0       0.9
*PART_COMPOSITE
laminate
         4         0       0.0      -1.0       0.0         6
         8       0.1      45.0         0         9       0.2     -45.0
         8       0.3
)");
  REQUIRE(deck.inertias.size() == 4);
  const InertiaCard& ball = deck.inertias[0];
  Eigen::Matrix3d inertia;
  inertia << 10, 1, 2, 1, 20, 3, 2, 3, 30;
  CHECK(ball.part == 1);
  CHECK(ball.centre == Eigen::Vector3d(1, 2, 3));
  CHECK(ball.mass == 4);
  CHECK(ball.inertia == inertia);
  CHECK(ball.velocity == Eigen::Vector3d(5, 6, 7));
  CHECK(ball.spin == Eigen::Vector3d(0.1, 0.2, 0.3));
  CHECK(deck.inertias[1].centre == Eigen::Vector3d(0, 0, 3));                                // node 9
  CHECK(deck.inertias[1].inertia == Eigen::Vector3d(2, 1, 3).asDiagonal().toDenseMatrix());  // x along Y
  CHECK(deck.inertias[2].inertia == deck.inertias[1].inertia);
  CHECK(deck.inertias[0].whole().moment.yz == 3);
  CHECK(deck.inertias[0].whole().moment.zx == 2);
  CHECK(deck.part_cards[3].name == "both");
  CHECK(deck.part_cards[3].contact->static_friction == 0.3);
  CHECK(deck.part_cards[3].contact->thickness == 0.9);
  CHECK_FALSE(deck.part_cards[0].contact);
  REQUIRE(deck.composites.size() == 1);
  const CompositeCard& laminate = deck.composites[0];
  CHECK(laminate.part == 4);
  CHECK(laminate.element_form == 2);
  CHECK(laminate.shear_factor == 1);
  CHECK(laminate.reference == -1);
  REQUIRE(laminate.layers.size() == 3);
  CHECK(laminate.layers[1].material == 9);
  CHECK(laminate.layers[1].thickness == 0.2);
  CHECK(laminate.layers[1].angle == -45);
  CHECK(deck.part_cards[4].name == "laminate");
  CHECK(deck.part_cards[4].hourglass == 6);
  CHECK(deck.warnings ==
        std::vector<std::string>{"Nodes without an element (1, the first has the number 9) were dropped."});

  expect_refused("*PART_COMPOSITE\na\n1\n8,0\n", "line 4: THICK of a layer is not positive: give it its thickness.");
  expect_refused("*PART_COMPOSITE\na\n1\n,1.\n", "line 4: a layer has no MID: give it a material.");
  expect_refused("*PART_INERTIA\na\n1\n0,0,0,1,1\n1\n0\n,,,,,,4\n", "line 7: coordinate system 4 is not in the file");
}

TEST_CASE("dyna definitions: values of each shell stand with it") {
  const auto expect_values = [](const std::string& text, double thickness, double angle, double offset) {
    INFO(text);
    const DynaDeck deck = read(two + text + "*ELEMENT_SOLID\n1,5,1,2,3,9\n");
    REQUIRE(deck.mesh.quadrilaterals.size() == 2);
    REQUIRE(deck.shells.size() == 1);
    CHECK(deck.shells[0].cell == 2);  // after the tetrahedron, and the plate without values
    CHECK(deck.shells[0].corner_thickness == std::array{thickness, 0.0, 0.0, 2 * thickness});
    CHECK(deck.shells[0].angle == angle);
    CHECK(deck.shells[0].offset == offset);
    CHECK(deck.warnings == std::vector<std::string>{});
  };
  const auto shell = [](const std::string& options, const std::string& first, const std::string& second) {
    return "*ELEMENT_SHELL" + options + "\n1,1,1,2,3,4\n" + first + "2,2,2,5,6,3\n" + second;
  };
  expect_values(shell("_THICKNESS", "0\n", "1.5,0,0,3\n"), 1.5, 0, 0);
  expect_values(shell("_BETA", "0\n", "0,0,0,0,30\n"), 0, 30, 0);
  {  // a triangle, numbered behind the quadrilateral that follows it
    const DynaDeck deck = read(two + "*ELEMENT_SHELL_BETA\n1,1,1,2,3,3\n0,0,0,0,30\n2,2,2,5,6,3\n0\n");
    CHECK(deck.mesh.quadrilaterals.size() == 1);
    CHECK(deck.mesh.triangles.size() == 1);
    CHECK(deck.cell_numbers == std::vector<FileNumber>{2, 1});
    REQUIRE(deck.shells.size() == 1);
    CHECK(deck.shells[0].cell == 1);
    CHECK(deck.shells[0].angle == 30);
    CHECK(deck.part(1).triangles == Cells<3>{deck.mesh.triangles[0]});
    CHECK(deck.part(1).nodes().size() == 3);
    CHECK(deck.part(2).triangles.empty());
  }
  expect_values(shell("_OFFSET", "0\n", "-.25\n"), 0, 0, -0.25);
  expect_values(shell("_BETA_OFFSET", "0\n0\n", "0,0,0,0,30\n.5\n"), 0, 30, 0.5);
  expect_values(shell("_THICKNESS_OFFSET", "0\n0\n",
                      "             1.5             0.0             0.0             3.0\n"
                      "             0.5\n"),
                1.5, 0, 0.5);
  expect_values(shell("_THICKNESS_BETA_OFFSET", "0\n\n", "1.5,,,3,30\n.5\n"), 1.5, 30, 0.5);
  const DynaDeck deck = read(two + shell("_MCID", "0,0,0,0,7\n", "0\n"));
  CHECK(deck.warnings[1] == "MCID of *ELEMENT_SHELL_MCID (1) had no effect: line 11.");
  CHECK(read(two + "*ELEMENT_SOLID_ORTHO\n1,5,1,2,3,9\n1,0,0\n0,1,0\n2,5,2,5,6,9\n0\n0\n").mesh.tetrahedra.size() == 2);
}
