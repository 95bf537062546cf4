#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <string>

#include <strike/input/gmsh.hpp>

#include "support/catch.hpp"

using namespace strike;
using Catch::Matchers::ContainsSubstring;

namespace {

const std::string head = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";

/// A brick with two tetrahedra on top, its foot as triangles, an edge, a point, and a node of no element.
const std::string brick = head +
                          "$PhysicalNames\n4\n3 1 \"soft body\"\n3 2 \"tip\"\n2 3 \"foot\"\n1 4 \"edge\"\n"
                          "$EndPhysicalNames\n$Nodes\n11\n10 0 0 0\n20 1 0 0\n30 1 1 0\n40 0 1 0\n50 0 0 1\n"
                          "60 1 0 1\n70 1 1 1\n80 0 1 1\n90 .5 .5 2\n100 5 5 5\n110 0.0 -1e-3 +2.5E+1\n$EndNodes\n"
                          "$Elements\n8\n1 15 2 0 1 10\n2 1 2 4 1 10 20\n3 2 2 3 1 10 30 20\n4 2 2 3 1 10 40 30\n"
                          "5 5 2 1 1 10 20 30 40 50 60 70 80\n6 4 2 2 2 50 60 70 90\n7 4 2 2 2 50 70 80 90\n"
                          "8 3 2 0 9 70 80 90 110\n$EndElements\n$NodeData\n1\n$EndNodeData\n";

Deck read(const std::string& text) { return read_gmsh(text, "a.msh"); }

}  // namespace

TEST_CASE("gmsh: version 2.2 with groups, faces on solids, lines and an orphan") {
  const Deck deck = read(brick);
  CHECK(deck.mesh.nodes.size() == 10);
  CHECK(deck.mesh.nodes[9] == Eigen::Vector3d(0, -1e-3, 25));
  CHECK(deck.node_numbers == std::vector<FileNumber>{10, 20, 30, 40, 50, 60, 70, 80, 90, 110});
  CHECK(deck.mesh.hexahedra == Cells<8>{{0, 1, 2, 3, 4, 5, 6, 7}});
  CHECK(deck.mesh.tetrahedra == Cells<4>{{4, 5, 6, 8}, {4, 6, 7, 8}});
  CHECK(deck.mesh.quadrilaterals == Cells<4>{{6, 7, 8, 9}});
  CHECK(deck.cell_numbers == std::vector<FileNumber>{5, 6, 7, 8});
  CHECK(deck.part("soft body").hexahedra.size() == 1);
  CHECK(deck.part(2).tetrahedra.size() == 2);
  CHECK(deck.part("surface 9").quadrilaterals.size() == 1);
  CHECK_THROWS_WITH(deck.part("foot"), ContainsSubstring("give one of 'soft body', 'tip', 'surface 9'."));
  CHECK(deck.nodes("foot") == std::vector<Index>{0, 1, 2, 3});
  CHECK(deck.nodes("edge") == std::vector<Index>{0, 1});
  CHECK(deck.nodes("point 1") == std::vector<Index>{0});
  CHECK(deck.warnings == std::vector<std::string>{
                             "Surface elements on solids (2) mark faces, and are no plates.",
                             "Nodes without an element (1, the first has the number 100) were dropped.",
                             "$NodeData (1) was skipped: line 36.",
                             "Points (1) were ignored: line 27.",
                             "Lines (1) were ignored: line 28.",
                         });
}

