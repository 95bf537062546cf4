#include <cmath>
#include <string>

#include <strike/input/dyna.hpp>
#include <strike/material/fluid.hpp>
#include <strike/material/solid.hpp>

#include "support/catch.hpp"

using namespace strike;
using Catch::Matchers::ContainsSubstring;

namespace {

DynaDeck read(const std::string& text) { return read_dyna(text, "a.k"); }

/// Two shells of parts 1 and 2.
const std::string two = R"(*NODE
1,0,0,0
2,1,0,0
3,1,1,0
4,0,1,0
5,2,0,0
6,2,1,0
*ELEMENT_SHELL
1,1,1,2,3,4
2,2,2,5,6,3
)";

}  // namespace

TEST_CASE("dyna cards: materials and equations of state by the part that names them") {
  const DynaDeck deck = read(two + R"(*PART
glass
1,1,1
metal
2,1,2,7
*PART
water
3,1,3,8
steel
4,1,4,7
sheet
5,1,5
clay
6,1,6,8
*MAT_ELASTIC_TITLE
float glass
         1   2.5e-6       70.      .22
*MAT_PLASTIC_KINEMATIC
         2  8.93e-6      117.      .35        .4        .1       1.0
       40.        5.        .8
*MAT_NULL
         3   1.0e-6   -1.0e-3    1.0e-9
*MAT_JOHNSON_COOK
$       ro         g         e        pr
         4  7.83e-6      77.0     200.0       .29
      .792       .51       .26      .014      1.03     1793.      294.    1.0e-3
   477.0+3    -9.00       3.0       0.0       .05      3.44     -2.12      .002
       .61
*MAT_PIECEWISE_LINEAR_PLASTICITY
5,7.83e-6,200.,.3,.25,2.0,0.2
*MAT_ELASTIC_PLASTIC_HYDRO
6,2e-6,.01,1e-4,.002,0,1.5
*EOS_GRUNEISEN
         7     3940.      1.49        .0        .0      2.02       .47       0.5       1.0
*EOS_LINEAR_POLYNOMIAL
         8        .0      2.25       5.0       6.0        .4        .4        .0
     1.e-4       1.0
)");
  CHECK(deck.materials[0].title == "float glass");
  const Elastic& glass = deck.material<Elastic>("glass");
  CHECK(glass.density == 2.5e-6);
  CHECK(glass.youngs_modulus == 70);
  CHECK(glass.poissons_ratio == 0.22);

  const PlasticMaterial& metal = deck.material<PlasticMaterial>("metal");
  CHECK(metal.eos.density == 8.93e-6);
  CHECK(metal.eos.bulk_modulus == Approx(117 / 0.9));
  CHECK(metal.strength.shear_modulus == Approx(117 / 2.7));
  CHECK(metal.strength.yield_stress == 0.4);
  CHECK(metal.strength.hardening_modulus == Approx(117 * 0.1 / 116.9));
  CHECK(metal.strength.flow_stress(0.0, 40.0) == Approx(0.8));  // D doubles the stress
  CHECK(metal.strength.flow_stress(0.0, 40.0 * 32) == Approx(0.4 * 3));
  CHECK(metal.failure->failure_strain == 0.8);
  CHECK(Solid{metal.eos, metal.strength}.density() == 8.93e-6);

  const NullMaterial& water = deck.material<NullMaterial>(3);
  CHECK(water.viscosity == 1e-9);
  const auto polynomial = deck.eos<PolynomialEos>("water");
  CHECK(polynomial.density == 1e-6);
  CHECK(polynomial.pressure_cutoff == -1e-3);
  CHECK(polynomial.C1 == 2.25);
  CHECK(polynomial.C5 == 0.4);
  CHECK(polynomial.initial_energy == 1e-4);
  CHECK(Fluid{polynomial, Newtonian{water.viscosity}}.viscosity() == 1e-9);

  const JohnsonCookMaterial& steel = deck.material<JohnsonCookMaterial>("steel");
  CHECK(steel.strength.shear_modulus == 77);
  CHECK(steel.strength.A == 0.792);
  CHECK(steel.strength.n == 0.26);
  CHECK(steel.strength.C == 0.014);
  CHECK(steel.strength.reference_rate == 1e-3);
  CHECK(steel.strength.melting_temperature == 1793);
  CHECK(steel.strength.initial_temperature == 294);
  CHECK(steel.strength.heating == Approx(1 / (7.83e-6 * 477e3)));
  CHECK(steel.damage == std::array{0.05, 3.44, -2.12, 0.002, 0.61});
  const auto shock = deck.eos<GruneisenEos>("steel");
  CHECK(shock.density == 7.83e-6);
  CHECK(shock.pressure_cutoff == -9);
  CHECK(shock.sound_speed == 3940);
  CHECK(shock.gamma == 2.02);
  CHECK(shock.a == 0.47);
  CHECK(shock.initial_energy == 0.5);
  CHECK(deck.eos<GruneisenEos>("metal").density == 8.93e-6);
  CHECK(deck.eos<GruneisenEos>("metal").pressure_cutoff == std::numeric_limits<double>::lowest());

  CHECK(deck.material<PlasticMaterial>("sheet").strength.rate_factor == 0);
  CHECK(deck.material<PlasticMaterial>("sheet").failure->failure_strain == 0.2);
  CHECK(deck.material<HydroMaterial>("clay").strength.hardening_modulus == 0.002);
  CHECK(deck.eos<PolynomialEos>("clay").density == 2e-6);
  CHECK(deck.warnings == std::vector<std::string>{
                             "VP 0 (the rate is that of the plastic strain, as of VP 1) of *MAT_PLASTIC_KINEMATIC (1) "
                             "had no effect: line 30.",
                             "VP 0 (the rate is that of the plastic strain, as of VP 1) of *MAT_JOHNSON_COOK (1) "
                             "had no effect: line 38.",
                             "SPALL of *MAT_JOHNSON_COOK (1) had no effect: line 38.",
                         });

  CHECK_THROWS_WITH(deck.material<Elastic>("steel"),
                    "strike: the material 4 of part 'steel' is *MAT_JOHNSON_COOK: read it as JohnsonCookMaterial.");
  CHECK_THROWS_WITH(deck.eos<PolynomialEos>(4),
                    "strike: the equation of state 7 of part 4 is *EOS_GRUNEISEN: read it as GruneisenEos.");
  CHECK_THROWS_WITH(deck.eos<PolynomialEos>("glass"),
                    "strike: part 'glass' names the equation of state 0, which is not in the deck or was skipped: "
                    "read its warnings.");
  CHECK_THROWS_WITH(deck.section("glass"), ContainsSubstring("names the section 1, which is not in the deck"));
  CHECK_THROWS_WITH(deck.hourglass("wood"),
                    ContainsSubstring("strike: no *PART is called 'wood': give one of 'glass', 'metal'"));
  CHECK_THROWS_WITH(deck.hourglass(9), ContainsSubstring("strike: no *PART has the number 9"));
}

