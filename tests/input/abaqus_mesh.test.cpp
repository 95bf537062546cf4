#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>

#include <strike/input/abaqus.hpp>

#include "output/scratch.hpp"
#include "support/catch.hpp"

using namespace strike;
using Catch::Matchers::ContainsSubstring;

namespace {

Deck read(const std::string& text, const ReadOptions& options = {}) { return read_abaqus(text, "a.inp", options); }
void refused(const std::string& text, const std::string& sentence) {
  CHECK_THROWS_WITH(read(text), ContainsSubstring("strike: the file 'a.inp', line ") && ContainsSubstring(sentence));
}
void write(const std::string& path, const std::string& text) {
  std::filesystem::create_directories(std::filesystem::path(path).parent_path());
  std::ofstream(path, std::ios::binary) << text;
}
bool is_near(const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return (a - b).norm() < 1e-12 * (1 + b.norm()); }

const std::string square = "*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,0\n4,0,1,0\n";
const std::string shell = "*ELEMENT, TYPE=S4, ELSET=plate\n1,1,2,3,4\n";

}  // namespace

TEST_CASE("abaqus include: whole keywords, data lines and the files of INPUT make one deck") {
  const ScratchFolder folder("abaqus-include");
  write(folder / "mesh/nodes.txt", "\xEF\xBB\xBF** nodes\r\n1,0,0,0\r\n2,1,0,0");
  write(folder / "mesh/more.inp", "3,1,1,0\n*NODE\n4,0,1,0\n*Include, input=\"../shell.inp\"\n");
  write(folder / "shell.inp", shell);
  write(folder / "fixed.txt", "1, 2\n");
  write(folder / "deck.inp",
        "*NODE, NSET=all, INPUT=mesh/nodes.txt\n*INCLUDE, INPUT=mesh\\more.inp\n*NSET, NSET=fixed, INPUT=fixed.txt\n4\n"
        "*MATERIAL, NAME=m, INPUT=not_there.txt\n");
  const Deck deck = read_abaqus(folder / "deck.inp");
  CHECK(deck.mesh.nodes.size() == 4);
  CHECK(deck.nodes("all") == std::vector<Index>{0, 1, 2});  // the data lines of *NODE go on in the included file
  CHECK(deck.nodes("fixed") == std::vector<Index>{0, 1, 3});
  CHECK(deck.part("plate").quadrilaterals.size() == 1);

  const auto sentence_of = [&](const std::string& name, const ReadOptions& options = {}) -> std::string {
    try {
      read_abaqus(folder / name, options);
    } catch (const Error& error) {
      return error.what();
    }
    return {};
  };
  write(folder / "in/wrong.inp", "*NODE\n1,x\n");
  write(folder / "in/deck.inp", "*HEADING\n\n*INCLUDE, INPUT=wrong.inp\n");
  write(folder / "in/outside.inp", "*INCLUDE, INPUT=../deck.inp\n");
  write(folder / "in/outside_nodes.inp", "*NODE, INPUT=../fixed.txt\n");
  write(folder / "in/self.inp", "*INCLUDE, INPUT=self.inp\n");
  write(folder / "in/missing.inp", "*INCLUDE, INPUT=no.inp\n");
  CHECK_THAT(sentence_of("in/deck.inp"), ContainsSubstring(folder / "in/wrong.inp" + "', line 2: the coordinate 'x'"));
  CHECK_THAT(sentence_of("in/outside.inp"), ContainsSubstring("is outside of the folder"));
  CHECK_THAT(sentence_of("in/outside_nodes.inp"), ContainsSubstring("is outside of the folder"));
  CHECK_THAT(sentence_of("in/outside.inp", {.anywhere = true}), Catch::Matchers::Equals(""));
  CHECK_THAT(sentence_of("in/self.inp"), ContainsSubstring("includes itself"));
  CHECK_THAT(sentence_of("in/missing.inp"), ContainsSubstring("line 1: the included file 'no.inp' is not there"));
}

TEST_CASE("abaqus: keywords are read as the format has them") {
  const Deck deck = read(
      "\xEF\xBB\xBF  *no de , nset = \"left and low\" ,\n  SYSTEM = r\r\n 1 , 0. , .0E0 , 0\n2,1.D0,,\n"
      "** between\n\n3, 1, 1\n4, 0, 1, 0\n*Element,typ=S4R,els=A plate\n1,1,\n2,3,\n4\n"
      "*nset,nset=My Set\nleft and low ,\n*NSET, NSET=mine\nMYSET\n*NSET, NSET=two, GENER\n1, 3, 2\n");
  CHECK(deck.nodes("left and low").size() == 4);
  CHECK(deck.part("A plate").quadrilaterals == Cells<4>{{0, 1, 2, 3}});
  CHECK(deck.nodes("mine").size() == 4);
  CHECK(deck.nodes("two") == std::vector<Index>{0, 2});
}

