#include <limits>
#include <string>

#include <strike/input/dyna.hpp>

#include "input/dyna_text.hpp"
#include "support/catch.hpp"

using namespace strike;
using decks::read;

namespace {

/// Two shells, a node off them and a set of segments.
const std::string mesh = R"(*NODE
1,0,0,0
2,1,0,0
3,1,1,0
4,0,1,0
5,2,0,0
9,0,0,3
*ELEMENT_SHELL
1,1,1,2,3,4
2,2,2,5,3
*SET_SEGMENT
4
1,4,3,2
)";

}  // namespace

TEST_CASE("dyna blasts: charges and their faces") {
  const DynaDeck deck = read(R"(*LOAD_BLAST_SEGMENT_SET
         7         4
         8         4         0       0.0       1.0
*LOAD_BLAST_SEGMENT
8,2,5,3
*LOAD_BLAST_ENHANCED
$#     bid         m       xbo       ybo       zbo       tbo      unit     blast
         7     2.5e3       1.0       2.0       3.0      -0.5         7         1
$#     cfm       cfl       cft       cfp     nidbo     death    negphs
       0.0       0.0       0.0       0.0         9       2.0         1
         8      10.0
         0         0         0         0         0     1.e20
)" + mesh);
  REQUIRE(deck.blasts.size() == 2);
  const BlastCard& ground = deck.blasts[0];
  CHECK(ground.number == 7);
  CHECK(ground.mass == 2500);
  CHECK(ground.centre == Eigen::Vector3d(0, 0, 3));  // at node 9
  CHECK(ground.start == -0.5);
  CHECK(ground.kind == BlastCard::Kind::on_ground);
  CHECK(ground.unit == 7);
  CHECK(ground.si == std::array{1e3, 1e-3, 1.0, 1e6});  // tonne, mm, s, MPa
  CHECK(ground.death == 2);
  CHECK(ground.without_suction);
  CHECK(ground.segments == Cells<4>{{0, 3, 2, 1}});
  const BlastCard& air = deck.blasts[1];  // with the defaults
  CHECK(air.mass == 10);
  CHECK(air.centre == Eigen::Vector3d(0, 0, 0));
  CHECK(air.kind == BlastCard::Kind::in_air);
  CHECK(air.unit == 2);
  CHECK(air.si == std::array{1.0, 1.0, 1.0, 1.0});
  CHECK(air.death == std::numeric_limits<double>::infinity());
  CHECK(!air.without_suction);
  CHECK(air.faces().size() == 2);
  CHECK(air.faces()[1].nodes == std::array<Index, 4>{1, 4, 2, 2});
  CHECK(deck.pressures.empty());
  CHECK(deck.warnings == std::vector<std::string>{
                             "Nodes without an element (1, the first has the number 9) were dropped.",
                         });
}

TEST_CASE("dyna blasts: the older card takes the pressures of curve -2") {
  const DynaDeck deck = read(mesh + R"(*LOAD_SEGMENT_SET
4,-2
*LOAD_SEGMENT
7,1,0,2,5,3
-2,2,0,2,5,3
*LOAD_SHELL_ELEMENT
1,-2
*LOAD_BLAST
       5.0       0.0       0.0       1.0       0.0         4         1
*DEFINE_CURVE
7
0,1
)");
  REQUIRE(deck.blasts.size() == 1);
  CHECK(deck.blasts[0].number == 0);
  CHECK(deck.blasts[0].kind == BlastCard::Kind::on_ground);
  CHECK(deck.blasts[0].si == std::array{1e-3, 1e-2, 1e-6, 1e11});
  CHECK(deck.blasts[0].segments == Cells<4>{{0, 3, 2, 1}, {1, 4, 2, 2}, {0, 1, 2, 3}});
  CHECK(deck.pressures.size() == 1);
  CHECK(deck.warnings == std::vector<std::string>{
                             "Nodes without an element (1, the first has the number 9) were dropped.",
                             "SF of a blast of *LOAD_SEGMENT (1) had no effect: line 18.",
                         });
}