TEST_CASE("dyna cards: sections, hourglass control and control cards") {
  const DynaDeck deck = read(two + R"(*PART
plate
1,2,0,0,3
brick
2,1
*SECTION_SOLID_TITLE
solid
         1         2
*SECTION_SHELL
         2         2   0.83333       5.0         1         0
       3.0       3.0       3.0       3.0       1.0
*HOURGLASS
         3         5       .05         0       1.2       .08       .03
*CONTROL_TERMINATION
      20.0
*CONTROL_TIMESTEP
       0.0       0.8
*CONTROL_BULK_VISCOSITY
       1.4       .07
)");
  CHECK(deck.section("brick").element_form == 2);
  CHECK(deck.section("plate").thickness == 3);
  CHECK(deck.section("plate").points == 5);
  CHECK(deck.section("plate").shear_factor == 0.83333);
  CHECK(deck.section("plate").reference == 1);
  CHECK(deck.hourglass("plate").type == 5);
  CHECK(deck.hourglass("plate").coefficient == 0.05);
  CHECK(deck.hourglass("plate").quadratic == 1.2);
  CHECK(deck.hourglass("plate").linear == 0.08);
  CHECK(deck.hourglass("plate").bending == 0.03);
  CHECK(deck.hourglass("plate").warping == 0.05);
  CHECK(deck.end_time == 20);
  CHECK(deck.step_factor == 0.8);
  CHECK(deck.bulk_viscosity == std::array{1.4, 0.07});
  CHECK(deck.warnings.empty());
}

