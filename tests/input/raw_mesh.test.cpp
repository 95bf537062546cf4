#include <string>

#include <strike/input.hpp>

#include "support/catch.hpp"
#include "support/sanitized.hpp"
#include <sys/resource.h>

using namespace strike;
using Catch::Matchers::ContainsSubstring;

// A deck of some 100 kB whose sets, groups and cards name each node a thousand times and more. Its text is linear in n,
// and so are memory and time: what repeats counts once, the rest ends in a sentence.
namespace {

constexpr int n = 4000;
constexpr std::size_t most_bytes = 64 << 20;

template <class Line>
std::string lines(int count, Line line) {
  std::string text;
  for (int i = 1; i <= count; ++i) text += line(std::to_string(i), i);
  return text;
}
std::string repeated(const std::string& text) {
  return lines(n, [&](const std::string&, int) { return text; });
}
/// Nodes 1 to n, and a shell of every four of them.
std::string abaqus_strip() {
  return "*NODE\n" + lines(n, [](const std::string& i, int) { return i + "\n"; }) + "*ELEMENT, TYPE=S4\n" +
         lines(n - 3, [](const std::string& i, int k) {
           return i + "," + i + "," + std::to_string(k + 1) + "," + std::to_string(k + 2) + "," +
                  std::to_string(k + 3) + "\n";
         });
}
std::string dyna_strip() {
  return "*NODE\n" + lines(n, [](const std::string& i, int) { return i + "\n"; }) + "*ELEMENT_SHELL\n" +
         lines(n - 3, [](const std::string& i, int k) {
           return i + "," + i + "," + i + "," + std::to_string(k + 1) + "," + std::to_string(k + 2) + "," +
                  std::to_string(k + 3) + "\n";
         });
}
std::string gmsh_square(const std::string& entities, const std::string& blocks, int count) {
  return "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n" + entities +
         "$EndEntities\n$Nodes\n1 4 1 4\n2 1 0 4\n1\n2\n3\n4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n$EndNodes\n$Elements\n" +
         std::to_string(count) + " " + std::to_string(n) + " 1 1\n" + blocks + "$EndElements\n";
}

std::size_t peak() {
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}
template <class Read>
void expect_little_memory(const Read& read, std::size_t most = most_bytes) {
  const std::size_t before = peak();
  read();
  if (!testing::is_sanitized()) CHECK(peak() - before < most);
}
const auto too_much = ContainsSubstring("name nodes and elements more often than a file of ");

void refuse_abaqus(const std::string& text) {
  expect_little_memory([&] { CHECK_THROWS_WITH(read_abaqus(abaqus_strip() + text, "a.inp"), too_much); });
}
void refuse_dyna(const std::string& text) {
  expect_little_memory([&] { CHECK_THROWS_WITH(read_dyna(dyna_strip() + text, "a.k"), too_much); });
}
Deck read_abaqus_briefly(const std::string& text) {
  Deck deck;
  expect_little_memory([&] { deck = read_abaqus(abaqus_strip() + text, "a.inp"); });
  return deck;
}
DynaDeck read_dyna_briefly(const std::string& text) {
  DynaDeck deck;
  expect_little_memory([&] { deck = read_dyna(dyna_strip() + text, "a.k"); });
  return deck;
}

const std::string whole = "1," + std::to_string(n) + "\n";

}  // namespace

TEST_CASE("raw mesh: ranges and sets that repeat others count once") {
  CHECK(read_abaqus_briefly("*NSET, NSET=s, GENERATE\n" + repeated(whole)).nodes("s").size() == n);
  CHECK(read_abaqus_briefly("*NSET, NSET=s, GENERATE\n" +
                            lines(n, [](const std::string& i, int) { return i + "," + std::to_string(n) + "\n"; }))
            .nodes("s")
            .size() == n);
  CHECK(read_abaqus_briefly("*NSET, NSET=s, GENERATE\n" +
                            lines(n, [](const std::string& i, int) { return "1,1000000000," + i + "\n"; }))
            .nodes("s")
            .size() == n);
  CHECK(read_abaqus_briefly("*NSET, NSET=s, GENERATE\n" + whole + "*NSET, NSET=t\n" + repeated("s,s,s,s\n"))
            .nodes("t")
            .size() == n);
  CHECK(read_dyna_briefly("*SET_NODE_LIST_GENERATE\n1\n" + repeated(whole)).nodes(1).size() == n);
  CHECK(read_dyna_briefly("*SET_NODE_GENERAL\n1\n" + repeated("ALL\n")).nodes(1).size() == n);
  CHECK(read_dyna_briefly("*SET_PART_LIST\n1\n" + repeated("1,1,1,1\n") + "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n1,0,2\n")
            .contacts[0]
            .slave.parts.size() == 1);
}

