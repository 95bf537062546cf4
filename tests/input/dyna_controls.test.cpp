#include <string>

#include <strike/input/dyna.hpp>

#include "input/dyna_text.hpp"
#include "support/catch.hpp"

using namespace strike;
using decks::read;

namespace {

/// A brick and a shell that have the same number, and another shell.
const std::string mesh = R"(*NODE
11,0,0,5
12,1,0,5
13,1,1,5
14,0,1,5
15,0,0,6
16,1,0,6
17,1,1,6
18,0,1,6
21,0,0,0
22,1,0,0
23,1,1,0
24,0,1,0
25,2,0,0
*ELEMENT_SHELL
1,1,21,22,23,24
2,2,22,25,23
*ELEMENT_SOLID
1,3,11,12,13,14,15,16,17,18
)";

}  // namespace

TEST_CASE("dyna controls: values, and what is not honoured") {
  const DynaDeck deck = read(mesh + R"(*PART
canopy
1,2
*SECTION_SHELL
2,0
1.5
*CONTROL_SHELL
$#  wrpang     esort     irnxx    istupd    theory       bwc     miter      proj
      15.0         1        -1         4        16         1         1         1
$# rotascl    intgrd    lamsht    cstyp6    thshel
       1.0         1         0         1         0
*CONTROL_HOURGLASS
         5      0.03
*CONTROL_BULK_VISCOSITY
       1.4       .07        -2
*CONTROL_TERMINATION
      20.0         0       0.0       0.0     1.0e8
*CONTROL_TIMESTEP
       0.0       0.8         0       0.0   -1.0e-3
*CONTROL_CONTACT
       0.2       0.0         2         1         1         0         1         1
         0         0        10         0       4.0
       0.0       0.0       0.0       0.0       0.0       0.0      10.0
         1         0         0         0
*CONTROL_ENERGY
         2         2         2         2
*CONTROL_ACCURACY
         1         2
*CONTROL_OUTPUT
         1
)");
  CHECK(deck.shell_control.warping_angle == 15);
  CHECK(deck.shell_control.thickness_update == 4);
  CHECK(deck.shell_control.warping == 1);
  CHECK(deck.shell_control.projects);
  CHECK(deck.section("canopy").element_form == 16);  // of a section that has none
  CHECK(deck.hourglass("canopy").number == 0);
  CHECK(deck.hourglass("canopy").type == 5);
  CHECK(deck.hourglass("canopy").coefficient == 0.03);
  CHECK(deck.hourglass("canopy").warping == 0.03);
  CHECK(deck.hourglass("canopy").quadratic == 1.4);
  CHECK(deck.hourglass("canopy").linear == 0.07);
  CHECK(deck.end_time == 20);
  CHECK(deck.step_factor == 0.8);
  CHECK(deck.mass_scaled_step == -1e-3);
  CHECK(deck.contact_stiffness == 0.2);
  CHECK(deck.warnings == std::vector<std::string>{
                             "*CONTROL_OUTPUT (1 card) was skipped: line 48.",
                             "ESORT of *CONTROL_SHELL (1) had no effect: line 28.",
                             "INTGRD of *CONTROL_SHELL (1) had no effect: line 30.",
                             "TYPE of *CONTROL_BULK_VISCOSITY (1) had no effect: line 34.",
                             "DT2MS (give it to MassScaled) of *CONTROL_TIMESTEP (1) had no effect: line 38.",
                             "SHLTHK of *CONTROL_CONTACT (1) had no effect: line 40.",
                             "ENMASS of *CONTROL_CONTACT (1) had no effect: line 40.",
                             "PEN_SF of *CONTROL_CONTACT (1) had no effect: line 42.",
                             "OSU of *CONTROL_ACCURACY (1) had no effect: line 47.",
                             "INN of *CONTROL_ACCURACY (1) had no effect: line 47.",
                         });
}