TEST_CASE("dyna cards: supports, velocities, walls and contacts name nodes and parts of the mesh") {
  const DynaDeck deck = read(two + R"(*SET_NODE_LIST
1
1,4
*SET_PART_LIST
5
2
*BOUNDARY_SPC_SET_ID
         9a support
         1         0         1         0         1         0         1         0
*BOUNDARY_SPC_NODE
         2         0         0         1
         5         0         0         1
*INITIAL_VELOCITY_GENERATION
         5         1       2.0       0.0       0.0     -10.0
       1.0       0.0       0.0       0.0       0.0       3.0
*INITIAL_VELOCITY
1
5,6,7
*INITIAL_VELOCITY_NODE
1,1,0,0
2,1,0,0
3,2,0,0
*RIGIDWALL_PLANAR_ID
         1floor
         0         0         0
       0.0       0.0      -1.0       0.0       0.0       1.0        .3
*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_ID
         1bird on plate
         1         5         3         2
       0.3       0.2       0.1
       1.0       1.0
*CONTACT_AUTOMATIC_NODES_TO_SURFACE
         1         2         4         3
)");
  REQUIRE(deck.supports.size() == 2);
  CHECK(deck.supports[0].nodes == std::vector<Index>{1, 4});
  CHECK(deck.supports[0].directions() == std::vector<Eigen::Vector3d>{{0, 1, 0}});
  CHECK(deck.supports[0].axes().empty());
  CHECK(deck.supports[1].nodes == std::vector<Index>{0, 3});
  CHECK(deck.supports[1].directions() == std::vector<Eigen::Vector3d>{{1, 0, 0}, {0, 0, 1}});
  CHECK(deck.supports[1].axes() == std::vector<Eigen::Vector3d>{{0, 1, 0}});

  REQUIRE(deck.velocities.size() == 4);
  CHECK(deck.velocities[0].nodes == std::vector<Index>{1, 2, 4, 5});
  CHECK(deck.velocities[0].velocity == Eigen::Vector3d(0, 0, -10));
  CHECK(deck.velocities[0].at({2, 0, 0}) == Eigen::Vector3d(0, 2, -10));
  CHECK(deck.velocities[1].velocity == Eigen::Vector3d(5, 6, 7));
  CHECK(deck.velocities[1].nodes == std::vector<Index>{0, 3});
  CHECK(deck.velocities[2].nodes == std::vector<Index>{0, 1});
  CHECK(deck.velocities[3].nodes == std::vector<Index>{2});

  REQUIRE(deck.walls.size() == 1);
  CHECK(deck.walls[0].point == Eigen::Vector3d(0, 0, -1));
  CHECK(deck.walls[0].normal == Eigen::Vector3d(0, 0, 1));
  CHECK(deck.walls[0].nodes.size() == 6);
  CHECK(deck.walls[0].friction == 0.3);

  REQUIRE(deck.contacts.size() == 2);
  CHECK(deck.contacts[0].kind == "SURFACE_TO_SURFACE");
  CHECK(deck.contacts[0].slave.parts == std::vector<FileNumber>{1});
  CHECK(deck.contacts[0].master.parts == std::vector<FileNumber>{2});
  CHECK(deck.contacts[0].static_friction == 0.3);
  CHECK(deck.contacts[0].dynamic_friction == 0.2);
  CHECK(deck.contacts[0].decay == 0.1);
  CHECK(deck.contacts[1].slave.nodes == std::vector<Index>{0, 3});
  CHECK(deck.contacts[1].master.parts == std::vector<FileNumber>{2});
  CHECK(deck.warnings.empty());
}

