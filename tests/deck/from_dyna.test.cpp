// Cards of LS-DYNA as a scene, in sentences and in C++. That scenes and programs give the same bits is seen
// where examples are built (tests/run examples), for each pair would have to be compiled.
#include <algorithm>
#include <string>
#include <variant>
#include <vector>

#include <strike/deck/from_dyna.hpp>
#include <strike/deck/program.hpp>
#include <strike/input/dyna.hpp>

#include "support/catch.hpp"

using namespace strike;
using Catch::Matchers::ContainsSubstring;

namespace {

/// Two cubes of one element, a plate under them, and further cards.
DeckScene scene_of(const std::string& cards) {
  const std::string mesh = R"(*KEYWORD
*NODE
1,0,0,0
2,1,0,0
3,1,1,0
4,0,1,0
5,0,0,1
6,1,0,1
7,1,1,1
8,0,1,1
11,0,0,2
12,1,0,2
13,1,1,2
14,0,1,2
15,0,0,3
16,1,0,3
17,1,1,3
18,0,1,3
21,-1,-1,-1
22,2,-1,-1
23,2,2,-1
24,-1,2,-1
*ELEMENT_SOLID
1,1,1,2,3,4,5,6,7,8
2,2,11,12,13,14,15,16,17,18
*ELEMENT_SHELL
3,3,21,22,23,24
*PART
lower cube
1,1,1
*PART
2nd
2,1,2
*PART

3,2,3
*SECTION_SOLID
1,1
*SECTION_SHELL
2,2,,5
.1
)";
  return deck_scene(read_dyna(mesh + cards + "*END\n", "a.k"));
}
const std::string three_metals = R"(*MAT_ELASTIC
1,7.8,200,.25
*MAT_PLASTIC_KINEMATIC
2,7.8,200,.25,.5,0,1
0,0,.3
*MAT_ELASTIC
3,2.7,70,.25
)";
const std::string ended = "*CONTROL_TERMINATION\n2\n";

bool has(const std::vector<std::string>& sentences, const std::string& piece) {
  return std::any_of(sentences.begin(), sentences.end(),
                     [&](const std::string& sentence) { return sentence.find(piece) != sentence.npos; });
}

}  // namespace

TEST_CASE("deck: parts become pairs of element and material, with the code that makes them") {
  const DeckScene scene = scene_of(three_metals + ended);
  REQUIRE(scene.parts.size() == 3);
  CHECK(scene.cannot == std::vector<std::string>{});
  CHECK(scene.end == 2);
  CHECK(scene.interval == Approx(0.05));

  const auto* const lower = std::get_if<PartOf<DeckHexahedron, Elastic>>(&scene.parts[0].item);
  REQUIRE(lower);
  CHECK(lower->material.youngs_modulus == 200);
  CHECK(lower->element.hourglass.coefficient == 0.1);
  CHECK(lower->cells.size() == 1);
  CHECK(scene.parts[0].name == "lower_cube_1");
  CHECK(scene.parts[1].name == "part_2");
  CHECK(scene.parts[2].name == "part_3");

  const auto* const upper = std::get_if<PartOf<DeckHexahedron, DeckFailingMetal, Erosion>>(&scene.parts[1].item);
  REQUIRE(upper);
  CHECK(upper->material.failure.failure_strain == 0.3);
  CHECK(upper->material.eos.bulk_modulus == Approx(200 / (3 * (1 - 2 * 0.25))));
  CHECK(scene.parts[1].removal == "Erosion{}");
  CHECK_THAT(scene.parts[1].material, ContainsSubstring("FailureStrain{.failure_strain = 0.3}"));

  CHECK(std::holds_alternative<PartOf<Plate4<>, DeckSection<Elastic>>>(scene.parts[2].item));
  CHECK(scene.parts[2].material ==
        "Homogeneous{PlaneStress{Elastic{.density = 2.7, .youngs_modulus = 70, .poissons_ratio = 0.25}}, 0.1}");
  CHECK(scene.parts[2].cells == "deck.part(3).quadrilaterals");
}

TEST_CASE("deck: what asks for another element, and what has none, is told") {
  const DeckScene scene = scene_of(R"(*MAT_ELASTIC
1,7.8,200,.25
*MAT_SPRING_ELASTIC
2,1
*MAT_ELASTIC
3,2.7,70,.25
*CONTROL_HOURGLASS
6,.1
*CONTROL_BULK_VISCOSITY
1.2,.1
*CONTROL_SHELL
20,0,0,1
*MAT_ADD_EROSION
1
,,,,.3
*LOAD_HEAT_GENERATION_SET
1,1
)");
  CHECK(has(scene.cannot, "ISTUPD"));
  CHECK(has(scene.cannot, "Part 1, lower cube: *MAT_ADD_EROSION of a material that does not flow"));
  CHECK(has(scene.replaced, "SHRF"));
  CHECK(has(scene.replaced, "hourglass control of Plate4"));
  CHECK(has(scene.cannot, "The deck has no end"));
  CHECK(has(scene.cannot, "Part 2, 2nd has no material that is known here"));
  CHECK(has(scene.cannot, "*LOAD_HEAT_GENERATION_SET"));
  REQUIRE(scene.parts.size() == 2);
  CHECK(std::holds_alternative<PartOf<Hex8<>, Elastic>>(scene.parts[0].item));
  CHECK(scene.parts[0].element ==
        "Hex8{PhysicalHourglass{}, HughesWinget{}, BulkViscosity{.quadratic = 1.2, .linear = 0.1}}");
}

