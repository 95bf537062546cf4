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
                             "*DATABASE_BINARY_RUNRSF\n 0.1\n*DATABASE_BINARY_RUNRSF\n 0.1\n*END\n*NODE\nnonsense\n");
  CHECK(deck.title == "a cube and more");
  CHECK(deck.mesh.nodes.size() == 10);
  CHECK(deck.mesh.nodes[2] == Eigen::Vector3d(1, 1, 0));
  CHECK(deck.mesh.nodes[3] == Eigen::Vector3d(0, 1, 0));
  CHECK(deck.mesh.nodes[5] == Eigen::Vector3d(1, 0, 1));
  CHECK(deck.mesh.hexahedra == Cells<8>{{0, 1, 2, 3, 4, 5, 6, 7}});
  CHECK(deck.mesh.tetrahedra == Cells<4>{{4, 5, 6, 8}, {4, 6, 7, 8}, {4, 5, 7, 8}, {4, 5, 6, 8}});
  CHECK(deck.mesh.quadrilaterals.empty());
  CHECK(deck.mesh.triangles == Cells<3>{{1, 9, 2}, {1, 9, 2}});
  CHECK(deck.cell_numbers == std::vector<FileNumber>{11, 12, 13, 14, 15, 11, 12});
  CHECK(deck.part("the block").hexahedra.size() == 1);
  CHECK(deck.part("the tip").tetrahedra.size() == 4);
  CHECK(deck.part(3).triangles.size() == 2);
  CHECK(deck.part_cards[0].section == 4);
  CHECK(deck.part_cards[0].material == 5);
  CHECK(deck.part_cards[0].eos == 6);
  CHECK(deck.part_cards[0].hourglass == 7);
  CHECK(deck.warnings == std::vector<std::string>{
                             "Nodes without an element (1, the first has the number 99) were dropped.",
                             "*DATABASE_BINARY_RUNRSF (2 cards) was skipped: lines 33, 35.",
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

TEST_CASE("dyna: sets are made of sets defined below, with nodes taken out, in boxes, collected") {
  const DynaDeck deck = read(cube + R"(*ELEMENT_SHELL
1,1,1,2,3,4
2,4,5,6,7,8
*ELEMENT_SOLID
1,7,1,2,3,4,5,6,7,8
*SET_NODE_ADD
1
2,3
*SET_NODE_ADD
2
3,4
*SET_NODE_GENERAL
3
PART,4
DNODE,6
DBOX,9
*SET_NODE_LIST_COLLECT
4
1
*SET_NODE_LIST_COLLECT_TITLE
again
4
2
*SET_NODE_LIST_GENERATE_INCREMENT
5
1,7,3,8,8
*SET_NODE_GENERAL
6
BOX,9
*DEFINE_BOX
9,-.5,.5,-.5,.5,.5,1.5
*SET_PART_ADD
1
2,3
*SET_PART_ADD
2
3
*SET_PART_LIST
3
7,1
*SET_PART_LIST_GENERATE_INCREMENT
4
1,9,3
*SET_SHELL_ADD
1
2
*SET_SHELL
2
2
*SET_SOLID_ADD
3
2
*SET_SOLID
2
1
*SET_SEGMENT_TITLE
top
         1       0.0
         5         6         7         8
         5         6         7
)");
  CHECK(deck.nodes(3) == std::vector<Index>{6, 7});
  CHECK(deck.nodes(4) == std::vector<Index>{0, 1});
  CHECK(deck.nodes(2) == std::vector<Index>{0, 1, 6, 7});
  CHECK(deck.nodes(1) == deck.nodes(2));
  CHECK(deck.nodes(5) == std::vector<Index>{0, 3, 6, 7});
  CHECK(deck.nodes(6) == std::vector<Index>{4});
  const auto parts = [&](FileNumber number) {
    for (const NamedSet& set : deck.part_sets)
      if (set.number == number) return set.members;
    return std::vector<Index>{};
  };
  CHECK(parts(1) == std::vector<Index>{0, 2});
  CHECK(parts(2) == parts(1));
  CHECK(parts(4) == std::vector<Index>{0, 1, 2});
  CHECK(deck.cell_sets.size() == 4);
  CHECK(deck.cell_sets[2].members == std::vector<Index>{0});  // solids
  CHECK(deck.cell_sets[3].members == std::vector<Index>{2});
  REQUIRE(deck.segment_sets.size() == 1);
  CHECK(deck.segment_sets[0].name == "top");
  CHECK(deck.segment_sets[0].segments == Cells<4>{{4, 5, 6, 7}, {4, 5, 6, 6}});
  CHECK(deck.warnings.empty());

  const auto refused = [](const std::string& text, const std::string& sentence) {
    CHECK_THROWS_WITH(read(cube + "*ELEMENT_SHELL\n1,1,1,2,3,4\n" + text), ContainsSubstring(sentence));
  };
  refused("*SET_NODE_ADD\n1\n2\n*SET_NODE_ADD\n2\n1\n",
          "line 19: set 1 contains itself: take it out of one of the sets");
  refused("*SET_PART_ADD\n1\n1\n", "line 16: set 1 contains itself");
  refused("*SET_PART_ADD\n1\n2\n", "line 16: the set of parts 2 is not in the file");
  refused("*SET_SHELL_ADD\n1\n2\n*SET_SOLID\n2\n", "line 16: the set of shells 2 is not in the file");
  refused("*SET_NODE_GENERAL\n1\nBOX,2\n", "line 16: box 2 is not in the file");
  refused("*SET_SEGMENT\n1\n1,2\n", "line 16: a segment has fewer than three corners");
  refused("*SET_SEGMENT\n1\n1,2,99\n", "line 16: node 99 is not in the file");
  std::string chain;  // as deep as a file may make it
  for (int i = 1; i < 100'000; ++i)
    chain += "*SET_NODE_ADD\n" + std::to_string(i) + "\n" + std::to_string(i + 1) + "\n";
  CHECK(read(cube + "*ELEMENT_SHELL\n1,1,1,2,3,4\n" + chain + "*SET_NODE\n100000\n3\n").nodes(1) ==
        std::vector<Index>{2});
}

TEST_CASE("dyna: the long and the I10 format, of the file or of a keyword") {
  const auto line = [](std::size_t width, std::initializer_list<const char*> fields) {
    std::string text;
    for (const std::string field : fields) text += std::string(width - field.size(), ' ') + field;
    return text + "\n";
  };
  const auto nodes = [&](std::size_t number, std::size_t coordinate) {
    std::string text;
    for (const char* node : {"1000", "1010", "1011", "1001"})
      text += line(number, {node}).substr(0, number) +
              line(coordinate, {node[2] == '1' ? "1" : "0", node[3] == '1' ? "1.e0" : "0", "0."});
    return text;
  };
  const auto shell = [&](std::size_t width) { return line(width, {"7", "1", "1000", "1010", "1011", "1001"}); };
  const auto part = [&](std::size_t width) { return "plate\n" + line(width, {"1", "8", "9"}); };
  const auto expect = [](const std::string& text) {
    INFO(text);
    const DynaDeck deck = read(text);
    CHECK(deck.mesh.nodes == std::vector<Eigen::Vector3d>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
    CHECK(deck.mesh.quadrilaterals == Cells<4>{{0, 1, 2, 3}});
    CHECK(deck.part_cards[0].section == 8);
  };
  for (const char* keyword : {"*KEYWORD LONG=Y", "*keyword long=yes", "*KEYWORD  Long = k", "*KEYWORD 2000 LONG =Y"})
    expect(std::string(keyword) + "\n*NODE\n" + nodes(20, 20) + "*ELEMENT_SHELL\n" + shell(20) + "*PART\n" + part(20));
  for (const char* keyword : {"*KEYWORD I10=Y", "*KEYWORD i10 = yes"})
    expect(std::string(keyword) + "\n*NODE\n" + nodes(10, 16) + "*ELEMENT_SHELL\n" + shell(10) + "*PART\n" + part(10));
  for (const char* keyword : {"*KEYWORD LONG=S", "*KEYWORD I10=N", "*KEYWORD"})
    expect(std::string(keyword) + "\n*NODE\n" + nodes(8, 16) + "*ELEMENT_SHELL\n" + shell(8) + "*PART\n" + part(10));
  expect("*NODE +\n" + nodes(20, 20) + "*ELEMENT_SHELL %\n" + shell(10) + "*PART+\n" + part(20));
  expect("*KEYWORD LONG=Y\n*NODE -\n" + nodes(8, 16) + "*ELEMENT_SHELL-\n" + shell(8) + "*PART\n" + part(20));
  expect("*KEYWORD LONG=Y\n*NODE%\n" + nodes(10, 16) + "*ELEMENT_SHELL\n" + shell(20) + "*PART %\n" + part(10));
}

TEST_CASE("dyna: a node may be there again at its place") {
  const DynaDeck deck = read(cube + "*NODE\n2,1.,0,0\n*ELEMENT_SHELL\n1,1,1,2,3,4\n*NODE\n2,1,0,0\n5,,,1\n");
  CHECK(deck.mesh.nodes.size() == 4);
  CHECK(deck.node_numbers == std::vector<FileNumber>{1, 2, 3, 4});
  CHECK(deck.warnings ==
        std::vector<std::string>{"Nodes without an element (4, the first has the number 5) were dropped."});
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
1,0,0,0,1,0
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
  CHECK(deck.warnings ==
        std::vector<std::string>{"Nodes without an element (4, the first has the number 5) were dropped."});
  REQUIRE(deck.inertias.size() == 2);
  CHECK(deck.inertias[0].part == 3);
  CHECK(deck.inertias[1].part == 4);
  CHECK(deck.part_cards[4].contact->static_friction == 0.3);
}

TEST_CASE("dyna: elements of other kinds are left out only if that is allowed, and counted") {
  const std::string text =
      cube +
      "*ELEMENT_SHELL\n1,1,1,2,3,4\n*ELEMENT_TSHELL\n2,1,1,2,3,4,5,6,7,8\n"
      "$ a comment\n3,1,1,2,3,4,5,6,7,8\n*ELEMENT_MASS\n4,1,1.\n*ELEMENT_TSHELL\n5,1,1,2,3\n"
      "*ELEMENT_BEAM_THICKNESS\n5,1,1,2\n1,1\n*ELEMENT_INERTIA\n1,1\n1,1,1\n*ELEMENT_PLOTEL\n1,1,2\n"
      "*ELEMENT_DISCRETE\n*SET_NODE_LIST\n9\n1,2,3,4,5,6,7,8,1\n";
  CHECK_THROWS_WITH(read(text),
                    "strike: the file 'a.k', line 14: elements of *ELEMENT_TSHELL (3) are of a kind that is not read: "
                    "take them out of the deck, or leave them out with {.leave_out_elements = true}.");
  const DynaDeck deck = read_dyna(text, "a.k", {.leave_out_elements = true});
  CHECK(deck.warnings == std::vector<std::string>{
                             "Nodes without an element (4, the first has the number 5) were dropped.",
                             "*ELEMENT_PLOTEL (1 card) was skipped: line 28.",
                             "Elements of *ELEMENT_TSHELL (3) were left out: lines 14, 20.",
                             "Elements of *ELEMENT_MASS (1) were left out: line 18.",
                             "Elements of *ELEMENT_BEAM_THICKNESS (1) were left out: line 22.",
                             "Lines of *ELEMENT_INERTIA (2) were left out: line 25.",
                             "Further fields of *SET_NODE_LIST (1) had no effect: line 33.",
                         });
  CHECK(read(cube + "*ELEMENT_SHELL\n1,1,1,2,3,4\n*ELEMENT_BEAM\n*COMMENT\nof no effect\n").warnings.size() == 1);
}

TEST_CASE("dyna: a keyword without which the deck would be another one is refused") {
  const std::pair<const char*, const char*> keywords[] = {
      {"*CASE", "*CASE makes several runs of one deck: write a deck for each case."},
      {"*CASE_BEGIN_2", "makes several runs of one deck"},
      {"*NODE_MERGE_SET", "*NODE_MERGE_SET is not read: write the nodes as they are after it."},
      {"*NODE_TRANSFORM", "is not read: write the nodes"},
      {"*PART_MOVE", "*PART_MOVE is not read: write the nodes as they are after it."},
      {"*PART_DUPLICATE", "write the nodes and elements that it makes."},
      {"*PARAMETER_OTHER", "is not read: write the values of its parameters with *PARAMETER."},
      {"*ELEMENT_SHELL_COMPOSITE", "is not read: write the elements as *ELEMENT_SHELL."},
      {"*ELEMENT_SOLID_H64", "is not read: write the elements as *ELEMENT_SOLID."},
      {"*DELETE_PART", "belongs to a restart: write the whole deck as it should be."},
      {"*INCLUDE_STAMPED_SET", "is not read, and takes more or less from a file than its text"}};
  for (const auto& [keyword, sentence] : keywords)
    CHECK_THROWS_WITH(read(cube + keyword + "\n1\n"),
                      ContainsSubstring("strike: the file 'a.k', line 12: *") && ContainsSubstring(sentence));
}

TEST_CASE("dyna: what is wrong is told with its line") {
  const auto refused = [](const std::string& text, const std::string& sentence) {
    CHECK_THROWS_WITH(read(text), ContainsSubstring("strike: the file 'a.k', line ") && ContainsSubstring(sentence));
  };
  refused("", "the file has no keyword");
  refused("hello\n", "line 1: 'hello' stands before any keyword: begin the file with *KEYWORD.");
  refused("*PART\na\n1\nb\n1\n", "line 5: part 1 is on line 3 already: give each a number of its own.");
  refused("*MAT_ELASTIC\n1,1,1\n*MAT_NULL\n1,1\n", "line 4: material 1 is on line 2 already");
  refused("*SECTION_SOLID\n1\n1\n", "line 3: section 1 is on line 2 already");
  refused(cube + "*SET_NODE\n1\n1\n*SET_NODE_ADD\n1\n1\n", "line 16: set of nodes 1 is on line 13 already");
  refused("*EOS_GRUNEISEN\n,1\n", "line 2: an equation of state has no number");
  refused(cube + "*SET_NODE_LIST_GENERATE\n1\n5,1\n", "line 14: the range from 5 to 1 is empty");
  refused(cube + "*SET_NODE_LIST_GENERATE\n1\n1,3,5\n", "line 14: the range from 5 to 0 is empty");
  refused(cube + "*SET_NODE_GENERAL\n1\nVOL,1\n", "line 14: the option 'VOL' of *SET_NODE_GENERAL is not read");
  refused(cube + "*SET_NODE_ADD\n1\n2\n", "line 14: the set of nodes 2 is not in the file");
  refused(cube + "*SET_NODE_COLUMN\n1\n1\n*BOUNDARY_SPC_SET\n1,0,1\n",
          "line 16: the set of nodes 1 is not among those read (*SET_NODE_COLUMN on line 12 was skipped)");
  refused("*NODE\n  1 2 3   0.0\n", "line 2: the number of a node '1 2 3' is no whole number");
  refused("*NODE\n,0,0,0\n", "line 2: a node has no number: number from 1.");
  refused("*NODE\n-1,0,0,0\n", "line 2: the number of a node -1 is out of bounds");
  refused("*NODE\n1,0,0,0,8\n", "the constraint 8 of a node is none: give 0 to 7.");
  refused("*NODE\n1,0,0,0\n1,0,0,1e-9\n", "line 3: node 1 is on line 2 already");
  refused(cube + "*ELEMENT_SOLID\n1,1,1,2,3,4,5,6,7,9\n", "line 13: element 1 names node 9, which is not in the file");
  refused(cube + "*ELEMENT_SOLID\n1,1,1,2,3,4,5,6,6,6\n",
          "line 13: element 1 has 6 different corners, but repeats them otherwise");
  refused(cube + "*ELEMENT_SOLID\n1,1,1,2,3,4,5,6,7,8,1,2\n", "line 13: element 1 is a tetrahedron of ten nodes");
  refused(cube + "*ELEMENT_SHELL\n1,1,1,2,3,4,5,6,7,8\n", "line 13: element 1 is a shell of more than four nodes");
  refused(cube + "*ELEMENT_SHELL\n1,1,1,2,3,4\n1,1,1,2,3,4\n", "line 14: element 1 is on line 13 already");
  refused(cube + "*SET_NODE_LIST\n1\n77\n", "line 14: node 77 is not in the file");
  refused(cube + "*SET_PART\n1\n77\n", "line 14: part 77 is not in the file");
}
