#include <string>

#include <strike/input/dyna.hpp>

#include "support/catch.hpp"

using namespace strike;
using Catch::Matchers::ContainsSubstring;

namespace {

DynaDeck read(const std::string& text) { return read_dyna(text, "a.k"); }

const std::string cube = R"(*KEYWORD
*NODE
$#   nid               x               y               z      tc      rc
       1             0.0             0.0             0.0       7       4
       2       1.0000000             0.0             0.0       3       0
       3            1.+0          1.0D+0             0.0
       4                             1.0
       5,0,0,1
       6,1,,1.0e0
       7,1,1,1,0,0
       8             0.0             1.0             1.0
)";

}  // namespace

TEST_CASE("dyna: nodes and elements in columns and with commas, of every shape") {
  const DynaDeck deck = read("$ a comment\n" + cube +
                             "       9              .5              .5             2.0\n"
                             "      10             2.0             0.0             0.0\n"
                             "      99             9.0             9.0             9.0\n"
                             "*TITLE\na cube and more\n"
                             "*ELEMENT_SOLID\n"
                             "      11       1       1       2       3       4       5       6       7       8\n"
                             "12,2,5,6,7,9,9,9,9,9\n"
                             "      13       2\n"
                             "       5       7       8       9       9       9       9       9       0       0\n"
                             "      14       2       5       6       8       8       9       9       9       9\n"
                             "      15       2       5       6       7       9\n"
                             "*ELEMENT_SHELL\n"
                             "      11       3       2      10       3       3\n"
                             "      12       3       2      10       3       0\n"
                             "*PART\nthe block\n         1         4         5         6         7\n"
                             "   the tip   \n         2\n"
                             "*DATABASE_BINARY_D3PLOT\n 0.1\n*DATABASE_BINARY_D3PLOT\n 0.1\n*END\n*NODE\nnonsense\n");
  CHECK(deck.title == "a cube and more");
  CHECK(deck.mesh.nodes.size() == 10);
  CHECK(deck.mesh.nodes[2] == Eigen::Vector3d(1, 1, 0));
  CHECK(deck.mesh.nodes[3] == Eigen::Vector3d(0, 1, 0));
  CHECK(deck.mesh.nodes[5] == Eigen::Vector3d(1, 0, 1));
  CHECK(deck.mesh.hexahedra == Cells<8>{{0, 1, 2, 3, 4, 5, 6, 7}});
  CHECK(deck.mesh.tetrahedra == Cells<4>{{4, 5, 6, 8}, {4, 6, 7, 8}, {4, 5, 7, 8}, {4, 5, 6, 8}});
  CHECK(deck.mesh.quadrilaterals == Cells<4>{{1, 9, 2, 2}, {1, 9, 2, 2}});
  CHECK(deck.cell_numbers == std::vector<FileNumber>{11, 12, 13, 14, 15, 11, 12});
  CHECK(deck.part("the block").hexahedra.size() == 1);
  CHECK(deck.part("the tip").tetrahedra.size() == 4);
  CHECK(deck.part(3).quadrilaterals.size() == 2);
  CHECK(deck.part_cards[0].section == 4);
  CHECK(deck.part_cards[0].material == 5);
  CHECK(deck.part_cards[0].eos == 6);
  CHECK(deck.part_cards[0].hourglass == 7);
  CHECK(deck.warnings == std::vector<std::string>{
                             "Nodes without an element (1, the first has the number 99) were dropped.",
                             "*DATABASE_BINARY_D3PLOT (2) was skipped: lines 33, 35.",
                         });
  REQUIRE(deck.supports.size() == 2);  // TC and RC
  CHECK(deck.supports[1].nodes == std::vector<Index>{1});
  CHECK(deck.supports[1].held == std::array{false, false, true});
  CHECK(deck.supports[0].nodes == std::vector<Index>{0});
  CHECK(deck.supports[0].held == std::array{true, true, true});
  CHECK(deck.supports[0].held_turns == std::array{true, true, false});
}