TEST_CASE("abaqus: parameters are values, expressions of Python and texts") {
  const Deck deck = read(
      "*PARAMETER\n# a plate\nwidth = 2.5\nn=4\nheight = width**2/5 - 1.25  # of it\nsum = -2**2 + n/2\n"
      "name = 'a plate'\nlast = max(3, int(n + .5)) # 4\n*NODE\n1, 0, <sum>\n2, <width>\n"
      "3, <width>, < height >\n<last>, 0, <HEIGHT>\n*ELEMENT, TYPE=S4, ELSET=\"<name>\"\n1,1,2,3,<n>\n");
  CHECK(deck.mesh.nodes ==
        std::vector<Eigen::Vector3d>{{0, -2, 0}, {2.5, 0, 0}, {2.5, 0, 0}, {0, 0, 0}});  // -2**2 is -4
  CHECK(deck.part("a plate").quadrilaterals.size() == 1);
  refused("*PARAMETER\na = 2/5\n", "line 2: parameter 'a' has no value: whole numbers divide with a remainder");
  refused("*PARAMETER\na = 2*b\n", "line 2: parameter 'a' has no value: parameter 'B' is not defined above");
  refused("*PARAMETER\na = 2^2\n", "parameter 'a' has no value");
  refused("*PARAMETER\na\n", "a parameter is a line name = value");
  refused("*PARAMETER\na = 1\nA = 2\n", "parameters 'a' and 'A' differ in capitals alone");
  refused("*PARAMETER, DEPENDENT, TABLE=t\na\n", "*PARAMETER with DEPENDENT is not read");
  refused("*NODE\n1, <a>\n", "line 2: parameter 'a' is not defined above");
}

TEST_CASE("abaqus: a system turns the nodes that follow, which may be cylindrical or spherical") {
  const auto node = [](const std::string& before, const std::string& x) {
    return read(before + "*NODE, SYSTEM=R\n9,8,8,8\n8,8,8,8\n7,8,8,8\n" + x + "*ELEMENT, TYPE=C3D4\n1,1,7,8,9\n")
        .mesh.nodes.back();
  };
  const std::string x = "*NODE\n1, 1, 2, 3\n";
  CHECK(is_near(node("*SYSTEM\n10,0,0, 10,5,0, \n10,0,7\n", x), {10 + 2 * 0 + 3, 1, 2}));  // x' = y, y' = z, z' = x
  CHECK(is_near(node("*SYSTEM\n0,0,1, 0,3,9\n", x), {-2, 1, 4}));  // turned about z, the height of the point left out
  CHECK(is_near(node("*SYSTEM\n1,2,3,4,2,3\n", x), {2, 4, 6}));
  const double s = std::sqrt(.5);
  CHECK(is_near(node("", "*NODE, SYSTEM=C\n1, 2, 45, 3\n"), {2 * s, 2 * s, 3}));
  CHECK(is_near(node("", "*NODE, SYSTEM=S\n1, 2, 90, 30\n"), {0, std::sqrt(3.), 1}));
  CHECK(is_near(node("*SYSTEM\n0,0,0,0,1,0,\n", "*NODE, SYSTEM=C\n1, 2, 90, 3\n"), {-2, 0, 3}));
}

