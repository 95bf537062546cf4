#include <string>

#include <strike/input/abaqus.hpp>

#include "support/catch.hpp"

using namespace strike;
using Catch::Matchers::ContainsSubstring;

namespace {

Deck read(const std::string& text) { return read_abaqus(text, "a.inp"); }
Deck read_in_part(const std::string& text) { return read_abaqus(text, "a.inp", {.leave_out_elements = true}); }

const std::string cube =
    "*NODE, NSET=all\n1,0,0,0\n2,1.,0,0\n3,1,1.0D0,0\n4,0,1,0\n5,0,0,1\n6,1,0,1\n7,1,1,1\n8,0,1,1\n";

}  // namespace

TEST_CASE("abaqus: a flat deck with sets, ranges and elements over two lines") {
  const Deck deck =
      read_in_part("*Heading\n  two cells\n** comment\n" + cube +
                   "9, 0.5, 0.5, 2e0\n10\n77, 9, 9, 9\n*ELEMENT, TYPE=C3D8R, ELSET=BOX\n5, 1, 2, 3, 4,\n"
                   " 5, 6, 7, 8\n*element, type=C3D4,\n  elset=tip\n6, 5,6,7,9\n*ELEMENT, TYPE=S3R, ELSET=skin\n"
                   "7, 8, 9, 10\n*ELEMENT, TYPE=S4, ELSET=skin\n8, 1, 2, 2, 10\n*ELEMENT, TYPE=R3D4\n9, 1,2,3,4\n"
                   "*NSET, NSET=left, GENERATE\n1, 1000000000, 4\n*NSET, NSET=\"both of them\"\nleft, 2, \n"
                   "*ELSET, ELSET=solids\nBOX, TIP, 9\n*MATERIAL, NAME=steel\n*ELASTIC\n2e11, .3\n*STEP\n*END "
                   "STEP\n*SECTION CONTROLS\n*Section Controls\n");
  CHECK(deck.title == "two cells");
  CHECK(deck.mesh.nodes.size() == 10);
  CHECK(deck.mesh.nodes[9] == Eigen::Vector3d(0, 0, 0));
  CHECK(deck.part("BOX").hexahedra == Cells<8>{{0, 1, 2, 3, 4, 5, 6, 7}});
  CHECK(deck.part("tip").tetrahedra == Cells<4>{{4, 5, 6, 8}});
  CHECK(deck.part("skin").triangles == Cells<3>{{7, 8, 9}, {9, 0, 1}});
  CHECK(deck.part("solids").hexahedra.size() == 1);
  CHECK(deck.part("solids").tetrahedra.size() == 1);
  CHECK(deck.cell_numbers == std::vector<FileNumber>{5, 6, 7, 8});
  CHECK(deck.nodes("all").size() == 10);
  CHECK(deck.nodes("left") == std::vector<Index>{0, 4, 8});
  CHECK(deck.nodes("both of them") == std::vector<Index>{0, 1, 4, 8});
  CHECK(deck.warnings == std::vector<std::string>{
                             "Nodes without an element (1, the first has the number 77) were dropped.",
                             "Material 'steel' on line 34 was not read: it has no *DENSITY.",
                             "*SECTION CONTROLS (2) was skipped: lines 39, 40.",
                             "Elements of type R3D4 (1) were ignored: line 27.",
                         });
}

TEST_CASE("abaqus: surfaces of gmsh are plates unless they lie on solids") {
  const Deck deck = read(cube +
                         "9, 2\n10, 2, 1\n*ELEMENT, TYPE=CPS4, ELSET=Surface1\n1,1,2,3,4\n2,2,9,10,3\n"
                         "*ELEMENT, TYPE=CPS3, ELSET=Surface2\n3,2,9,10\n*ELEMENT, TYPE=C3D8\n4,1,2,3,4,5,6,7,8\n"
                         "*ELSET, ELSET=side\n1, 2, \n");
  CHECK(deck.mesh.hexahedra.size() == 1);
  CHECK(deck.mesh.quadrilaterals == Cells<4>{{1, 8, 9, 2}});
  CHECK(deck.mesh.triangles == Cells<3>{{1, 8, 9}});
  CHECK(deck.part("side").quadrilaterals == Cells<4>{{1, 8, 9, 2}});
  CHECK(deck.warnings == std::vector<std::string>{"Surface elements on solids (1) mark faces, and are no plates."});
}

