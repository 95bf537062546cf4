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
        std::vector{"*DAMPING_GLOBAL (3) was skipped: lines 1, 6 of '" + folder / "nodes.k" + "', 7."});
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