TEST_CASE("dyna cards: a side of a contact may be a set of segments") {
  const DynaDeck deck = read(two + "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n3,1,0,3\n*SET_SEGMENT\n3\n1,2,3,4\n3,2,5\n");
  CHECK(deck.contacts[0].slave.segments == Cells<4>{{0, 1, 2, 3}, {2, 1, 4, 4}});
  CHECK(deck.contacts[0].slave.parts.empty());
  CHECK(deck.contacts[0].master.parts == std::vector<FileNumber>{1});
}

TEST_CASE("dyna cards: a zero or a blank is the default of LS-DYNA") {
  const std::string zero = "0", blank = "";
  for (const std::string& none : {zero, blank}) {
    const std::string two_none = none + "," + none;
    const DynaDeck deck =
        read(two + "*PART\np\n1,1,1,1,1\n*SECTION_SHELL\n1," + two_none + "," + none + "\n2.0\n*HOURGLASS\n1," +
             two_none + "," + none + "," + two_none + "," + two_none + "\n*CONTROL_BULK_VISCOSITY\n" + two_none +
             "\n*CONTROL_TIMESTEP\n" + two_none + "\n*MAT_JOHNSON_COOK\n1,1,1\n1,1,1,1,1,2,0," + none + "\n");
    CHECK(deck.section("p").element_form == 2);
    CHECK(deck.section("p").shear_factor == 1);
    CHECK(deck.section("p").points == 2);
    CHECK(deck.section("p").corner_thickness == std::array{2.0, 2.0, 2.0, 2.0});
    CHECK(deck.hourglass("p").type == 1);
    CHECK(deck.hourglass("p").coefficient == 0.1);
    CHECK(deck.hourglass("p").quadratic == 1.5);
    CHECK(deck.hourglass("p").linear == 0.06);
    CHECK(deck.hourglass("p").bending == 0.1);
    CHECK(deck.hourglass("p").warping == 0.1);
    CHECK(deck.bulk_viscosity == std::array{1.5, 0.06});
    CHECK(deck.step_factor == 0.9);
    CHECK(deck.material<JohnsonCookMaterial>("p").strength.reference_rate == 1);
  }
}

TEST_CASE("dyna cards: a line of zeros supports nothing, and a user's section is one section") {
  const DynaDeck deck = read(two + R"(*SET_NODE_LIST
1
1,2
*BOUNDARY_SPC_SET
         0         0         0         0         0         0         0         0
         1         0         1         1         1         0         0         0
*SECTION_SOLID
         1       101
         2         0         0         0         9
       .25       .25       .25       1.0
       .75       .75       .75       1.0
       1.0       2.0       3.0       4.0       5.0       6.0       7.0       8.0
       9.0
         2         1
*SECTION_SHELL_TITLE
of a user
3,102
.5
2,0,0,0,0,9
.25,.25,1.
.75,.75,1.
1,2,3,4,5,6,7,8
9
and another
4,2
.7
)");
  REQUIRE(deck.supports.size() == 1);
  CHECK(deck.supports[0].nodes == std::vector<Index>{0, 1});
  REQUIRE(deck.sections.size() == 4);
  CHECK(deck.sections[0].element_form == 101);
  CHECK(deck.sections[1].number == 2);
  CHECK(deck.sections[2].element_form == 102);
  CHECK(deck.sections[3].thickness == 0.7);
  CHECK(deck.warnings == std::vector<std::string>{
                             "The element of the user of *SECTION_SOLID (1) had no effect: line 19.",
                             "The element of the user of *SECTION_SHELL_TITLE (1) had no effect: line 29.",
                         });
}