TEST_CASE("abaqus: parts are placed by instances, with their sets") {
  const Deck deck = read("*PART, NAME=cube\n" + cube +
                         "*ELEMENT, TYPE=C3D8, ELSET=own\n1,1,2,3,4,5,6,7,8\n*NSET, NSET=foot\n1,2,3,4\n*END PART\n"
                         "*ASSEMBLY, NAME=a\n*INSTANCE, NAME=one, PART=CUBE\n*END INSTANCE\n"
                         "\t*INSTANCE, NAME=two, PART=cube\r\n\t3, 0, 0\r\n  ** here\n3,0,0, 3,0,1, 90\n*END INSTANCE\n"
                         "*NSET, NSET=top, INSTANCE=two\n5,6\n*NSET, NSET=mixed\none.8, two.foot\n*ELEMENT, TYPE=S4\n"
                         "1, 1, 2, 3, 4\n*NODE\n1\n2, 1\n3, 1, 1\n4, 0, 1\n*END ASSEMBLY\n");
  CHECK(deck.mesh.nodes.size() == 20);
  CHECK(deck.mesh.quadrilaterals == Cells<4>{{16, 17, 18, 19}});
  CHECK(deck.part("one").quadrilaterals.empty());
  CHECK((deck.mesh.nodes[9] - Eigen::Vector3d(3, 1, 0)).norm() < 1e-15);
  CHECK((deck.mesh.nodes[11] - Eigen::Vector3d(2, 0, 0)).norm() < 1e-15);
  CHECK(deck.part("two").hexahedra == Cells<8>{{8, 9, 10, 11, 12, 13, 14, 15}});
  CHECK(deck.part("one.own").hexahedra.size() == 1);
  CHECK(deck.node_numbers[8] == 1);
  CHECK(deck.nodes("one.foot") == std::vector<Index>{0, 1, 2, 3});
  CHECK(deck.nodes("two.all").size() == 8);
  CHECK(deck.nodes("top") == std::vector<Index>{12, 13});
  CHECK(deck.nodes("mixed") == std::vector<Index>{7, 8, 9, 10, 11});
}

TEST_CASE("abaqus: an instance may define its own mesh, which is placed with it") {
  const Deck deck = read("*PART, NAME=p\n*END PART\n*ASSEMBLY, NAME=a\n*INSTANCE, NAME=i, PART=p\n0, 0, 5\n" + cube +
                         "*ELEMENT, TYPE=C3D8, ELSET=own\n1,1,2,3,4,5,6,7,8\n*NSET, NSET=foot\n1,2\n*END INSTANCE\n"
                         "*NSET, NSET=foot\n1000\n*NSET, NSET=low, INSTANCE=i\nfoot, 3\n*NODE\n1000, 9\n"
                         "*END ASSEMBLY\n");
  CHECK(deck.part("i").hexahedra.size() == 1);
  CHECK(deck.mesh.nodes[0] == Eigen::Vector3d(0, 0, 5));
  CHECK(deck.nodes("i.foot") == std::vector<Index>{0, 1});
  CHECK(deck.nodes("low") == std::vector<Index>{0, 1, 2});  // the foot of the instance, not the other
}