TEST_CASE("dyna: sets of nodes, elements and parts") {
  const DynaDeck deck = read(cube + R"(*ELEMENT_SOLID
       1       1       1       2       3       4       5       6       7       8
*ELEMENT_SHELL
       1       2       1       2       3       4
*SET_NODE_LIST_TITLE
foot
         1       0.0       0.0       0.0       0.0MECH
         4         3         2         1         0         0         0         0
*SET_NODE_LIST_GENERATE
         2
         5  99999999
*SET_SHELL_LIST
3
1
*SET_PART_LIST_TITLE
both
         5
         1         2
)");
  CHECK(deck.nodes("foot") == std::vector<Index>{0, 1, 2, 3});
  CHECK(deck.nodes(1) == deck.nodes("foot"));
  CHECK(deck.nodes(2) == std::vector<Index>{4, 5, 6, 7});
  CHECK(deck.cell_sets[0].members == std::vector<Index>{1});
  CHECK(deck.part_sets[0].name == "both");
  CHECK(deck.part_sets[0].members == std::vector<Index>{0, 1});
  CHECK(deck.warnings.empty());
}

TEST_CASE("dyna: sets of parts and sets, ranges of parts") {
  const DynaDeck deck = read(cube + R"(*ELEMENT_SHELL
1,1,1,2,3,4
2,4,5,6,7,8
*SET_NODE_ADD
3
1,2,1
*SET_NODE_LIST
1
1
*SET_NODE_LIST
2
8,1
*SET_NODE_GENERAL_TITLE

         4
NODE               3         3
PART               4
*SET_NODE_GENERAL
5
ALL
ALL
*SET_PART_LIST
1
4,1,4
*SET_PART_LIST_GENERATE
2
2,9,1,3
)");
  CHECK(deck.nodes(3) == std::vector<Index>{0, 7});
  CHECK(deck.nodes(4) == std::vector<Index>{2, 4, 5, 6, 7});
  CHECK(deck.nodes(5).size() == 8);
  CHECK(deck.part_sets[0].members == std::vector<Index>{0, 1});
  CHECK(deck.part_sets[1].members == std::vector<Index>{0, 1});
}

TEST_CASE("dyna: a blank title is a title, and lines after the card of a part are its own") {
  const DynaDeck deck = read(cube + R"(*ELEMENT_SHELL
1,1,1,2,3,4
*PART

         1         7

         2         8

*PART_INERTIA
heavy
3,9
0,0,0,1,1
1,0,0,1,0,1
5
0,0,0,0,0,0
light
4,9
0,0,0,1
1,0,0,1,0,1
5
*PART_CONTACT
rough
5,9
.3
*SECTION_SHELL_TITLE

         7         2       1.0         2
       2.0
)");
  CHECK(deck.part_cards.size() == 5);
  CHECK(deck.part_cards[1].section == 8);
  CHECK(deck.part_cards[2].name == "heavy");
  CHECK(deck.part_cards[3].name == "light");
  CHECK(deck.part_cards[4].name == "rough");
  CHECK(deck.section(1).thickness == 2);
  CHECK(deck.warnings == std::vector<std::string>{
                             "Nodes without an element (4, the first has the number 5) were dropped.",
                             "The inertia of each part of *PART_INERTIA (2) had no effect: lines 22, 28.",
                             "The contact of each part of *PART_CONTACT (1) had no effect: line 35.",
                         });
}

TEST_CASE("dyna: elements that are not read are counted one by one") {
  const DynaDeck deck = read(cube +
                             "*ELEMENT_SHELL\n1,1,1,2,3,4\n*ELEMENT_TSHELL\n2,1,1,2,3,4,5,6,7,8\n"
                             "$ a comment\n3,1,1,2,3,4,5,6,7,8\n*ELEMENT_MASS\n4,1,1.\n"
                             "*ELEMENT_BEAM_THICKNESS\n5,1,1,2\n1,1\n*SET_NODE_LIST\n9\n1,2,3,4,5,6,7,8,1\n");
  CHECK(deck.warnings == std::vector<std::string>{
                             "Nodes without an element (4, the first has the number 5) were dropped.",
                             "*ELEMENT_BEAM_THICKNESS (1) was skipped: line 20.",
                             "Elements of *ELEMENT_TSHELL (2) were ignored: lines 15, 17.",
                             "Elements of *ELEMENT_MASS (1) were ignored: line 19.",
                             "Further fields of *SET_NODE_LIST (1) had no effect: line 25.",
                         });
}