TEST_CASE("dyna cards: values without a counterpart are listed") {
  const DynaDeck deck = read(two + R"(*MAT_PLASTIC_KINEMATIC
1,1,1,0,1,.1
*MAT_PIECEWISE_LINEAR_PLASTICITY
2,1,1,0,1,,-1
0,0,0,0,0,3
*BOUNDARY_SPC_NODE
1,,1
*RIGIDWALL_PLANAR
0,0,0,0,.5
0,0,0,0,0,1
*CONTACT_AUTOMATIC_SINGLE_SURFACE
4,0,7
*CONTROL_TERMINATION
1
2
*CONTACT_INTERIOR
*MAT_ELASTIC
3,1,1,0,0,.1
)");
  CHECK(deck.warnings == std::vector<std::string>{
                             "*CONTACT_INTERIOR (0 cards) was skipped: line 26.",
                             "FAIL below 0 of *MAT_PIECEWISE_LINEAR_PLASTICITY (1) had no effect: line 14.",
                             "Further fields of *MAT_PIECEWISE_LINEAR_PLASTICITY (1) had no effect: line 15.",
                             "BIRTH of *RIGIDWALL_PLANAR (1) had no effect: line 19.",
                             "What follows the cards of *CONTROL_TERMINATION (1) had no effect: line 25.",
                             "Further fields of *MAT_ELASTIC (1) had no effect: line 28.",
                             "SSTYP 7 of a contact (all parts are taken) (1) had no effect: line 22.",
                         });
}

TEST_CASE("dyna cards: what is wrong is told with its line") {
  const auto refused = [](const std::string& text, const std::string& sentence) {
    CHECK_THROWS_WITH(read(two + text),
                      ContainsSubstring("strike: the file 'a.k', line ") && ContainsSubstring(sentence));
  };
  refused("*MAT_ELASTIC\n1,0,1\n", "line 12: RO is not positive: give the material its RO.");
  refused("*MAT_ELASTIC\n1,1\n", "line 12: E is not positive");
  refused("*MAT_ELASTIC\n1,1,1,.5\n", "line 12: PR is not between -1 and 0.5: correct it.");
  refused("*MAT_PLASTIC_KINEMATIC\n1,1,1,0,1,2\n", "ETAN is not below E");
  refused("*BOUNDARY_SPC_SET\n0,0,1\n", "line 12: a support has no NSID: give it one.");
  refused("*MAT_JOHNSON_COOK\n1,1\n", "G is not positive: give the material its G, or E and PR.");
  refused("*EOS_GRUNEISEN\n1,x\n", "line 12: C 'x' is no number");
  refused("*RIGIDWALL_PLANAR\n0\n1,1,1,1,1,1\n", "the normal of the wall has no length");
  refused("*RIGIDWALL_PLANAR\n3\n0,0,0,0,0,1\n", "line 12: the set of nodes 3 is not in the file");
  refused("*BOUNDARY_SPC_NODE\n7,0,1\n", "line 12: node 7 is not in the file");
  refused("*INITIAL_VELOCITY_GENERATION\n1,4\n", "STYP 4 is none: give 1 (part set), 2 (part) or 3 (node set).");
  refused("*INITIAL_VELOCITY_GENERATION\n1,2,3.\n", "the axis of a spin has no direction");
  refused("*INITIAL_VELOCITY_GENERATION\n9,2\n", "line 12: part 9 is not in the file");
  refused("*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n9,8\n*SET_SEGMENT_GENERAL\n9\n",
          "line 12: the set of segments 9 is not among those read (*SET_SEGMENT_GENERAL on line 13 was skipped)");
  refused("*CONTACT_AUTOMATIC_SINGLE_SURFACE\n9,0,2\n", "line 12: the set of parts 9 is not in the file");
}