TEST_CASE("abaqus: a system shifts the nodes that follow it in its part") {
  const std::string shell = "*ELEMENT, TYPE=S4\n1,1,2,3,4\n";
  const Deck deck = read("*SYSTEM\n100, 0, 5\n*NODE\n1,0,0,0\n2,1,0,0\n*SYSTEM\n*NODE\n3,1,1,0\n4,0,1,0\n" + shell);
  CHECK(deck.mesh.nodes[0] == Eigen::Vector3d(100, 0, 5));
  CHECK(deck.mesh.nodes[1] == Eigen::Vector3d(101, 0, 5));
  CHECK(deck.mesh.nodes[2] == Eigen::Vector3d(1, 1, 0));
  const Deck two = read("*PART, NAME=p\n*SYSTEM\n1,2,3\n*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,0\n4,0,1,0\n" + shell +
                        "*END PART\n*INSTANCE, NAME=i, PART=p\n*END INSTANCE\n*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,0\n"
                        "4,0,1,0\n" +
                        shell);
  CHECK(two.mesh.nodes[0] == Eigen::Vector3d(1, 2, 3));
  CHECK(two.mesh.nodes[4] == Eigen::Vector3d(0, 0, 0));
}

TEST_CASE("abaqus: a set is as long as it was where another names it") {
  const Deck deck = read(cube +
                         "*ELEMENT, TYPE=C3D8\n1,1,2,3,4,5,6,7,8\n*NSET, NSET=a\n1\n*NSET, NSET=b\na, 2\n"
                         "*NSET, NSET=A\nb, a, 3\n*NSET, NSET=a\n4\n*NSET, NSET=c, GEN\n1, 8, 3\n1, 8, 3\n");
  CHECK(deck.nodes("a") == std::vector<Index>{0, 1, 2, 3});
  CHECK(deck.nodes("b") == std::vector<Index>{0, 1});
  CHECK(deck.nodes("c") == std::vector<Index>{0, 3, 6});  // GEN is GENERATE
  CHECK(deck.node_sets.size() == 4);
}

TEST_CASE("abaqus: what has no place in the mesh is told") {
  const Deck deck =
      read_in_part("*PART, NAME=spare\n" + cube + "*ELEMENT, TYPE=C3D8\n1,1,2,3,4,5,6,7,8\n*ENDPART\n" + cube +
                   "*ELEMENT, TYPE=C3D8, COLOUR=2\n1,1,2,3,4,5,6,7,8\n*ELEMENT, TYPE=B31\n2,1,2\n3,2,3\n"
                   "*ELEMENT, TYPE=COH3D8, ELSET=glue\n4,1,2,3,4,\n5,6,7,8\n*ELSET, ELSET=both\nglue, 1\n");
  CHECK(deck.mesh.hexahedra.size() == 1);
  CHECK(deck.part("both").hexahedra.size() == 1);
  CHECK(deck.cell_sets.size() == 1);
  CHECK(deck.warnings == std::vector<std::string>{
                             "Part 'spare' (elements: 1) has no instance and was dropped: line 1.",
                             "Elements of type B31 (2) were ignored: lines 26, 27.",
                             "Elements of type COH3D8 (1) were ignored: line 29.",
                             "COLOUR of *ELEMENT (1) had no effect: line 23.",
                         });
}

