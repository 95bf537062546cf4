#include <string>

#include <strike/input/abaqus.hpp>

#include "support/catch.hpp"

using namespace strike;
using Catch::Matchers::ContainsSubstring;

namespace {

Deck read(const std::string& text) { return read_abaqus(text, "a.inp"); }

const std::string cube =
    "*NODE, NSET=all\n1,0,0,0\n2,1.,0,0\n3,1,1.0D0,0\n4,0,1,0\n5,0,0,1\n6,1,0,1\n7,1,1,1\n8,0,1,1\n";

}  // namespace

TEST_CASE("abaqus: a flat deck with sets, ranges and elements over two lines") {
  const Deck deck =
      read("*Heading\n  two cells\n** comment\n" + cube +
           "9, 0.5, 0.5, 2e0\n10\n77, 9, 9, 9\n*ELEMENT, TYPE=C3D8R, ELSET=BOX\n5, 1, 2, 3, 4,\n"
           " 5, 6, 7, 8\n*element, type=C3D4,\n  elset=tip\n6, 5,6,7,9\n*ELEMENT, TYPE=S3R, ELSET=skin\n"
           "7, 8, 9, 10\n*ELEMENT, TYPE=S4, ELSET=skin\n8, 1, 2, 2, 10\n*ELEMENT, TYPE=R3D4\n9, 1,2,3,4\n"
           "*NSET, NSET=left, GENERATE\n1, 1000000000, 4\n*NSET, NSET=\"both of them\"\nleft, 2, \n"
           "*ELSET, ELSET=solids\nBOX, TIP, 9\n*MATERIAL, NAME=steel\n*ELASTIC\n2e11, .3\n*STEP\n*STEP\n");
  CHECK(deck.title == "two cells");
  CHECK(deck.mesh.nodes.size() == 10);
  CHECK(deck.mesh.nodes[9] == Eigen::Vector3d(0, 0, 0));
  CHECK(deck.part("BOX").hexahedra == Cells<8>{{0, 1, 2, 3, 4, 5, 6, 7}});
  CHECK(deck.part("tip").tetrahedra == Cells<4>{{4, 5, 6, 8}});
  CHECK(deck.part("skin").quadrilaterals == Cells<4>{{7, 8, 9, 9}, {9, 0, 1, 1}});
  CHECK(deck.part("solids").hexahedra.size() == 1);
  CHECK(deck.part("solids").tetrahedra.size() == 1);
  CHECK(deck.cell_numbers == std::vector<FileNumber>{5, 6, 7, 8});
  CHECK(deck.nodes("all").size() == 10);
  CHECK(deck.nodes("left") == std::vector<Index>{0, 4, 8});
  CHECK(deck.nodes("both of them") == std::vector<Index>{0, 1, 4, 8});
  CHECK(deck.warnings == std::vector<std::string>{
                             "Nodes without an element (1, the first has the number 77) were dropped.",
                             "*MATERIAL (1) was skipped: line 34.",
                             "*ELASTIC (1) was skipped: line 35.",
                             "*STEP (2) was skipped: lines 37, 38.",
                             "Elements of type R3D4 (1) were ignored: line 27.",
                         });
}

TEST_CASE("abaqus: surfaces of gmsh are plates unless they lie on solids") {
  const Deck deck = read(cube +
                         "9, 2\n10, 2, 1\n*ELEMENT, TYPE=CPS4, ELSET=Surface1\n1,1,2,3,4\n2,2,9,10,3\n"
                         "*ELEMENT, TYPE=CPS3, ELSET=Surface2\n3,2,9,10\n*ELEMENT, TYPE=C3D8\n4,1,2,3,4,5,6,7,8\n"
                         "*ELSET, ELSET=side\n1, 2, \n");
  CHECK(deck.mesh.hexahedra.size() == 1);
  CHECK(deck.mesh.quadrilaterals == Cells<4>{{1, 8, 9, 2}, {1, 8, 9, 9}});
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

TEST_CASE("abaqus: what is wrong is told with its line") {
  const auto refused = [](const std::string& text, const std::string& sentence) {
    CHECK_THROWS_WITH(read(text), ContainsSubstring("strike: the file 'a.inp', line ") && ContainsSubstring(sentence));
  };
  refused("", "the file has no keyword");
  refused("*INCLUDE, INPUT=b.inp\n", "line 1: *INCLUDE is not followed: put the text of that file here.");
  refused("*NODE\n1, 0, zero, 0\n", "line 2: the coordinate 'zero' is no number");
  refused("*NODE\n1.5, 0, 0, 0\n", "line 2: the number of a node '1.5' is no whole number");
  refused("*NODE\n-1, 0, 0, 0\n", "line 2: the number of a node -1 is out of bounds");
  refused("*NODE, SYSTEM=C\n", "the nodes have the system 'C': give Cartesian coordinates.");
  refused("*ELEMENT, ELSET=a\n", "*ELEMENT has no TYPE: write *ELEMENT, TYPE=...");
  refused("*ELEMENT, TYPE=C3D10M\n", "elements of type 'C3D10M' are not read: mesh in first order");
  refused("*ELEMENT, TYPE=C3D6\n", "elements of type 'C3D6' are not read");
  refused(cube + "*ELEMENT, TYPE=C3D8\n1,1,2,3,4,5,6,7\n*STEP\n", "element 1 of type C3D8 has 7 corners of 8");
  refused(cube + "*ELEMENT, TYPE=C3D4\n1,1,2,3,5,6\n", "element 1 has too many corners for its type C3D4");
  refused(cube + "*ELEMENT, TYPE=C3D8\n1,1,2,3,3,5,6,7,7\n", "line 11: element 1 is a wedge");
  refused(cube + "*ELEMENT, TYPE=C3D8\n1,1,2,3,4,5,5,5,5\n", "line 11: element 1 is a pyramid");
  refused(cube + "*NSET, NSET=a\n1, 99\n", "line 11: node 99 is not in the file");
  refused(cube + "*NSET, NSET=a\nb\n", "set 'a' holds 'b', which is neither a number nor a set before it");
  refused("*NSET\n1\n", "*NSET has no NSET");
  refused("*PART, NAME=a\n*NODE\n1,0,0,0\n", "a part has no end: write *END PART after it.");
  refused("*PART, NAME=a\n*PART, NAME=b\n", "a part begins within a part");
  refused("*PART, NAME=a\n*END PART\n*PART, NAME=A\n", "part 'A' is there twice");
  refused("*INSTANCE, NAME=a, PART=b\n", "part 'b' is not in the file");
  refused("*NSET, NSET=s, INSTANCE=i\n1\n", "instance 'i' is not in the file");
  refused("*PART, NAME=a\n*END PART\n*INSTANCE, NAME=i, PART=a\n0,0,0\n0,0,0,0,0,0,90\n",
          "the axis of the instance has no length");
}