TEST_CASE("dyna: what is wrong is told with its line") {
  const auto refused = [](const std::string& text, const std::string& sentence) {
    CHECK_THROWS_WITH(read(text), ContainsSubstring("strike: the file 'a.k', line ") && ContainsSubstring(sentence));
  };
  refused("", "the file has no keyword");
  refused("hello\n", "line 1: 'hello' stands before any keyword: begin the file with *KEYWORD.");
  for (const char* keyword : {"*KEYWORD LONG=K", "*KEYWORD I10 = Y", "*KEYWORD  long = y", "*NODE  +"})
    refused(std::string(keyword) + "\n", "line 1: the file is in the long or the I10 format");
  for (const char* keyword : {"*ELEMENT_SOLID_ORTHO", "*ELEMENT_SHELL_BETA", "*ELEMENT_SOLID_H20"})
    refused(cube + keyword + "\n", "is not read: write the elements as *ELEMENT_S");
  refused(cube + "*NODE_MERGE_SET\n1\n", "line 12: *NODE_MERGE_SET is not read: write the nodes as they are after it.");
  refused("*PART\na\n1\nb\n1\n", "line 5: part 1 is on line 3 already: give each a number of its own.");
  refused("*MAT_ELASTIC\n1,1,1\n*MAT_NULL\n1,1\n", "line 4: material 1 is on line 2 already");
  refused("*SECTION_SOLID\n1\n1\n", "line 3: section 1 is on line 2 already");
  refused(cube + "*SET_NODE\n1\n1\n*SET_NODE_ADD\n1\n1\n", "line 16: set of nodes 1 is on line 13 already");
  refused("*EOS_GRUNEISEN\n,1\n", "line 2: an equation of state has no number");
  refused(cube + "*SET_NODE_LIST_GENERATE\n1\n5,1\n", "line 14: the range from 5 to 1 is empty");
  refused(cube + "*SET_NODE_LIST_GENERATE\n1\n1,3,5\n", "line 14: the range from 5 to 0 is empty");
  refused(cube + "*SET_NODE_GENERAL\n1\nBOX,1\n", "line 14: the option 'BOX' of *SET_NODE_GENERAL is not read");
  refused(cube + "*SET_NODE_ADD\n1\n1\n", "line 14: the set of nodes 1 is not in the file");
  refused(cube + "*SET_NODE_COLUMN\n1\n1\n*BOUNDARY_SPC_SET\n1,0,1\n",
          "line 16: the set of nodes 1 is not among those read (*SET_NODE_COLUMN on line 12 was skipped)");
  refused("*KEYWORD LONG=Y\n", "the file is in the long or the I10 format: write it in the standard one.");
  refused("*NODE+\n", "the file is in the long or the I10 format");
  refused("*NODE %\n", "the file is in the long or the I10 format");
  refused("*NODE\n1,&x,0,0\n", "line 2: the coordinate '&x' is a parameter, which is not replaced");
  refused("*NODE\n  1 2 3   0.0\n", "line 2: the number of a node '1 2 3' is no whole number");
  refused("*NODE\n,0,0,0\n", "line 2: a node has no number: number from 1.");
  refused("*NODE\n-1,0,0,0\n", "line 2: the number of a node -1 is out of bounds");
  refused("*NODE\n1,0,0,0,8\n", "the constraint 8 of a node is none: give 0 to 7.");
  refused("*NODE\n1,0,0,0\n1,0,0,0\n", "line 3: node 1 is on line 2 already");
  refused(cube + "*ELEMENT_SOLID\n1,1,1,2,3,4,5,6,7,9\n", "line 13: element 1 names node 9, which is not in the file");
  refused(cube + "*ELEMENT_SOLID\n1,1,1,2,3,4,5,5,6,6\n", "line 13: element 1 is a wedge");
  refused(cube + "*ELEMENT_SOLID\n1,1,1,2,3,4,5,6,7,8,1,2\n", "line 13: element 1 is a tetrahedron of ten nodes");
  refused(cube + "*ELEMENT_SHELL\n1,1,1,2,3,4,5,6,7,8\n", "line 13: element 1 is a shell of more than four nodes");
  refused(cube + "*ELEMENT_SHELL\n1,1,1,2,3,4\n1,1,1,2,3,4\n", "line 14: element 1 is on line 13 already");
  refused(cube + "*SET_NODE_LIST\n1\n77\n", "line 14: node 77 is not in the file");
  refused(cube + "*SET_PART\n1\n77\n", "line 14: part 77 is not in the file");
}