TEST_CASE("abaqus: what is wrong is told with its line") {
  const auto refused = [](const std::string& text, const std::string& sentence) {
    CHECK_THROWS_WITH(read(text), ContainsSubstring("strike: the file 'a.inp', line ") && ContainsSubstring(sentence));
  };
  refused("", "the file has no keyword");
  refused("*INCLUDE, INPUT=b.inp\n", "line 1: the file 'b.inp' is included by a text in memory");
  refused("*INCLUDE\n", "line 1: *INCLUDE has no INPUT");
  refused(cube + "*NSET, NSET=a, INPUT=b.txt\n", "line 10: the file 'b.txt' is included by a text in memory");
  refused(cube + "*NMAP\n1,2,3\n", "line 10: *NMAP changes or makes nodes or elements and is not read");
  refused("*SYSTEM\n0,0,0,0,0,0\n0,1,0\n", "line 3: the points of the system lie on each other or on a line");
  refused("*SYSTEM\n0,0,0\n0,1,0\n", "line 3: the system has a point of its plane and none of its axis");
  refused("*PART, NAME=p\n*END PART\n*INSTANCE, NAME=i, PART=p\n",
          "instance 'i' has no end: write *END INSTANCE before the end of the file.");
  refused("*END INSTANCE\n", "no instance ends here");
  refused("*PART, NAME=p\n*END PART\n*INSTANCE, NAME=i, INSTANCE=j\n",
          "an instance of an earlier analysis is not read");
  refused(cube + "*NSET, NSET=a, GENERATE\n5, 1\n", "line 11: the range from 5 to 1 is empty");
  refused(cube + "*NSET, NSET=a, GENERATE\n1, 5, 0\n", "line 11: the step of a range 0 is out of bounds");
  refused(cube + "*NSET, NSET=a, GENERATE\n1, 5, 1, 7\n", "line 11: a range has more than three numbers");
  refused("*NODE\n1, 0, <x>, 0\n", "line 2: parameter 'x' is not defined above");
  refused("*NODE\n1, 0, zero, 0\n", "line 2: the coordinate 'zero' is no number");
  refused("*NODE\n1.5, 0, 0, 0\n", "line 2: the number of a node '1.5' is no whole number");
  refused("*NODE\n-1, 0, 0, 0\n", "line 2: the number of a node -1 is out of bounds");
  refused("*NODE, SYSTEM=T\n", "the nodes have the system 'T': give R, C or S.");
  refused("*ELEMENT, ELSET=a\n", "*ELEMENT has no TYPE: write *ELEMENT, TYPE=...");
  refused("*ELEMENT, TYPE=C3D10M\n", "elements of type 'C3D10M' are of second order: cut them with");
  refused("*ELEMENT, TYPE=C3D15\n", "elements of type 'C3D15' are of second order: cut them");
  refused(cube + "*ELEMENT, TYPE=C3D8\n1,1,2,3,4,5,6,7\n*STEP\n", "element 1 of type C3D8 has 7 corners of 8");
  refused(cube + "*ELEMENT, TYPE=C3D4\n1,1,2,3,5,6\n", "element 1 has too many corners for its type C3D4");
  refused(cube + "*ELEMENT, TYPE=C3D8\n1,1,2,3,3,5,5,6,7\n",
          "line 11: element 1 has 6 different corners, but repeats them otherwise than a wedge, a b c d e e f f, or a "
          "pyramid, a b c d e e e e: correct it.");
  refused(cube + "*ELEMENT, TYPE=C3D6\n1,1,2,3,5,6,6\n", "line 11: element 1 has 5 different corners of 6");
  refused(cube + "*ELEMENT, TYPE=C3D5\n1,1,2,3,4\n", "element 1 of type C3D5 has 4 corners of 5");
  refused(cube + "*NSET, NSET=a\n1, 99\n", "line 11: node 99 is not in the file");
  refused(cube + "*NSET, NSET=a\nb\n", "line 11: set 'a' holds 'b', which is neither a number nor a set of the file");
  refused("*NSET\n1\n", "*NSET has no NSET");
  refused(cube + "*NSET, NSET=a\nb\n*NSET, NSET=b\na\n", "line 12: set 'b' holds itself by way of others");
  refused(cube + "*NSET, NSET=a, ELSET=b\n", "line 10: the set of elements 'b' is not in the file");
  refused(cube + "*ELEMENT, TYPE=B31\n1,1,2\n*ELEMENT, TYPE=MASS\n3,1\n*ELEMENT, TYPE=B31\n2,2,3\n",
          "line 10: elements of type B31 (2) are of a kind that is not read: take them out of the deck, or leave them "
          "out with {.leave_out_elements = true}.");
  refused("*END PART\n", "no part ends here");
  refused("*PART, NAME=a\n*NODE\n1,0,0,0\n", "a part has no end: write *END PART after it.");
  refused("*PART, NAME=a\n*PART, NAME=b\n", "a part begins within a part");
  refused("*PART, NAME=a\n*END PART\n*PART, NAME=A\n", "part 'A' is there twice");
  refused("*INSTANCE, NAME=a, PART=b\n", "part 'b' is not in the file");
  refused("*NSET, NSET=s, INSTANCE=i\n1\n", "instance 'i' is not in the file");
  refused("*PART, NAME=a\n*END PART\n*INSTANCE, NAME=i, PART=a\n0,0,0\n0,0,0,0,0,0,90\n",
          "the axis of the instance has no length");
}