TEST_CASE("abaqus: nodes are made on lines, on arcs and between sets") {
  const Deck line = read(square +
                         "*NGEN, NSET=foot\n1, 2, 1\n*NODE\n11,0,2,0\n19,4,2,0\n*NGEN, NSET=top\n11, 19, 2\n"
                         "*NODE\n31,0,6,0\n39,4,6,0\n*NGEN, NSET=bottom\n31,39,2\n*NFILL, NSET=all\n"
                         "top, bottom, 2, 10\n*ELEMENT, TYPE=S4\n1,11,13,23,21\n2,27,29,39,37\n3,1,2,3,4\n");
  CHECK(line.nodes("foot").size() == 2);
  CHECK(line.nodes("top").size() == 2);  // the others are in no element
  CHECK(line.nodes("all").size() == 8);
  CHECK(is_near(line.mesh.nodes[line.mesh.quadrilaterals[0][2]], {1, 4, 0}));  // 23
  CHECK(is_near(line.mesh.nodes[line.mesh.quadrilaterals[1][0]], {3, 4, 0}));  // 27

  const auto arc = [](const std::string& end, const std::string& data, const std::string& system = "") {
    const Deck deck = read(system + "*NODE\n1,2,0,1\n4," + end + "\n99,0,0,1\n8,9,9,9\n*NGEN, LINE=C\n1,4,1," + data +
                           "\n*ELEMENT, TYPE=C3D4\n1,1,2,3,8\n*ELEMENT, TYPE=S3\n2,1,4,99\n");
    return std::array{deck.mesh.nodes[deck.mesh.tetrahedra[0][1]], deck.mesh.nodes[deck.mesh.tetrahedra[0][2]]};
  };
  const auto on_circle = [](double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    return Eigen::Vector3d(2 * std::cos(angle), 2 * std::sin(angle), 1);
  };
  for (const std::string centre : {"99", ",0,0,1"}) {
    const auto [a, b] = arc("0,2,1", centre);
    CHECK(is_near(a, on_circle(30)));
    CHECK(is_near(b, on_circle(60)));
  }
  CHECK(is_near(arc("0,-2,1", "99")[1], on_circle(-60)));               // the short way
  CHECK(is_near(arc("0,-2,1", "99,,,,0,0,5")[1], on_circle(180)));      // 270 degrees about z
  CHECK(is_near(arc("-2,0,1", "99,0,0,0,0,0,-1")[0], on_circle(-60)));  // 180 about -z
  CHECK(is_near(arc("2,0,1", "99,0,0,0,0,0,1")[0], on_circle(120)));    // a whole circle
  refused(square + "*NGEN, LINE=C\n1,2,1,4\n", "line 7: the two nodes are not as far from the centre");
  refused("*NODE\n1,1\n2,-1\n3\n*NGEN, LINE=C\n1,2,1,3\n", "an arc of 180 degrees and more has no plane");
  refused("*NODE\n1,1\n2,0,1\n3\n*NGEN, LINE=C\n1,2,1,3,,,,1,0,0\n", "the normal is not square to the arc");
  refused(square + "*NGEN, LINE=P\n1,2,1,4\n", "*NGEN with LINE=P is not read");
  refused(square + "*NGEN\n1,4,2\n", "the numbers from 1 do not reach 4 by steps of 2");
  refused(square + "*NGEN\n1,9\n", "node 9 is not above");
  refused(square + "*NODE\n1000000000\n*NGEN\n4,1000000000\n", "*NGEN makes more nodes and elements than a file of");
  refused(square + "*NFILL, BIAS=.5\n1,2,2\n", "*NFILL with BIAS=.5 is not read");
  refused(square + "*NSET, NSET=a\n1,2\n*NFILL\na,3,2\n", "the sets 'a' and '3' have 2 and 1 nodes");
  refused(square + "*NSET, NSET=a, UNSORTED\n2,1\n*NFILL\na,a,2\n", "'a' is UNSORTED, and its order is not kept");
  refused(square + "*NFILL\na,3,2\n", "the set of nodes 'a' is not above");
}

TEST_CASE("abaqus: nodes and elements are copied") {
  const std::string tail = "*ELCOPY, OLD SET=plate, ELEMENT SHIFT=5, SHIFT NODES=10, NEW SET=copy\n";
  const auto copied = [&](const std::string& how, const std::string& data) {
    const Deck deck =
        read(square + shell + "*NSET, NSET=n, GENERATE\n1,4\n*NCOPY, CHANGE NUMBER=10, OLD SET=n, NEW SET=m, " + how +
             "\n" + data + tail);
    CHECK(deck.nodes("m").size() == 4);
    CHECK(deck.part("copy").quadrilaterals == Cells<4>{{4, 5, 6, 7}});
    CHECK(deck.cell_numbers == std::vector<FileNumber>{1, 6});
    return deck.mesh.nodes[5];  // of (1, 0, 0)
  };
  CHECK(is_near(copied("SHIFT", "0,0,2\n"), {1, 0, 2}));
  CHECK(is_near(copied("SHIFT", "1,0,0\n0,0,0,0,0,7,90\n"), {0, 2, 0}));  // shifted, then turned
  CHECK(is_near(copied("REFLECT=MIRROR", "3,0,0,3,1,0\n3,0,1\n"), {5, 0, 0}));
  CHECK(is_near(copied("REFLECT=LINE", "0,1,0,1,1,0\n"), {1, 2, 0}));
  CHECK(is_near(copied("REFLECT=POINT", "0,1,0\n"), {-1, 2, 0}));
  refused(square + "*NSET, NSET=n\n1\n*NCOPY, CHANGE NUMBER=1, OLD SET=n, POLE\n", "*NCOPY with POLE is not read");
  refused(square + shell + "*ELCOPY, OLD SET=plate, ELEMENT SHIFT=1, SHIFT NODES=1, REFLECT\n", "*ELCOPY with REFLECT");
  refused(square + shell + "*ELCOPY, OLD SET=other, ELEMENT SHIFT=1, SHIFT NODES=1\n", "'other' is not above");
  refused(square + shell + "*ELCOPY, OLD SET=plate, ELEMENT SHIFT=1, SHIFT NODES=-1\n", "gives a node the number 0");
}

