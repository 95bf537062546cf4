#include <filesystem>
#include <fstream>

#include <strike/input/read_mesh.hpp>
#include <strike/mesh/check.hpp>
#include <strike/mesh/cylinder.hpp>
#include <strike/mesh/tetrahedra.hpp>
#include <strike/mesh/transform.hpp>

#include "input/written.hpp"
#include "output/scratch.hpp"
#include "support/catch.hpp"

using namespace strike;
using Catch::Matchers::ContainsSubstring;

TEST_CASE("read mesh: a cylinder comes back from every format to the last bit") {
  const ScratchFolder folder("read-mesh");
  Mesh bar = cylinder({.radius = 3.2, .length = 32.4, .cells = 3, .layers = 10, .sector = Sector::full});
  append(bar, tetrahedralized(cylinder({.radius = 1, .length = 2, .layers = 2})));
  const std::vector<std::pair<std::string, std::string>> files{{"bar.msh", written_gmsh(bar, "a bar")},
                                                               {"bar.inp", written_abaqus(bar, "a bar")},
                                                               {"bar.k", written_dyna(bar, "a bar")},
                                                               {"BAR.KEY", written_dyna(bar, "a bar")}};
  for (const auto& [name, text] : files) {
    INFO(name);
    std::ofstream(folder / name, std::ios::binary) << text;
    const Deck deck = read_mesh(folder / name);
    CHECK(deck.mesh.nodes == bar.nodes);
    CHECK(deck.mesh.hexahedra == bar.hexahedra);
    CHECK(deck.mesh.tetrahedra == bar.tetrahedra);
    CHECK(deck.mesh.quadrilaterals.empty());
    CHECK(deck.part("a bar").hexahedra == bar.hexahedra);
    CHECK(deck.part("a bar").tetrahedra == bar.tetrahedra);
    CHECK(deck.part("a bar").nodes().size() == bar.nodes.size());
    CHECK(deck.node_numbers.front() == 1);
    CHECK(deck.node_numbers.back() == FileNumber(bar.nodes.size()));
    CHECK(deck.cell_numbers.back() == FileNumber(bar.hexahedra.size() + bar.tetrahedra.size()));
    CHECK(deck.warnings.empty());
    CHECK_NOTHROW(check(deck.mesh));
  }
}

TEST_CASE("read mesh: a file that cannot be read is refused in a sentence") {
  const ScratchFolder folder("read-mesh-errors");
  CHECK_THROWS_WITH(read_mesh("bar.stl"),
                    "strike: the file 'bar.stl' has an ending that is not read: give a .msh (gmsh), an .inp "
                    "(Abaqus) or a .k (LS-DYNA).");
  CHECK_THROWS_WITH(read_mesh(folder / "no.msh"), ContainsSubstring("cannot be opened for reading"));
  std::filesystem::create_directory(folder / "folder.inp");
  CHECK_THROWS_WITH(read_mesh(folder / "folder.inp"), ContainsSubstring("cannot be read: give the path of a file."));
}

TEST_CASE("read mesh: what a deck does not have is refused with what it has") {
  Deck deck;
  CHECK_THROWS_WITH(deck.part("bird"), "strike: no part is called 'bird': the deck has none.");
  deck.parts = {{3, "bird", {}}, {4, "", {}}, {4, "plate", {}}};
  CHECK_THROWS_WITH(deck.part("brid"), "strike: no part is called 'brid': give one of 'bird', 4, 'plate'.");
  CHECK_THROWS_WITH(deck.part(7), "strike: no part has the number 7: give one of 'bird', 4, 'plate'.");
  CHECK_THROWS_WITH(deck.part(4),
                    "strike: the name or number names both 4 '' and 4 'plate': give the one that tells them apart.");
  deck.parts.push_back({5, "bird", {}});
  CHECK_THROWS_WITH(deck.part("bird"), ContainsSubstring("names both 3 'bird' and 5 'bird'"));
  CHECK_THROWS_WITH(deck.nodes("foot"), "strike: no set of nodes is called 'foot': the deck has none.");
  CHECK_THROWS_WITH(deck.nodes(1), "strike: no set of nodes has the number 1: the deck has none.");
}

TEST_CASE("read mesh: numbers are written in the ways of C and Fortran") {
  using strike::detail::to_number;
  for (const char* text : {"1500", "1.5e3", "1.5E+3", "1.5D3", "1.5d+03", " 1.5+3 ", "+1500.", "15.0e+02"}) {
    INFO(text);
    CHECK(to_number(text) == 1500.0);
  }
  CHECK(to_number("-2.5-3") == -2.5e-3);
  CHECK(to_number("-.5") == -0.5);
  CHECK(to_number("+1.d-2") == 0.01);
  for (const char* text :
       {"", " ", "x", "1.5x", "1.5e", "1e400", "nan", "inf", "--1", "+-1", "1 2", "1e2e3", "1+2+3", "0x10", "1,5"}) {
    INFO(text);
    CHECK_FALSE(to_number(text));
  }
  CHECK(strike::detail::to_integer(" 12. ") == 12);
  CHECK_FALSE(strike::detail::to_integer("12.5"));
  CHECK_FALSE(strike::detail::to_integer("99999999999999999999"));
}