TEST_CASE("deck: contacts are pairs of parts with their friction") {
  const DeckScene all = scene_of(three_metals + ended + "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0,,0\n.2,.2\n\n");
  REQUIRE(all.contacts.size() == 1);
  CHECK(all.contacts[0].code == "Contact{Everything{}, Penalty{}, Coulomb{.coefficient = 0.2}}");

  const DeckScene two = scene_of(three_metals + ended +
                                 "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n1,2,3,3\n.2,.2\n\n"
                                 "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n1,3,3,3\n.2,.1,1\n\n"
                                 "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n2,3,3,3\n.2,.2\n\n");
  REQUIRE(two.contacts.size() == 2);
  CHECK(two.contacts[0].code ==
        "Contact{Everything{.except = {{0, 0}, {0, 2}, {1, 1}, {2, 2}}}, Penalty{}, Coulomb{.coefficient = 0.2}}");
  CHECK_THAT(two.contacts[1].code, ContainsSubstring("{{0, 0}, {0, 1}, {1, 1}, {1, 2}, {2, 2}}"));
  CHECK(has(two.replaced, "friction does not fall with the speed"));
  CHECK(has(scene_of(three_metals + ended + "*CONTACT_TIED_SURFACE_TO_SURFACE\n1,2,3,3\n\n\n").cannot, "TIED"));
}

TEST_CASE("deck: a rigid part is a body behind the parts, with those that move with it") {
  const std::string materials = R"(*MAT_ELASTIC
1,7.8,200,.25
*MAT_RIGID
2,7.8,200,.25
1,4,7
*MAT_RIGID
3,7.8,200,.25
)";
  const DeckScene scene = scene_of(materials + ended + "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0,,0\n.2,.2\n\n");
  REQUIRE(scene.parts.size() == 1);
  REQUIRE(scene.bodies.size() == 2);
  CHECK(scene.bodies[0].code ==
        "RigidBody{deck.cells_of({2}), 7.8, HeldBody{{{1, 0, 0}, {0, 1, 0}}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}}");
  CHECK(scene.bodies[1].code == "RigidBody{deck.cells_of({3}), 7.8, 0.1}");
  CHECK(std::holds_alternative<RigidBody<>>(scene.bodies[1].item));
  CHECK(scene.contacts[0].code == "Contact{Everything{}, Penalty{}, Coulomb{.coefficient = 0.2}}");

  const DeckScene merged = scene_of(
      materials + ended + "*CONSTRAINED_RIGID_BODIES\n2,3\n*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n1,3,3,3\n\n\n");
  CHECK_THAT(merged.contacts.at(0).code, ContainsSubstring("{{0, 0}, {0, 1}, {1, 1}, {1, 2}, {2, 2}}"));
  REQUIRE(merged.bodies.size() == 1);
  CHECK_THAT(merged.bodies[0].code, ContainsSubstring("deck.cells_of({2, 3}), 7.8, 0.1"));

  const DeckScene driven = scene_of(materials + ended + R"(*DEFINE_CURVE
9
0,1
1,2
*BOUNDARY_PRESCRIBED_MOTION_RIGID
2,3,0,9,2
)");
  CHECK(std::holds_alternative<RigidBody<HeldBody, BodyVelocity<CardHistory>>>(driven.bodies[0].item));
  CHECK_THAT(driven.bodies[0].code,
             ContainsSubstring("BodyVelocity{deck.motions[0].direction, deck.motions[0].history}}"));
}