TEST_CASE("abaqus: an element is repeated in rows and layers") {
  std::string nodes = "*NODE\n";
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 5; ++i)
        nodes += std::to_string(1 + i + 10 * j + 100 * k) + "," + std::to_string(i) + "," + std::to_string(j) + "," +
                 std::to_string(k) + "\n";
  const Deck deck = read(nodes +
                         "*ELEMENT, TYPE=C3D8\n1,1,2,12,11,101,102,112,111\n*ELGEN, ELSET=block\n"
                         "1, 4,1,1, 3,10,10, 2,100,100\n");
  CHECK(deck.part("block").hexahedra.size() == 4 * 3 * 2);
  double volume = 0;
  for (const auto& c : deck.mesh.hexahedra) {
    const auto& x = deck.mesh.nodes;
    const Eigen::Vector3d a = x[c[1]] - x[c[0]], b = x[c[3]] - x[c[0]];
    volume += cross<double>(a, b).dot(x[c[4]] - x[c[0]]);
  }
  CHECK(volume == 24);
  CHECK(deck.cell_numbers.back() == 124);
  refused(nodes + "*ELGEN\n1,2\n", "element 1 is not above");
  refused(square + shell + "*ELGEN\n1,3000,1,1,3000,1,1,3000,1,1\n", "*ELGEN makes more nodes and elements than");
  refused(square + shell + "*ELGEN\n1,2000000000000\n", "out of bounds");
}

TEST_CASE("abaqus: a set may name one that comes after it, and the nodes of elements") {
  const Deck deck = read("*NSET, NSET=a\nb, 1\n*NSET, NSET=b\nc\n*NSET, NSET=c\n2\n*NSET, NSET=corner, ELSET=both\n" +
                         square + "5,2,0,0\n6,2,1,0\n*ELSET, ELSET=both\nplate\n" + shell + "*NSET, NSET=c\n3\n");
  CHECK(deck.nodes("a") == std::vector<Index>{0, 1, 2});
  CHECK(deck.part("both").quadrilaterals.size() == 1);
  CHECK(deck.nodes("corner") == std::vector<Index>{0, 1, 2, 3});
}

TEST_CASE("abaqus: sets of an assembly are those of their instances, in turned parts of parts too") {
  const Deck deck =
      read("*PART, NAME=p\n*NSET, NSET=first\nlater\n" + square + shell +
           "*NSET, NSET=later\n1,2\n*NSET, NSET=plate, ELSET=plate\n*END PART\n*ASSEMBLY, NAME=a\n"
           "*INSTANCE, NAME=i, PART=p\n*END INSTANCE\n*INSTANCE, NAME=j, PART=p\n0,0,1\n*END INSTANCE\n"
           "*NSET, NSET=both\ni.first, j.first\n*NSET, NSET=one, INSTANCE=j\nfirst, 4\n"
           "*NSET, NSET=of, ELSET=plate, INSTANCE=j\n*ELSET, ELSET=e, INSTANCE=j\nplate\n*END ASSEMBLY\n");
  CHECK(deck.nodes("both") == std::vector<Index>{0, 1, 4, 5});
  CHECK(deck.nodes("one") == std::vector<Index>{4, 5, 7});
  CHECK(deck.nodes("of") == std::vector<Index>{4, 5, 6, 7});
  CHECK(deck.nodes("i.plate").size() == 4);
  CHECK(deck.part("e").quadrilaterals == Cells<4>{{4, 5, 6, 7}});
}

TEST_CASE("abaqus: parts of a file without instances are placed as they are") {
  const Deck deck = read("*PART, NAME=p\n" + square + shell + "*END PART\n*PART, NAME=q\n*NODE\n1,5\n*END PART\n");
  CHECK(deck.part("p").quadrilaterals.size() == 1);
  CHECK(deck.part("p.plate").quadrilaterals.size() == 1);
  CHECK(deck.warnings == std::vector<std::string>{"Part 'p' has no instance and was placed as it is: line 1."});
}

TEST_CASE("abaqus: a node may be there again at the same place") {
  CHECK(read(square + square + shell).mesh.nodes.size() == 4);
  refused(square + "*NODE\n1,0,0,1\n" + shell, "line 7: node 1 is on line 2 already");
}