TEST_CASE("gmsh: version 4.1 with entities in two groups and parametric nodes") {
  const Deck deck = read(
      "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n2 1 \"all\"\n2 2 \"left\"\n$EndPhysicalNames\n"
      "$Entities\n1 1 2 0\n1 0 0 0 0\n1 0 0 0 1 0 0 0 2 1 -1\n1 0 0 0 1 1 0 2 1 2 1 1\n2 0 0 0 1 1 0 1 1 0\n"
      "$EndEntities\n$Nodes\n2 5 1 5\n2 1 1 3\n1\n2\n3\n0 0 0 .1 .2\n1 0 0 .1 .2\n1 1 0 .1 .2\n2 2 0 2\n4\n5\n"
      "0 1 0\n2 0 0\n$EndNodes\n$Elements\n2 2 1 2\n2 1 3 1\n1 1 2 3 4\n2 2 2 1\n2 2 5 3\n$EndElements\n");
  CHECK(deck.mesh.quadrilaterals == Cells<4>{{0, 1, 2, 3}});
  CHECK(deck.mesh.triangles == Cells<3>{{1, 4, 2}});
  CHECK(deck.part("all").quadrilaterals.size() == 1);
  CHECK(deck.part("all").triangles.size() == 1);
  CHECK(deck.part("left").quadrilaterals == Cells<4>{{0, 1, 2, 3}});
  CHECK(deck.nodes("left") == std::vector<Index>{0, 1, 2, 3});
  CHECK(deck.warnings.empty());
}

TEST_CASE("gmsh: a group that is listed twice holds its elements once") {
  const std::string nodes =
      "$Nodes\n1 8 1 8\n3 1 0 8\n1\n2\n3\n4\n5\n6\n7\n8\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n"
      "0 1 1\n$EndNodes\n$Elements\n1 1 1 1\n3 1 5 1\n1 1 2 3 4 5 6 7 8\n$EndElements\n";
  for (const char* entities : {"0 0 0 1\n1 0 0 0 0 0 0 2 7 7 0\n", "0 0 0 1\n1 0 0 0 0 0 0 3 7 -7 7 0\n",
                               "0 0 0 2\n1 0 0 0 0 0 0 1 7 0\n1 0 0 0 0 0 0 1 7 0\n"}) {
    const Deck deck =
        read(std::string("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n") + entities + "$EndEntities\n" + nodes);
    CHECK(deck.part(7).hexahedra.size() == 1);
    CHECK(deck.parts.size() == 1);
  }
}

TEST_CASE("gmsh: version 2 writes an element once for each of its groups, which is one element") {
  const Deck deck = read(
      "$MeshFormat\n2.1 0 8\n$EndMeshFormat\n$PhysicalNames\n3\n2 1 \"left\"\n2 2 \"all\"\n2 3 \"other\"\n"
      "$EndPhysicalNames\n$Nodes\n6\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 2 0 0\n6 2 1 0\n$EndNodes\n"
      "$Elements\n5\n1 3 2 1 1 1 2 3 4\n2 3 2 2 1 1 2 3 4\n3 3 2 2 2 2 5 6 3\n4 3 2 -3 3 2 5 6 3\n"
      "5 3 2 2 1 1 2 3 4\n$EndElements\n");
  CHECK(deck.mesh.quadrilaterals.size() == 3);  // two entities may lie on each other
  CHECK(deck.part("left").quadrilaterals == Cells<4>{{0, 1, 2, 3}});
  CHECK(deck.part("all").quadrilaterals == Cells<4>{{0, 1, 2, 3}, {1, 4, 5, 2}});
  CHECK(deck.part("other").quadrilaterals == Cells<4>{{1, 4, 5, 2}});  // -3: turned over
  CHECK(deck.nodes("left") == std::vector<Index>{0, 1, 2, 3});
  CHECK(deck.cell_numbers == std::vector<FileNumber>{1, 3, 4});
}

