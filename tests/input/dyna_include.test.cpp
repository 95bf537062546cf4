#include <filesystem>
#include <fstream>
#include <string>

#include <strike/input/dyna.hpp>

#include "output/scratch.hpp"
#include "support/catch.hpp"

using namespace strike;
using Catch::Matchers::ContainsSubstring;

namespace {

const std::string nodes = "*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,0\n4,0,1,0\n";
const std::string shell = "*ELEMENT_SHELL\n1,1,1,2,3,4\n";

void write(const std::string& path, const std::string& text) {
  std::filesystem::create_directories(std::filesystem::path(path).parent_path());
  std::ofstream(path, std::ios::binary) << text;
}
std::string sentence_of(const std::string& path, const ReadOptions& options = {}) {
  try {
    read_dyna(path, options);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("dyna include: several files, within folders, each ending as it likes, make one deck") {
  const ScratchFolder folder("include");
  write(folder / "mesh/a/nodes.k", "\xEF\xBB\xBF*KEYWORD\r\n" + nodes + "*END\n*NODE\nnonsense\n");
  write(folder / "mesh/a/shell.k", shell + "*INCLUDE\nfurther.k\n*TITLE\na shell");
  write(folder / "mesh/a/further.k", "$ nothing but a title\n*TITLE\nanother\n");
  write(folder / "mesh/part one.k", "*PART\nplate\n1,1,1\n");
  write(folder / "mesh/empty.k", "");
  write(folder / "deck.k",
        "*KEYWORD\n*INCLUDE\n$ two lines, as Windows has them\nmesh\\a\\nod +\nes.k\nmesh/a/shell.k\n"
        "*INCLUDE_PATH_RELATIVE\nmesh\n*INCLUDE\n  part one.k\nempty.k\n*CONTROL_TERMINATION\n3.\n*END\n");
  const DynaDeck deck = read_dyna(folder / "deck.k");
  CHECK(deck.mesh.nodes.size() == 4);
  CHECK(deck.part("plate").quadrilaterals == Cells<4>{{0, 1, 2, 3}});
  CHECK(deck.title == "a shell");
  CHECK(deck.end_time == 3);
  CHECK(deck.warnings.empty());
  CHECK(read_dyna("*INCLUDE\ndeck.k\n", "text", {.folder = folder / ""}).mesh.nodes.size() == 4);
}

TEST_CASE("dyna include: a message names the file and the line that it is about") {
  const ScratchFolder folder("include-lines");
  write(folder / "nodes.k", nodes + "*DAMPING_GLOBAL\n.1\n");
  write(folder / "again.k", "$\n$\n*NODE\n3,1,1,1\n");
  write(folder / "wrong.k", "\n*NODE\n1,x,0,0\n");
  write(folder / "zero.k", std::string("*NODE\n\0", 7));
  write(folder / "twice.k", "*KEYWORD\n*INCLUDE\nnodes.k\nagain.k\n" + shell);
  write(folder / "deck.k", "*KEYWORD\n*INCLUDE\nwrong.k\n");
  write(folder / "bytes.k", "*KEYWORD\n*INCLUDE\nzero.k\n");
  write(folder / "after.k", "*INCLUDE\nnodes.k\n" + shell + "*PART\nplate\nx\n");
  write(folder / "told.k", "*DAMPING_GLOBAL\n.1\n*INCLUDE\nnodes.k\n" + shell + "*DAMPING_GLOBAL\n.1\n");
  CHECK(sentence_of(folder / "twice.k") == "strike: the file '" + folder / "again.k" +
                                               "', line 4: node 3 is on line 4 of '" + folder / "nodes.k" +
                                               "' already: give each node a number of its own.");
  CHECK_THAT(sentence_of(folder / "deck.k"), ContainsSubstring(folder / "wrong.k" + "', line 3: the coordinate 'x'"));
  CHECK_THAT(sentence_of(folder / "bytes.k"), ContainsSubstring(folder / "zero.k" + "' is binary: save it as text."));
  CHECK_THAT(sentence_of(folder / "after.k"),
             ContainsSubstring(folder / "after.k" + "', line 7: the number of a part"));
  CHECK(read_dyna(folder / "told.k").warnings ==
        std::vector{"*DAMPING_GLOBAL (3 cards) was skipped: lines 1, 6 of '" + folder / "nodes.k" + "', 7."});
}

TEST_CASE("dyna include: cycles, depth, number and place are bounded") {
  const ScratchFolder folder("include-bounds");
  write(folder / "deck/mesh.k", nodes + shell);
  write(folder / "deck/outside.k", "*INCLUDE\n../mesh.k\n");
  write(folder / "deck/absolute.k", "*INCLUDE\n" + std::filesystem::absolute(folder / "mesh.k").string() + "\n");
  write(folder / "deck/missing.k", "*KEYWORD\n*INCLUDE\nno.k\n");
  write(folder / "deck/folder.k", "*INCLUDE\nsub\n");
  write(folder / "deck/stamped.k", "*INCLUDE_STAMPED_PART\nmesh.k\n1\n");
  write(folder / "deck/self.k", "*INCLUDE\n./self.k\n");
  write(folder / "deck/two.k", "*INCLUDE\none.k\n");
  write(folder / "deck/one.k", "*INCLUDE\ntwo.k\n");
  write(folder / "mesh.k", nodes + shell);
  std::filesystem::create_directory(folder / "deck/sub");
  std::filesystem::create_symlink("../mesh.k", folder / "deck/link.k");
  write(folder / "deck/linked.k", "*INCLUDE\nlink.k\n");
  const std::string in_deck = "strike: the file '" + folder / "deck/";

  for (const char* name : {"outside.k", "absolute.k", "linked.k"}) {
    INFO(name);
    CHECK_THAT(
        sentence_of(folder / "deck" + ("/" + std::string(name))),
        ContainsSubstring("line 2: the included file '") && ContainsSubstring("mesh.k' is outside of the folder") ||
            ContainsSubstring("link.k' is outside of the folder"));
    CHECK(read_dyna(folder / "deck" + ("/" + std::string(name)), {.anywhere = true}).mesh.nodes.size() == 4);
  }
  CHECK(sentence_of(folder / "deck/missing.k") == in_deck +
                                                      "missing.k', line 3: the included file 'no.k' is not there: "
                                                      "correct its name, or put it into the folder '" +
                                                      folder / "deck'.");
  CHECK_THAT(sentence_of(folder / "deck/folder.k"), ContainsSubstring("line 2: the included file 'sub' is not there"));
  CHECK_THAT(sentence_of(folder / "deck/stamped.k"), ContainsSubstring("line 1: *INCLUDE_STAMPED_PART is not read"));
  CHECK_THAT(sentence_of(folder / "deck/self.k"), ContainsSubstring("line 2: the file './self.k' includes itself"));
  CHECK_THAT(sentence_of(folder / "deck/one.k"),
             ContainsSubstring("two.k', line 2: the file 'one.k' includes itself: take one *INCLUDE out."));
  CHECK_THROWS_WITH(read_dyna("*INCLUDE\n\n*END\n", "a.k"),
                    ContainsSubstring("line 2: *INCLUDE names no file: write its name below"));
  CHECK_THROWS_WITH(read_dyna("*INCLUDE\nmesh.k\n", "a.k"),
                    "strike: the file 'a.k', line 2: the file 'mesh.k' is included by a text in memory: give the "
                    "folder of its files.");

  for (int i = 0; i <= 40; ++i)
    write(folder / "deep/" + std::to_string(i), "*INCLUDE\n" + std::to_string(i + 1) + "\n");
  CHECK_THAT(sentence_of(folder / "deep/0"),
             ContainsSubstring("deep/32', line 2: files are included in files more than 32 deep"));
  for (int i = 0; i <= 20; ++i)  // 2^20 files
    write(folder / "bomb/" + std::to_string(i),
          i < 20 ? "*INCLUDE\n" + std::to_string(i + 1) + "\n" + std::to_string(i + 1) + "\n" : "*TITLE\n");
  CHECK_THAT(sentence_of(folder / "bomb/0"), ContainsSubstring("more than 10000 files are included"));
}

TEST_CASE("dyna include: a transformed file has its own numbers, and its nodes where they belong") {
  const ScratchFolder folder("include-transform");
  write(folder / "mesh.k", "*NODE\n1,0,0,0,1\n2,1,0,0\n3,1,1,0\n4,0,1,0\n" + shell +
                               "*PART\nplate\n1,2,3,4,5\n*SET_NODE\n6\n1,2\n*SET_NODE_ADD\n7\n6\n*SET_PART\n8\n1\n"
                               "*MAT_ELASTIC\n3,1,1\n*SECTION_SHELL\n2\n.1\n*HOURGLASS\n5\n*EOS_GRUNEISEN\n4,1.\n");
  const std::string turn =
      "*DEFINE_TRANSFORMATION\n9\nSCALE,2,,2\nPOINT,1,1,0,0\nPOINT,2,1,0,5\nROTATE,1,2,90\nTRANSL,0,0,10\n";
  write(folder / "held.k", "*INCLUDE_TRANSFORM\nmesh.k\n\n\n\n1\n*DEFINE_TRANSFORMATION\n1\nTRANSL,1,2,3\nSCALE,1,3\n");
  write(folder / "around.k", "*INCLUDE_TRANSFORM\nheld.k\n100,,,,,,9\n,,far\n,,10.\n");

  write(folder / "deck.k",
        nodes + shell + "*INCLUDE_TRANSFORM\nmesh.k\n10,20,30,40,50,60,8\n70,,left,end\n\n9\n" + turn);
  CHECK_THAT(sentence_of(folder / "deck.k"),
             ContainsSubstring("mesh.k', line 2: TC or RC holds a node that its file's"));
  write(folder / "mesh.k", content_of(folder / "mesh.k").replace(13, 2, ""));
  const DynaDeck deck = read_dyna(folder / "deck.k");
  CHECK(deck.node_numbers == std::vector<FileNumber>{1, 2, 3, 4, 11, 12, 13, 14});
  CHECK(deck.cell_numbers == std::vector<FileNumber>{1, 21});
  CHECK(deck.part("left.plate.end").quadrilaterals.size() == 1);
  CHECK(deck.part(31).nodes() == std::vector<Index>{4, 5, 6, 7});
  CHECK(deck.nodes(57) == std::vector<Index>{4, 5});
  CHECK(deck.part_sets[0].number == 58);
  CHECK(deck.material<Elastic>(31).density == 1);
  CHECK(deck.materials[0].number == 43);
  CHECK(deck.equations_of_state[0].number == 44);
  CHECK(deck.section(31).number == 72);
  CHECK(deck.hourglass(31).number == 75);
  // (x, y, z) to (2x, y, 2z), about the axis (1, 0, z) to (1 - y, 2x - 1, 2z), then up; to rounding.
  for (Index n = 0; n < 4; ++n) {
    const Eigen::Vector3d x = deck.mesh.nodes[n];
    CHECK((deck.mesh.nodes[n + 4] - Eigen::Vector3d(1 - x.y(), 2 * x.x() - 1, 2 * x.z() + 10)).norm() < 1e-14);
  }

  write(folder / "mesh.k", nodes + shell + "*PART\nplate\n1\n");
  const DynaDeck scaled = read_dyna(folder / "held.k");
  CHECK(scaled.mesh.nodes[2] == Eigen::Vector3d(2, 9, 3));  // moved, then scaled
  write(folder / "held.k", "*INCLUDE_TRANSFORM\nmesh.k\n1\n,,deep\n");
  const DynaDeck around = read_dyna(folder / "around.k");
  CHECK(around.mesh.nodes[2] == Eigen::Vector3d(10, 10, 0));
  CHECK(around.node_numbers.front() == 102);
  CHECK(around.parts[0].name == "far.deep.plate");
}

TEST_CASE("dyna include: a transformation that cannot be done rightly is refused") {
  const ScratchFolder folder("include-refused");
  write(folder / "mesh.k", nodes + shell);
  const auto refused = [&](const std::string& included, const std::string& cards, const std::string& sentence) {
    write(folder / "part.k", included);
    write(folder / "deck.k", "*INCLUDE\nmesh.k\n*INCLUDE_TRANSFORM\npart.k\n" + cards);
    CHECK_THAT(sentence_of(folder / "deck.k"), ContainsSubstring(sentence));
  };
  const std::string turn = "\n\n\n1\n*DEFINE_TRANSFORMATION\n1\n";
  refused("*MAT_ELASTIC\n1,1,1\n", "\n\n,,1e3\n", "part.k', line 1: *MAT_ELASTIC is not converted by FCTMAS, FCTTIM");
  refused("*RIGIDWALL_PLANAR\n\n0,0,0,0,0,1\n", turn + "TRANSL,1\n", "*RIGIDWALL_PLANAR is not moved by TRANID");
  refused("*NODE\n9,1\n", "\n\n\n7\n", "line 8: transformation 7 is not in the file");
  refused("*NODE\n9,1\n", turn + "SCALE,-1\n", "line 8: transformation 1 mirrors, which turns cells inside out");
  refused("*NODE\n9,1\n", turn + "MIRROR,1\n", "line 11: the option 'MIRROR' of *DEFINE_TRANSFORMATION is not read");
  refused("*NODE\n9,1\n", turn + "ROTATE,0,0,0,1,1,1,30\n", "line 11: the axis of ROTATE has no direction");
  refused("*NODE\n9,1\n", turn + "ROTATE,1,2,30\n", "line 11: point 1 is not defined above");
  refused("*NODE\n9,1e300\n", turn + "SCALE,1e300\n", "part.k', line 2: the node is moved out of all bounds");
  refused("*NODE\n9,1\n", turn + "SCALE,1e300\nSCALE,1e300\n", "line 12: the transformation is not finite");
  refused("*NODE\n9,1\n", "\n\n,,2.\n7\n", "FCTLEN and TRANID together are not read");
  refused("*NODE\n9,1\n", "\n\n-1\n", "a factor of units is not positive");
  refused("*NODE\n9,1\n", "\n\n,,,FtoC\n", "FCTTEM 'FtoC' is not read");
  refused("*NODE\n9,1\n", "-9\n",
          "part.k', line 2: the number of a node 9 with the offset of its file is out of bounds");
  refused("*NODE\n9,1\n", "1e15\n", "IDNOFF 1000000000000000 is out of bounds");
  refused("*NODE\n3,1\n", "", "part.k', line 2: node 3 is on line 4 of");
}
