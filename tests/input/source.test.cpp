#include <filesystem>
#include <fstream>

#include <strike/input.hpp>

#include "output/scratch.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"

using namespace strike;
using Catch::Matchers::ContainsSubstring;

namespace {

const std::string shell_inp = "*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,0\n4,0,1,0\n*ELEMENT,TYPE=S4\n1,1,2,3,4\n";
const std::string shell_k = "*KEYWORD\n*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,0\n4,0,1,0\n*ELEMENT_SHELL\n1,1,1,2,3,4\n";
const std::string shell_msh =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n$EndNodes\n"
    "$Elements\n1\n1 3 2 1 1 1 2 3 4\n$EndElements\n";

/// The mesh of a text in the format that it is in.
Deck read(const std::string& text) {
  if (text.find("$Mesh") != text.npos) return read_gmsh(text, "a");
  if (text.find("*KEYWORD") != text.npos) return read_dyna(text, "a");
  return read_abaqus(text, "a");
}

std::string with_line_ends(const std::string& text, const std::string& end) {
  std::string result;
  for (const char c : text)
    if (c == '\n')
      result += end;
    else
      result += c;
  return result;
}

}  // namespace

TEST_CASE("source: a byte-order mark and line ends of every system change nothing") {
  for (const std::string& text : {shell_inp, shell_k, shell_msh})
    for (const char* end : {"\n", "\r\n", "\r"})
      for (const char* mark : {"", "\xEF\xBB\xBF"}) {
        const Deck deck = read(mark + with_line_ends(text, end));
        CHECK(deck.mesh.nodes.size() == 4);
        CHECK(deck.mesh.quadrilaterals == Cells<4>{{0, 1, 2, 3}});
        CHECK(deck.warnings.empty());
      }
}

TEST_CASE("source: a number reads the same in any spelling") {
  const auto written = [](const std::string& text, const std::string& second, const std::string& one) {
    const bool is_msh = text.find("$Mesh") != text.npos;
    const std::string mark = is_msh ? " " : ",", old = "\n2" + mark + "1" + mark;
    return std::string(text).replace(text.find(old), old.size(), "\n" + second + mark + one + mark);
  };
  for (const std::string& text : {shell_inp, shell_k, shell_msh}) {
    const Deck plain = read(text);
    for (const std::string second : {"2", " 2", "\t2", "2 ", "  2  ", "+2"})
      for (const std::string one :
           {"1", " 1", "\t1", "1 ", "1\t", "+1", "1.", "1.0e0", "1E+0", "1D0", ".1d1", "10-1"}) {
        CAPTURE(text, second, one);
        const Deck deck = read(written(text, second, one));
        CHECK(deck.mesh.nodes == plain.mesh.nodes);
        CHECK(deck.node_numbers == plain.node_numbers);
        CHECK(deck.mesh.quadrilaterals == plain.mesh.quadrilaterals);
      }
    for (const std::string wrong : {"1x", "x", "inf", "nan", "1e400", "0x1", "1e", "-", "1-", "1;0"}) {
      CAPTURE(text, wrong);
      CHECK_THROWS_WITH(read(written(text, "2", wrong)), ContainsSubstring("line ") && ContainsSubstring(wrong));
    }
    for (const std::string wrong : {"2.5", "0", "-2", "2000000000000", "99999999999999999999", "2x"}) {
      CAPTURE(text, wrong);
      CHECK_THROWS_WITH(read(written(text, wrong, "1")), ContainsSubstring(wrong == "0" ? "number from 1" : wrong));
    }
  }
}

TEST_CASE("source: what follows a byte 0 is not lost") {
  for (const std::string& text : {shell_inp, shell_k, shell_msh}) {
    std::string damaged = text;
    damaged.insert(damaged.rfind("*ELEM") != text.npos ? damaged.rfind("*ELEM") : damaged.rfind("$Elem"), 1, '\0');
    const auto line = 1 + std::count(damaged.begin(), damaged.begin() + std::ptrdiff_t(damaged.find('\0')), '\n');
    CHECK_THROWS_WITH(read(damaged), "strike: the file 'a', line " + std::to_string(line) +
                                         ": a byte is 0, as in binary files and UTF-16: save the file as text in "
                                         "ASCII or UTF-8.");
  }
}

TEST_CASE("source: endless, binary and huge files end in a sentence") {
  const ScratchFolder folder("source");
  for (const char* device : {"/dev/zero", "/dev/urandom"})
    if (std::filesystem::exists(device))
      CHECK_THROWS_WITH(read_abaqus(device),
                        std::string("strike: the file '") + device + "' is binary: save it as text.");
  std::ofstream(folder / "huge.inp") << "*NODE\n";
  std::error_code failure;
  std::filesystem::resize_file(folder / "huge.inp", std::uintmax_t(1) << 42, failure);  // a hole
  if (!failure && !testing::is_sanitized())
    CHECK_THROWS_WITH(read_mesh(folder / "huge.inp"), ContainsSubstring("does not fit in memory"));
  CHECK_THROWS_WITH(detail::within_memory("a.inp", []() -> int { throw std::bad_alloc(); }),
                    "strike: the mesh of the file 'a.inp' does not fit in memory: give a smaller one.");
}