TEST_CASE("deck: conditions and loads are those of the deck's cards") {
  const DeckScene scene = scene_of(three_metals + ended + R"(*DEFINE_CURVE
9
0,1
2,2
*SET_NODE_LIST
4
1,2,3,4
*BOUNDARY_SPC_SET
4,0,0,0,1
*INITIAL_VELOCITY_GENERATION
2,2,0,0,0,-5

*LOAD_BODY_Z
9,9.8
*LOAD_NODE_SET
4,1,9
*LOAD_SEGMENT
9,2,0,21,22,23,24
*BOUNDARY_PRESCRIBED_MOTION_NODE
18,1,2,9
*RIGIDWALL_PLANAR
0
0,0,-3,0,0,0,.3
*DATABASE_HISTORY_NODE
18
)");
  CHECK(scene.cannot == std::vector<std::string>{});
  CHECK(scene.supports.at(0).code == "Support{deck.supports[0].nodes, {{0, 0, 1}}, {}}");
  CHECK(scene.velocities.at(0).code == "InitialVelocity{{0, 0, -5}, deck.velocities[0].nodes}");
  CHECK(scene.body_forces.at(0).code == "BodyForce{deck.body_loads[0].direction, deck.body_loads[0].history}");
  CHECK(scene.nodal_forces.at(0).code ==
        "NodalForce{deck.nodal_loads[0].direction, deck.nodal_loads[0].nodes, deck.nodal_loads[0].history}");
  CHECK(scene.pressures.at(0).code == "Pressure{deck.pressures[0].faces(), deck.pressures[0].history}");
  CHECK(std::holds_alternative<PrescribedDisplacement<CardHistory>>(scene.motions.at(0).item));
  CHECK(scene.walls.at(0).code == "RigidWall{{0, 0, -3}, {0, 0, 1}, deck.walls[0].nodes, 0.3}");

  const std::string program = program_of(scene, "a \"deck\".k", "out");
  for (const char* line : {"  const DynaDeck deck = read_dyna(\"a \\\"deck\\\".k\");\n",
                           "Part{Hex8{ViscousHourglass{}}, lower_cube_1, deck.part(1).hexahedra},\n",
                           "RigidWall{{0, 0, -3}, {0, 0, 1}, deck.walls[0].nodes, 0.3}},\n",
                           "  for (const Index node : deck.history_nodes)\n", "  run.until(2, Every{0.05,"})
    CHECK_THAT(program, ContainsSubstring(line));
  for (std::size_t at = 0, end = 0; (end = program.find('\n', at)) != program.npos; at = end + 1)
    CHECK(end - at <= 120);
}

TEST_CASE("deck: a blast is that of its card, in its units; kinds of bursts that are not there are told") {
  const auto blast_of = [](const std::string& unit, const std::string& burst, const std::string& segments) {
    return scene_of(three_metals + ended + "*LOAD_BLAST_ENHANCED\n7,2.5,0,0,900,-.5," + unit + "," + burst +
                    "\n,,,,,3.,1\n" + (burst == "3" || burst == "4" ? "\n" : "") + segments);
  };
  const std::string segment = "*LOAD_BLAST_SEGMENT\n7,21,22,23,24\n";
  const DeckScene scene = blast_of("6", "1", segment);
  CHECK(scene.cannot == std::vector<std::string>{});
  CHECK(scene.blasts.at(0).code == "AirBlast{deck.blasts[0].faces(), deck.blasts[0].charge()}");
  CHECK(has(scene.becomes, "Blast of 2.5 of TNT on the ground at {0, 0, 900} on 1 faces"));
  CHECK_THAT(program_of(scene, "a.k", "out"), ContainsSubstring("AirBlast{deck.blasts[0].faces()"));

  const std::string cards =
      "*NODE\n1,0,0,0\n2,1,0,0\n3,1,1,0\n4,0,1,0\n*ELEMENT_SHELL\n1,1,1,2,3,4\n"
      "*LOAD_BLAST_ENHANCED\n7,2.5,0,0,900,-.5,6,1\n,,,,,3.,1\n*LOAD_BLAST_SEGMENT\n7,1,2,3,4\n";
  const Charge charge = read_dyna(cards, "a.k").blasts.at(0).charge();
  CHECK(charge.burst == Burst::surface);
  CHECK(charge.start == -0.5);
  CHECK(charge.end == 3);
  CHECK(!charge.suction);
  const BlastWave si = Charge{.mass = 2.5, .centre = {0, 0, 0}, .burst = Burst::surface}.wave(0.9);
  const BlastWave wave = charge.wave(900);  // kg, mm, ms, GPa
  CHECK(wave.reflected_pressure == Approx(1e-9 * si.reflected_pressure));
  CHECK(wave.arrival == Approx(1e3 * si.arrival));

  CHECK(has(blast_of("1", "2", segment).replaced, "*LOAD_BLAST_ENHANCED 7: its pressures are in 6894."));
  CHECK(!has(blast_of("3", "2", segment).replaced, "pressures are in"));
  CHECK(has(blast_of("6", "3", segment).cannot, "*LOAD_BLAST_ENHANCED 7 is left out: its charge moves"));
  CHECK(blast_of("6", "4", segment).blasts.empty());
  CHECK(has(blast_of("6", "2", "").cannot, "has no faces"));
}

TEST_CASE("deck: numbers are written so that they read back as the same") {
  const TabulatedHardening law{1.0 / 3, {{0, 0.1 + 0.2}, {0.1, 0.4}, {2, 0.5}}};
  CHECK(detail::code_of(law) ==
        "TabulatedHardening{0.3333333333333333, {{0, 0.30000000000000004}, {0.1, 0.4}, {2, 0.5}}}");
  CHECK(
      detail::code_of(GruneisenEos{.density = 1, .sound_speed = 2, .S1 = 1.5, .gamma = 2, .pressure_cutoff = -1e-7}) ==
      "GruneisenEos{.density = 1, .sound_speed = 2, .S1 = 1.5, .gamma = 2, .pressure_cutoff = -1e-07}");
}