TEST_CASE("dyna blasts: units are consistent, and those of the deck as given") {
  const auto si = [](const std::string& unit, const std::string& factors) {
    return read(mesh + "*LOAD_BLAST_ENHANCED\n1,1,0,0,0,0," + unit + "\n" + factors + "\n").blasts[0].si;
  };
  // a pressure is mass/(length time^2), but where a pound is a mass, and a force beside it: 32.174 feet/s^2
  for (const char* unit : {"2", "3", "4", "6", "7", "8"}) {
    const auto [mass, length, time, pressure] = si(unit, "");
    CHECK(pressure == Approx(mass / (length * time * time)).epsilon(1e-12));
  }
  const auto [pound, foot, second, psi] = si("1", "");
  CHECK(psi == Approx(pound * 9.80665 / (foot * foot) * 144).epsilon(1e-12));
  CHECK(second == 1);
  const auto given = si("5", "2,3,1e3,4");
  CHECK(given[0] == Approx(2 * pound));
  CHECK(given[1] == Approx(3 * foot));
  CHECK(given[2] == Approx(1));  // milliseconds
  CHECK(given[3] == Approx(4 * psi));
}

TEST_CASE("dyna blasts: what is wrong or not honoured is told") {
  const auto refused = [](const std::string& text, const std::string& sentence) {
    decks::expect_refused(mesh + text, sentence);
  };
  refused("*LOAD_BLAST_ENHANCED\n1\n", "the mass of a charge is not positive: give its mass in TNT.");
  refused("*LOAD_BLAST_ENHANCED\n,1\n", "a blast has no number: number from 1.");
  refused("*LOAD_BLAST_ENHANCED\n1,1\n\n1,1\n", "blast 1 is on line 15 already");
  refused("*LOAD_BLAST_ENHANCED\n1,1,0,0,0,0,9\n", "the units 9 of a blast are none: give 1 to 8.");
  refused("*LOAD_BLAST_ENHANCED\n1,1,0,0,0,0,5\n1,1,1\n", "CFM to CFP are not positive");
  refused("*LOAD_BLAST_ENHANCED\n1,1,0,0,0,0,2,5\n", "the type 5 of a blast is none");
  refused("*LOAD_BLAST\n1,0,0,0,0,2,3\n", "the type 3 of a blast is none");
  refused("*LOAD_BLAST\n1\n*LOAD_BLAST\n1\n", "*LOAD_BLAST is there twice");
  refused("*LOAD_BLAST_ENHANCED\n1,1\n0,0,0,0,77\n", "line 15: node 77 is not in the file");
  refused("*LOAD_BLAST_SEGMENT_SET\n3,4\n", "line 15: blast 3 is not in the file: define it or correct the card.");
  refused("*LOAD_BLAST_SEGMENT_SET\n3\n", "a blast has no SSID: give it a set of segments.");
  refused("*LOAD_BLAST\n1\n*LOAD_SEGMENT_SET\n5,-2\n", "line 17: the set of segments 5 is not in the file");
  refused("*LOAD_SEGMENT_SET\n4,-2\n", "line 15: LCID -2 stands for *LOAD_BLAST, which is not in the file");
  const DynaDeck deck =
      read(mesh + "*LOAD_BLAST_ENHANCED\n1,1,0,0,0,0,2,4\n\n1,2\n2,1\n*LOAD_BLAST_SEGMENT_SET\n1,4,2,.5,2\n");
  CHECK(deck.blasts.size() == 2);
  CHECK(deck.blasts[0].kind == BlastCard::Kind::above_ground);
  CHECK(deck.warnings == std::vector<std::string>{
                             "Nodes without an element (1, the first has the number 9) were dropped.",
                             "BLAST 4 (a charge above the ground) of *LOAD_BLAST_ENHANCED (1) had no effect: line 17.",
                             "ALEPID of *LOAD_BLAST_SEGMENT_SET (1) had no effect: line 20.",
                             "SFNRB of *LOAD_BLAST_SEGMENT_SET (1) had no effect: line 20.",
                             "SCALEP of *LOAD_BLAST_SEGMENT_SET (1) had no effect: line 20.",
                         });
}