TEST_CASE("dyna controls: zeros, blanks and no cards are the defaults") {
  for (const std::string cards : {"*CONTROL_SHELL\n0,0,0,0,0,0,0,0\n*CONTROL_CONTACT\n0,0,0\n*CONTROL_TERMINATION\n0\n",
                                  "*CONTROL_SHELL\n\n*CONTROL_CONTACT\n*CONTROL_ACCURACY\n\n", ""}) {
    const DynaDeck deck = read(mesh + "*SECTION_SHELL\n1\n1.5\n*SECTION_SOLID\n2\n" + cards);
    CHECK(deck.shell_control.warping_angle == 20);
    CHECK(deck.shell_control.element_form == 2);
    CHECK(deck.shell_control.warping == 2);
    CHECK(deck.shell_control.thickness_update == 0);
    CHECK(deck.contact_stiffness == 0.1);
    CHECK(deck.sections[0].element_form == 2);
    CHECK(deck.sections[1].element_form == 1);
    CHECK(!deck.hourglass_control);
    CHECK(deck.mass_scaled_step == 0);
    CHECK(deck.interval("D3PLOT") == 0);
    CHECK(deck.warnings.empty());
  }
  const DynaDeck deck = read(mesh + "*CONTROL_HOURGLASS\n0,0\n*PART\na\n1,0,0,0,7\n*HOURGLASS\n7,4,.2\n*PART\nb\n2\n");
  CHECK(deck.hourglass("a").type == 4);  // a part's own comes first
  CHECK(deck.hourglass("b").type == 1);
  CHECK(deck.hourglass("b").coefficient == 0.1);
}

TEST_CASE("dyna controls: intervals of outputs") {
  const DynaDeck deck = read(mesh + R"(*DATABASE_BINARY_D3PLOT
       0.5
*DATABASE_BINARY_D3THDT
.25
*DATABASE_GLSTAT
.01,1,0,2
*DATABASE_MATSUM
0
*DATABASE_RCFORC
.02,0,7
*DATABASE_RCFORC
.03
*DATABASE_BINARY_D3DUMP
5000
)");
  CHECK(deck.interval("D3PLOT") == 0.5);
  CHECK(deck.interval("D3THDT") == 0.25);
  CHECK(deck.interval("GLSTAT") == 0.01);
  CHECK(deck.interval("MATSUM") == 0);
  CHECK(deck.interval("RCFORC") == 0.03);
  CHECK(deck.interval("D3DUMP") == 0);  // which counts steps
  CHECK(deck.outputs.size() == 4);
  CHECK(deck.warnings == std::vector<std::string>{
                             "*DATABASE_BINARY_D3DUMP (1 card) was skipped: line 32.",
                             "Further fields of *DATABASE_GLSTAT (1) had no effect: line 25.",
                             "LCUR of *DATABASE_RCFORC (1) had no effect: line 29.",
                         });
  CHECK(read("*DATABASE_BINARY_D3PLOT\n9.,0,0,40\n*CONTROL_TERMINATION\n20.\n" + mesh).interval("D3PLOT") == 0.5);
}

TEST_CASE("dyna controls: histories count solids and shells apart, and name a node once") {
  const DynaDeck deck = read(R"(*DATABASE_HISTORY_NODE
        11        21        11         0        22
*DATABASE_HISTORY_NODE_ID
        23the tip of the canopy
        24        25
*DATABASE_HISTORY_NODE_SET
4
*DATABASE_HISTORY_SOLID
1
*DATABASE_HISTORY_SHELL_ID
         2the other
*DATABASE_HISTORY_SHELL_SET
8
*SET_NODE_LIST
4
18,11
*SET_SHELL
8
2,1
)" + mesh);
  CHECK(deck.history_nodes == std::vector<Index>{0, 7, 8, 9, 10, 11});
  CHECK(deck.history_cells == std::vector<Index>{0, 1, 2});
  CHECK(read("*DATABASE_HISTORY_SHELL\n1\n" + mesh).history_cells == std::vector<Index>{1});
  CHECK(read("*DATABASE_HISTORY_SOLID_SET\n6\n*SET_SOLID\n6\n1\n" + mesh).history_cells == std::vector<Index>{0});
}

TEST_CASE("dyna controls: what is wrong is told with its line") {
  const auto refused = [](const std::string& text, const std::string& sentence) {
    decks::expect_refused(mesh + text, sentence);
  };
  refused("*CONTROL_IMPLICIT_GENERAL\n1\n",
          "*CONTROL_IMPLICIT_GENERAL makes the run implicit, and this one is explicit: take it out.");
  refused("*CASE\n", "*CASE makes several runs of one deck");
  refused("*DATABASE_GLSTAT\n-1\n", "DT of *DATABASE_GLSTAT is negative: give the interval of the output.");
  refused("*DATABASE_HISTORY_NODE\n77\n", "line 21: node 77 is not in the file");
  refused("*DATABASE_HISTORY_NODE_SET\n77\n", "line 21: the set of nodes 77 is not in the file");
  refused("*DATABASE_HISTORY_SOLID\n2\n", "line 21: solid 2 is not in the file");
  refused("*DATABASE_HISTORY_SHELL\n3\n", "line 21: shell 3 is not in the file");
  refused("*DATABASE_HISTORY_SOLID_SET\n3\n", "line 21: the set of solids 3 is not in the file");
}