TEST_CASE("raw mesh: ranges over wide gaps of numbers take the time of the nodes that are there") {
  const Deck deck = read_abaqus(
      "*NODE\n1\n500000000000\n700000000000\n900000000000\n*ELEMENT, TYPE=S4\n1, 1,500000000000,"
      "700000000000, 900000000000\n*NSET, NSET=s, GENERATE\n" +
          repeated("1,900000000000,1\n") + "*NSET, NSET=t, GENERATE\n1,900000000000,3\n",
      "a.inp");
  CHECK(deck.nodes("s").size() == 4);
  CHECK(deck.nodes("t") == std::vector<Index>{0, 2});  // 1 + 3k
}

TEST_CASE("raw mesh: sets that are long again and again end in a sentence") {
  refuse_abaqus(lines(n, [](const std::string& i, int) { return "*NSET, NSET=s" + i + ", GENERATE\n" + whole; }));
  refuse_abaqus("*NSET, NSET=s0, GENERATE\n" + whole + lines(n, [](const std::string& i, int k) {
                  return "*NSET, NSET=s" + i + "\ns" + std::to_string(k - 1) + "\n";
                }));
  refuse_abaqus("*NSET, NSET=a, GENERATE\n" + whole + repeated("*NSET, NSET=b\na\n*NSET, NSET=a\nb\n"));
  refuse_dyna(lines(n, [](const std::string& i, int) { return "*SET_NODE_LIST_GENERATE\n" + i + "\n" + whole; }));
  refuse_dyna("*SET_NODE_LIST_GENERATE\n1\n" + whole + lines(n, [](const std::string& i, int k) {
                return "*SET_NODE_ADD\n" + std::to_string(k + 1) + "\n" + i + "\n";
              }));
}

TEST_CASE("raw mesh: cards that name large sets again and again end in a sentence") {
  const std::string set = "*SET_NODE_LIST_GENERATE\n1\n" + whole, parts = "*SET_PART_LIST_GENERATE\n1\n" + whole;
  refuse_dyna(set + "*BOUNDARY_SPC_SET\n" + repeated("1,0,1\n"));
  refuse_dyna(repeated("*RIGIDWALL_PLANAR\n0\n0,0,0,0,0,1\n"));
  refuse_dyna(parts + "*INITIAL_VELOCITY_GENERATION\n" + repeated("1,1,0,1\n0,0\n"));
  refuse_dyna(parts + repeated("*CONTACT_AUTOMATIC_SINGLE_SURFACE\n1,0,2\n\n\n"));
}

TEST_CASE("raw mesh: instances of large parts without end end in a sentence") {
  const auto read = [] {
    CHECK_THROWS_WITH(
        read_abaqus("*PART, NAME=p\n*NODE\n" + lines(n / 2, [](const std::string& i, int) { return i + "\n"; }) +
                        "*END PART\n" +
                        lines(n / 2, [](const std::string& i,
                                        int) { return "*INSTANCE,NAME=i" + i + ",PART=p\n*ENDINSTANCE\n"; }),
                    "a.inp"),
        too_much);
  };
  expect_little_memory(read, 4 * most_bytes);
}

TEST_CASE("raw mesh: many elements in many groups end in a sentence, long names of groups do not") {
  const auto elements = [](const std::string& entity, int count, const std::string& first) {
    return "2 " + entity + " 3 " + std::to_string(count) + "\n" + first;
  };
  expect_little_memory([&] {
    const std::string groups = lines(n, [](const std::string& i, int) { return i + " "; });
    CHECK_THROWS_WITH(
        read_gmsh(
            gmsh_square("0 0 1 0\n1 0 0 0 0 0 0 " + std::to_string(n) + " " + groups + "0\n",
                        elements("1", n, lines(n, [](const std::string& i, int) { return i + " 1 2 3 4\n"; })), 1),
            "a.msh"),
        too_much);
  });
  expect_little_memory([&] {
    const std::string entities = lines(n, [](const std::string& i, int) { return i + " 0 0 0 0 0 0 1 1 0\n"; });
    const std::string square =
        gmsh_square("0 0 " + std::to_string(n) + " 0\n" + entities,
                    lines(n, [&](const std::string& i, int) { return elements(i, 1, i + " 1 2 3 4\n"); }), n);
    const std::string name(100'000, 'x'), names = "$PhysicalNames\n1\n2 1 \"" + name + "\"\n$EndPhysicalNames\n";
    const std::size_t at = square.find("$Entities");
    const Deck deck = read_gmsh(square.substr(0, at) + names + square.substr(at), "a.msh");
    CHECK(deck.part(name).quadrilaterals.size() == n);
  });
}

TEST_CASE("raw mesh: long lines take the time of their length") {
  const std::string blanks(200'000, ' ');
  const DynaDeck deck =
      read_dyna("*MAT_ELASTIC\n1,1,1,.1," + lines(100'000, [](const std::string&, int) { return "0,"; }) + blanks +
                    "\n*MAT_ELASTIC\n         2         1         1        .1" + blanks + "x\n",
                "a.k");
  CHECK(deck.warnings == std::vector<std::string>{"Further fields of *MAT_ELASTIC (1) had no effect: line 4."});
}