TEST_CASE("gmsh: every version of 2 and 4 tells the same mesh") {
  const std::string names = "$PhysicalNames\n1\n3 5 \"bar\"\n$EndPhysicalNames\n";
  const std::string nodes2 = "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n";
  const std::string parametric =
      "$ParametricNodes\n4\n1 0 0 0 0 1\n2 1 0 0 1 1 .5\n3 0 1 0 2 1 .5 .5\n4 0 0 1 3 1\n$EndParametricNodes\n";
  const std::string elements2 = "$Elements\n1\n1 4 4 5 1 1 2 1 2 3 4\n$EndElements\n";  // in partition 2
  const std::string entities40 = "$Entities\n1 0 0 1\n1 0 0 0 0 0 0 0\n1 0 0 0 1 1 1 1 5 0\n$EndEntities\n";
  const std::string mesh40 =
      "$Nodes\n2 4\n1 0 1 1\n1 0 0 0\n1 2 1 3\n2 1 0 0 .1 .2\n3 0 1 0 .1 .2\n4 0 0 1 .1 .2\n$EndNodes\n"
      "$Elements\n1 1\n1 3 4 1\n1 1 2 3 4\n$EndElements\n";
  const std::string mesh41 =
      "$Entities\n1 0 0 1\n1 0 0 0 0\n1 0 0 0 1 1 1 1 5 0\n$EndEntities\n$Nodes\n1 4 1 4\n3 1 0 4\n1\n2\n3\n4\n"
      "0 0 0\n1 0 0\n0 1 0\n0 0 1\n$EndNodes\n$Elements\n1 1 1 1\n3 1 4 1\n1 1 2 3 4\n$EndElements\n";
  const auto format = [](const std::string& version) { return "$MeshFormat\n" + version + " 0 8\n$EndMeshFormat\n"; };
  for (const std::string& text :
       {format("2") + "$PhysicalNames\n1\n5 \"bar\"\n$EndPhysicalNames\n" + nodes2 + elements2,
        format("2.0") + names + nodes2 + elements2, format("2.1") + names + nodes2 + elements2,
        format("2.2") + names + parametric + elements2, format("4") + names + entities40 + mesh40,
        format("4.0") + names + entities40 + mesh40, format("4.1") + names + mesh41}) {
    INFO(text);
    const Deck deck = read(text);
    CHECK(deck.mesh.nodes == std::vector<Eigen::Vector3d>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    CHECK(deck.part("bar").tetrahedra == Cells<4>{{0, 1, 2, 3}});
    CHECK(deck.warnings.empty());
  }
}

namespace {

/// Binary sections, in the byte order of this machine or the other.
struct Bytes {
  bool swaps = false;
  std::string text = {};

  template <class T>
  Bytes& add(T value) {
    std::string bytes(sizeof(T), ' ');
    std::memcpy(bytes.data(), &value, sizeof(T));
    if (swaps) std::reverse(bytes.begin(), bytes.end());
    text += bytes;
    return *this;
  }
  Bytes& ints(std::initializer_list<std::int32_t> values) {
    for (const std::int32_t value : values) add(value);
    return *this;
  }
  template <class Size = std::uint64_t>
  Bytes& sizes(std::initializer_list<unsigned> values) {
    for (const unsigned value : values) add(Size(value));
    return *this;
  }
  Bytes& reals(std::initializer_list<double> values) {
    for (const double value : values) add(value);
    return *this;
  }
  Bytes& lines(const std::string& more) {
    text += more;
    return *this;
  }
};
const std::string group_bar = "$PhysicalNames\n2\n3 5 \"bar\"\n2 6 \"foot\"\n$EndPhysicalNames\n";

/// Two tetrahedra on a foot of one triangle, and a section that is not read.
std::string binary22(bool swaps, std::int32_t in_block = 2, double last = 10) {
  Bytes file{swaps};
  file.lines("$MeshFormat\n2.2 1 8\n").ints({1}).lines("\n$EndMeshFormat\n" + group_bar + "$Nodes\n5\n");
  file.ints({10}).reals({0, 0, 0}).ints({20}).reals({1, 0, 0}).ints({30}).reals({0, 1, 0});
  file.ints({40}).reals({0, 0, 1}).ints({50}).reals({0, 0, last}).lines("\n$EndNodes\n$Elements\n3\n");
  file.ints({2, 1, 2, 1, 6, 1, 10, 30, 20});
  file.ints({4, in_block, 4, 2, 5, 1, 1, 1, 10, 20, 30, 40, 3, 5, 1, 2, -2, 40, 30, 20, 50});
  return file.lines("\n$EndElements\n$NodeData\n1\n").ints({10}).reals({1}).lines("$EndNodeData\n").text;
}
/// The same, its volume cut into two.
template <class Size = std::uint64_t>
std::string binary41(bool swaps, unsigned nodes = 5) {
  Bytes file{swaps};
  const auto sizes = [&](std::initializer_list<unsigned> values) { file.sizes<Size>(values); };
  file.lines("$MeshFormat\n4.1 1 " + std::to_string(sizeof(Size)) + "\n").ints({1}).lines("\n$EndMeshFormat\n");
  file.lines(group_bar + "$Entities\n"), sizes({1, 0, 1, 1});
  file.ints({7}).reals({0, 0, 0}), sizes({0});
  file.ints({8}).reals({0, 0, 0, 1, 1, 1}), sizes({1}), file.ints({-6}), sizes({0});
  file.ints({9}).reals({0, 0, 0, 1, 1, 1}), sizes({1}), file.ints({5}), sizes({1}), file.ints({8});
  file.lines("\n$EndEntities\n$PartitionedEntities\n"), sizes({2, 1}), file.ints({30, 2}), sizes({0, 0, 1, 2});
  file.ints({18, 2, 8}), sizes({1}), file.ints({1}).reals({0, 0, 0, 1, 1, 1}), sizes({1}), file.ints({6}), sizes({0});
  file.ints({19, 3, 9}), sizes({1}), file.ints({1}).reals({0, 0, 0, 1, 1, 1}), sizes({1}), file.ints({5}), sizes({0});
  file.ints({20, 3, 9}), sizes({1}), file.ints({2}).reals({0, 0, 0, 1, 1, 1}), sizes({0}), sizes({1}), file.ints({-8});
  file.lines("\n$EndPartitionedEntities\n$Nodes\n"), sizes({1, 5, 10, 50}), file.ints({2, 18, 1});
  sizes({nodes, 10, 20, 30, 40, 50});
  file.reals({0, 0, 0, .1, .2, 1, 0, 0, .1, .2, 0, 1, 0, .1, .2, 0, 0, 1, .1, .2, 0, 0, 10, .1, .2});
  file.lines("\n$EndNodes\n$Elements\n"), sizes({3, 3, 1, 3});
  file.ints({2, 18, 2}), sizes({1, 1, 10, 30, 20});
  file.ints({3, 19, 4}), sizes({1, 2, 10, 20, 30, 40});
  file.ints({3, 20, 4}), sizes({1, 3, 40, 30, 20, 50});
  return file.lines("\n$EndElements\n$GhostElements\n").ints({3}).lines("\n$EndGhostElements\n").text;
}

}  // namespace

TEST_CASE("gmsh: binary files of both byte orders and both sizes, partitioned ones with their groups") {
  for (const bool swaps : {false, true})
    for (const std::string& text : {binary22(swaps), binary41(swaps), binary41<std::uint32_t>(swaps)}) {
      const Deck deck = read(text);
      CHECK(deck.mesh.nodes == std::vector<Eigen::Vector3d>{
                                   {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 10}});  // 10 is an end of line
      CHECK(deck.part("bar").tetrahedra == Cells<4>{{0, 1, 2, 3}, {3, 2, 1, 4}});
      CHECK(deck.nodes("foot") == std::vector<Index>{0, 1, 2});
      CHECK(deck.node_numbers == std::vector<FileNumber>{10, 20, 30, 40, 50});
      CHECK(deck.parts.size() == 1);
      REQUIRE(deck.warnings.size() == 2);
      CHECK(deck.warnings[0] == "Surface elements on solids (1) mark faces, and are no plates.");
      CHECK_THAT(deck.warnings[1], ContainsSubstring("(1) was skipped: line "));
    }
}

TEST_CASE("gmsh: a partitioned mesh in ASCII keeps its groups, and the names of what has none") {
  for (const std::string version : {"4.0", "4.1"}) {
    const std::string point = version == "4.0" ? " 0 0 0" : "";
    const std::string head4 = "$MeshFormat\n" + version + " 0 8\n$EndMeshFormat\n";
    const std::string entities = "$Entities\n1 0 1 1\n1 0 0 0" + point +
                                 " 0\n4 0 0 0 1 1 1 0 0\n3 0 0 0 1 1 1 1 5 0\n$EndEntities\n"
                                 "$PartitionedEntities\n2\n1\n9 2\n1 0 2 1\n1 2 4 2 1 2 0 0 0" +
                                 point +
                                 " 0\n"
                                 "5 2 4 1 1 0 0 0 1 1 1 0 0\n6 3 3 2 1 2 0 0 0 1 1 1 1 8 0\n7 3 3 1 2 0 0 0 1 1 1 2 5 "
                                 "9 1 -5\n$EndPartitionedEntities\n";
    const std::string mesh =
        version == "4.0"
            ? "$Nodes\n1 6\n7 3 0 6\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 3 3 0\n6 4 3 0\n$EndNodes\n$Elements\n3 3\n"
              "5 2 2 1\n1 2 5 6\n6 2 2 1\n2 1 2 3\n7 3 4 1\n3 1 2 3 4\n$EndElements\n"
            : "$Nodes\n1 6 1 6\n3 7 0 6\n1\n2\n3\n4\n5\n6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 3 0\n4 3 0\n$EndNodes\n"
              "$Elements\n3 3 1 3\n2 5 2 1\n1 2 5 6\n2 6 2 1\n2 1 2 3\n3 7 4 1\n3 1 2 3 4\n$EndElements\n";
    const std::string unread = "$Periodic\n1\n1 2 1\n0\n$EndPeriodic\n$GhostElements\n0\n$EndGhostElements\n";
    INFO(version);
    const Deck deck = read(head4 + entities + mesh + unread);
    CHECK(deck.part(5).tetrahedra.size() == 1);  // of the whole, and its own: once
    CHECK(deck.part(9).tetrahedra.size() == 1);
    CHECK(deck.part("surface 4").triangles == Cells<3>{{1, 4, 5}});  // a piece of surface 4
    CHECK(deck.nodes(8).size() == 3);  // between two pieces of a volume, which is no surface
    REQUIRE(deck.warnings.size() == 3);
    CHECK_THAT(deck.warnings[1], ContainsSubstring("$Periodic (1) was skipped: line "));
    CHECK_THAT(deck.warnings[2], ContainsSubstring("$GhostElements (1) was skipped: line "));
  }
}

TEST_CASE("gmsh: a binary file that does not hold what it says is refused") {
  const auto refused = [](const std::string& text, const std::string& sentence) {
    CHECK_THROWS_WITH(read(text), ContainsSubstring(sentence));
  };
  const std::string bad = "$MeshFormat\n4.1 1 8\n";
  refused(bad, "the file ends where the 1 of the byte order should stand");
  refused(bad + std::string("\1\1\0\0", 4), "the 1 of the byte order is no 1");
  refused("$MeshFormat\n4.1 1 16\n", "the size of numbers 16 is not 8");
  refused("$MeshFormat\n2.2 1 4\n", "the size of numbers 4 is not 8");
  refused("$MeshFormat\n4.0 1 8\n", "version 4.0 is read in ASCII alone");
  refused("$MeshFormat\n4.1 1 8 8\n", "'8' stands before the bytes of the section");
  refused(binary22(false, 3), "a block announces 3 elements, and the section has 2 left");
  refused(binary22(false, 1), "a block announces 5 elements, and the section has 1 left");
  refused(binary22(true, 2, std::nan("")), "the coordinate is not finite");
  refused(binary41(false, 4), "the section announces 5 nodes and has 4");
  refused(binary41(false, 4000000000U), "out of bounds");
  for (const bool swaps : {false, true})
    for (const std::string& text : {binary22(swaps), binary41(swaps)})
      for (std::size_t length = 0; length < text.rfind("$EndElements") + 12; ++length)
        CHECK_THROWS_AS(read(text.substr(0, length)), Error);
}

TEST_CASE("gmsh: what is wrong is told with its line") {
  const auto refused = [](const std::string& text, const std::string& sentence) {
    CHECK_THROWS_WITH(read(text), ContainsSubstring("strike: the file 'a.msh', line ") && ContainsSubstring(sentence));
  };
  refused("", "the file is empty");
  refused("solid ascii\n", "line 1: 'solid ascii' stands in no section");
  refused("$Nodes\n", "line 1: the file does not begin with $MeshFormat");
  refused("$MeshFormat\n4.1 2 8\n", "line 2: the file type 2 is neither 0, ASCII, nor 1, binary");
  refused("$MeshFormat\n3 0 8\n", "line 2: version '3' is not read: save as 2.2 or 4.1 (gmsh -format msh41).");
  refused(head + "$Nodes\n1\n1 0 0 " + '\0', "line 6: a byte is 0, as in binary files and UTF-16");
  refused(head + "$Nodes\n1\n1 0 0.x 0\n", "line 6: the coordinate '0.x' is no number: write it as 1.5 or 1.5e-3.");
  refused(head + "$Nodes\n99999999999\n1 0 0 0\n$EndNodes\n",
          "line 7: the number of a node '$EndNodes' is no whole number");
  refused(head + "$Nodes\n2\n1 0 0 0\n1 0 0 1\n$EndNodes\n$Elements\n0\n$EndElements\n",
          "line 7: node 1 is on line 6 already");
  refused(head + "$Nodes\n1\n0 0 0 0\n$EndNodes\n", "the number of a node 0 is out of bounds");
  refused(head + "$Nodes\n1\n1 0 0", "the file ends where the coordinate should stand");
  refused(head + "$Nodes\n0\n", "the section $Nodes has no end");
  const std::string nodes = head + "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n$Elements\n1\n";
  refused(nodes + "1 4 2 1 1 1 2 3 4\n2 4 2 1 1 1 2 3 4\n$EndElements\n",
          "line 14: section $Elements holds '2 4 2 1 1 1 2 3 4' after as much as its counts say");
  refused(head + "$Nodes\n-1\n$EndNodes\n", "line 5: the count of nodes -1 is negative");
  refused(head + "$Nodes\n1\n1 0 0 0 0\n$EndNodes\n", "line 6: section $Nodes holds '0' after");
  refused(head + "$Elements\n-3\n$EndElements\n", "line 5: the count of elements -3 is negative");
  refused(nodes + "1 4 -1 1 2 3 4\n$EndElements\n", "line 13: the count of tags -1 is negative");
  refused(head + "$PhysicalNames\n1\n2 1 foot\n$EndPhysicalNames\n", "line 6: group 1 has no name between quotes");
  refused(head + "$Nodes\n0\n$EndNodes\n", "the file has no section $Elements");
  refused(head + head, "line 5: the format is there twice");
  const std::string head4 = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
  refused(head4 + "$Nodes\n1 2 1 2\n3 1 0 1\n1\n0 0 0\n$EndNodes\n",
          "line 8: the section announces 2 nodes and has 1: save the file from gmsh again.");
  refused(head4 + "$Elements\n0 1 1 1\n$EndElements\n", "line 5: the section announces 1 elements and has 0");
  refused(head4 + "$Entities\n0 0 0 1\n1 0 0 0 0 0 0 -2 0\n$EndEntities\n",
          "line 6: the count of groups -2 is negative");
  refused(nodes + "1 4 2 1 1 1 2 3 5\n$EndElements\n", "line 13: element 1 names node 5, which is not in the file");
  refused(nodes + "1 4 2 1 1 1 2 3 3\n$EndElements\n", "element 1 has 3 different corners of 4");
  refused(nodes + "1 6 2 1 1 1 2 3 4 4 4\n$EndElements\n", "line 13: element 1 has 4 different corners of 6");
  refused(nodes + "1 21 2 1 1 1 2 3 4\n$EndElements\n", "element 1 is of type 21, which is not read: mesh in order 1");
  refused(head +
              "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n$EndNodes\n$Elements\n2\n1 4 0 1 2 3 4\n1 4 0 1 2 3 4\n"
              "$EndElements\n",
          "line 14: element 1 is on line 13 already");
}
