// Cards of LS-DYNA as a scene, in sentences and in C++. That scenes and programs give the same bits is seen
// where examples are built (tests/run examples), for each pair would have to be compiled.
#include <numeric>
#include <string>
#include <variant>
#include <vector>

#include <strike/deck/from_dyna.hpp>
#include <strike/deck/program.hpp>
#include <strike/dynamics/explicit.hpp>
#include <strike/input/dyna.hpp>

#include "deck/sentences.hpp"
#include "support/catch.hpp"

using namespace strike;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::StartsWith;
using testing::has;

namespace {

/// Two cubes of one element, a plate under them, and further cards.
DynaDeck deck_of(const std::string& cards) {
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
  return read_dyna(mesh + cards + "*END\n", "a.k");
}
DeckScene scene_of(const std::string& cards) { return deck_scene(deck_of(cards)); }
const std::string three_metals = R"(*MAT_ELASTIC
1,7.8,200,.25
*MAT_PLASTIC_KINEMATIC
2,7.8,200,.25,.5,0,1
0,0,.3
*MAT_ELASTIC
3,2.7,70,.25
)";
const std::string ended = "*CONTROL_TERMINATION\n2\n";

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
  CHECK(!has(two.replaced, "springs as stiff as the step allows"));
  for (const char* const values : {".2,.2,,,20\n\n", ".2,.2\n2\n", ".2,.2\n\n1\n"})  // VDC, SFS, SOFT
    CHECK(has(scene_of(three_metals + ended + "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0,,0\n" + values).replaced,
              "Contact SINGLE_SURFACE: springs as stiff as the step allows, without damping, stand for"));
  CHECK(has(scene_of(three_metals + ended + "*CONTACT_TIED_SURFACE_TO_SURFACE\n1,2,3,3\n\n\n").cannot, "TIED"));

  // Fields that preprocessors fill in, of the search and of files, do not keep a deck from running.
  const DeckScene filled = scene_of(three_metals + ended +
                                    "*CONTROL_CONTACT\n0,1,,,,,1\n\n\n1\n*DATABASE_GLSTAT\n.1,1,0,1\n"
                                    "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n0,,0\n\n1,,,,,,1,1\n0,,,,,,1\n");
  CHECK(filled.cannot == std::vector<std::string>{});
  for (const char* const field : {"RWPNAL of *CONTROL_CONTACT", "of *DATABASE_GLSTAT", "BSORT of *CONTACT"})
    CHECK(has(filled.replaced, field));
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
  CHECK(!has(merged.cannot, "*CONSTRAINED_RIGID_BODIES"));
  for (const char* const pair : {"2,1", "1,2", "2,7"})  // with a part that is elastic, with a body of nodes
    CHECK(has(scene_of(materials + ended + "*SET_NODE\n7\n1,2,3\n*CONSTRAINED_NODAL_RIGID_BODY\n7,,7\n" +
                       "*CONSTRAINED_RIGID_BODIES\n" + pair + "\n")
                  .cannot,
              std::string("*CONSTRAINED_RIGID_BODIES of ") + pair[0] + " and " + pair[2] + " is left out"));

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

TEST_CASE("deck: a rigid part has the inertia and the velocity of its own card, and carries extra nodes") {
  const std::string materials = R"(*MAT_ELASTIC
1,7.8,200,.25
*MAT_RIGID
2,7.8,200,.25
)";
  const auto with_part = [&](const std::string& inertia, const std::string& more) {
    return scene_of(materials + "*MAT_RIGID\n3,7.8,200,.25\n" + ended + "*PART_INERTIA\nheavy\n9,2,3\n" + inertia +
                    "*ELEMENT_SHELL\n9,9,21,22,15,15\n" + more);
  };
  const DeckScene scene = with_part("1,2,3,5\n4,.1,.2,5,.3,6\n1,0,0,0,0,7\n",
                                    "*CONSTRAINED_EXTRA_NODES_NODE\n9,7\n9,8\n*CONSTRAINED_EXTRA_NODES_NODE\n2,6\n");
  CHECK(scene.cannot == std::vector<std::string>{});
  REQUIRE(scene.bodies.size() == 3);
  CHECK(scene.bodies[2].code ==
        "RigidBody{deck.cells_of({9}), deck.inertias[0].whole(), 0.1}.with_nodes(deck.extra_nodes[0].nodes)"
        ".moving(deck.inertias[0].velocity, deck.inertias[0].spin)");
  CHECK_THAT(scene.bodies[0].code, ContainsSubstring("7.8}.with_nodes(deck.extra_nodes[1].nodes)"));
  CHECK(has(scene.becomes, "1 plates, with mass, inertia and velocity of its own card, and 2 extra nodes"));
  // The body as a run has it.
  Nodes<double> nodes(scene.nodes, detail::ascending([&] {
                        std::vector<Index> all;
                        for (Index i = 0; i < scene.nodes.size(); ++i) all.push_back(i);
                        return all;
                      }()));
  auto body = std::get<RigidBody<>>(scene.bodies[2].item);
  body.add_body(nodes), body.start_body(nodes);
  const RigidMotion& motion = nodes.bodies()[0];
  CHECK(motion.mass() == 5);
  CHECK(motion.centre() == Eigen::Vector3d(1, 2, 3));
  CHECK(motion.velocity() == Eigen::Vector3d(1, 0, 0));
  CHECK((motion.angular_momentum() - 7 * Eigen::Vector3d(0.2, 0.3, 6)).norm() < 1e-14);
  CHECK(nodes.is_rigid(6));
  CHECK((nodes.v(6) - (Eigen::Vector3d(1, 0, 0) + 7 * Eigen::Vector3d(1, 0, 0))).norm() < 1e-13);  // at (1, 1, 1)

  const DeckScene impossible = with_part("1,2,3,5\n4,,,5,,10\n0\n", "");
  CHECK(has(impossible.cannot, "Part 9, heavy: its moment of inertia has the components 4, 5, 10"));
  CHECK_THAT(impossible.bodies[2].code, ContainsSubstring("7.8, 0.1}"));
  const DeckScene merged = with_part("1,2,3,5\n4,,,5,,6\n0\n", "*CONSTRAINED_RIGID_BODIES\n9,3\n");
  CHECK(has(merged.replaced, "its *PART_INERTIA is that of all the parts"));
  CHECK_THAT(merged.bodies[1].code, ContainsSubstring("deck.cells_of({3, 9}), deck.inertias[0].whole(), 0.1}"));
  const DeckScene led = with_part("1,2,3,5\n4,,,5,,6\n0\n", "*CONSTRAINED_RIGID_BODIES\n3,9\n");
  CHECK(has(led.cannot, "*PART_INERTIA of part 9 is left out, which moves with part 3"));
  const DeckScene elastic = scene_of(three_metals + ended + "*CONSTRAINED_EXTRA_NODES_NODE\n1,16\n");
  CHECK(has(elastic.cannot, "The extra nodes of part 1 are left out"));
}

TEST_CASE("deck: a rigid body of nodes has the inertia and the velocity of its own card as a whole") {
  const auto with_body = [](const std::string& inertia, const std::string& more = "") {
    return scene_of(three_metals + ended + "*SET_NODE\n7\n1,2,3,4\n*CONSTRAINED_NODAL_RIGID_BODY_INERTIA\n7,,7\n" +
                    inertia + more);
  };
  const std::string whole = "1,2,3,50\n40,.1,.2,50,.3,60\n1,0,0,0,0,7\n";
  const DeckScene scene = with_body(whole, "*CONSTRAINED_EXTRA_NODES_NODE\n7,21\n");
  CHECK(scene.cannot == std::vector<std::string>{});
  REQUIRE(scene.bodies.size() == 1);
  CHECK(scene.bodies[0].code ==
        "RigidBody{deck.rigid_bodies[0].nodes, deck.rigid_bodies[0].inertia->whole()}"
        ".with_nodes(deck.extra_nodes[0].nodes)"
        ".moving(deck.rigid_bodies[0].inertia->velocity, deck.rigid_bodies[0].inertia->spin)");
  CHECK(has(scene.becomes, "Rigid body 7 of 4 nodes, with mass, inertia and velocity of its own card, and 1 extra"));
  // The body as a run has it, whose nodes have masses of elements.
  std::vector<Index> all(scene.nodes.size());
  std::iota(all.begin(), all.end(), Index{0});
  Nodes<double> nodes(scene.nodes, all);
  for (const Index i : all) nodes.add_mass(i, 0.5);
  auto body = std::get<RigidBody<>>(scene.bodies[0].item);
  body.add_body(nodes), body.start_body(nodes);
  const RigidMotion& motion = nodes.bodies()[0];
  CHECK(motion.mass() == 50);
  CHECK(motion.centre() == Eigen::Vector3d(1, 2, 3));
  CHECK(motion.velocity() == Eigen::Vector3d(1, 0, 0));
  CHECK((motion.angular_momentum() - 7 * Eigen::Vector3d(0.2, 0.3, 60)).norm() < 1e-13);

  const DeckScene impossible = with_body("1,2,3,5\n4,,,5,,10\n0\n");
  CHECK(has(impossible.cannot, "Rigid body 7: its moment of inertia has the components 4, 5, 10"));
  CHECK(impossible.bodies.at(0).code == "RigidBody{deck.rigid_bodies[0].nodes, Inertia{}}");
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

namespace {

/// Two plates side by side in part 1 and a third in part 2, of a composite material 7 whose AOPT and MANGLE are given.
DeckScene plates_of(const std::string& cards, const std::string& aopt = "2,,,,1,0,0,", const std::string& first = "") {
  const std::size_t comma = aopt.find(',');
  return deck_scene(read_dyna("*KEYWORD\n" + first + R"(*NODE
1,0,0,0
2,1,0,0
3,2,0,0
4,0,1,0
5,1,1,0
6,2,1,0
7,3,0,0
8,3,1,0
*MAT_ENHANCED_COMPOSITE_DAMAGE
7,1.6,140,9,9,.02,.02,.4
5,3,4,,)" + aopt.substr(0, comma) +
                                  "\n" + aopt.substr(comma + 1) +
                                  R"(

0,0
1.2,2,.2,.05,.09,54,.5
*MAT_ELASTIC
8,2.5,70,.25
*MAT_PLASTIC_KINEMATIC
9,7.8,200,.25,.5
*CONTROL_TERMINATION
2
)" + cards + "*END\n",
                              "a.k"));
}
const std::string three_plates = "*ELEMENT_SHELL\n1,1,1,2,5,4\n2,1,2,3,6,5\n3,2,3,7,8,6\n";
const std::string composite = "*PART_COMPOSITE\nskin\n1,2,1,1\n7,.2,30,,8,.5\n7,.3,-45\n";
const std::string second = "*PART_COMPOSITE\nrib\n2,2\n7,.1,0,,7,.1,90\n";
using LaminatePart = PartOf<Plate4<>, DeckLaminate, Erosion>;

}  // namespace

TEST_CASE("deck: layers become a laminate of plies that fail") {
  const DeckScene scene = plates_of(three_plates + composite + second, "2,,,,1,0,0,20");
  CHECK(scene.cannot == std::vector<std::string>{});
  REQUIRE(scene.parts.size() == 2);
  const auto* const skin = std::get_if<LaminatePart>(&scene.parts[0].item);
  REQUIRE(skin);
  const OrthotropicPly ply{.density = 1.6, .E1 = 140, .E2 = 9, .nu12 = .02 * 140 / 9, .G12 = 5, .G13 = 4, .G23 = 3};
  const OrthotropicPly core{
      .density = 2.5, .E1 = 70, .E2 = 70, .nu12 = .25, .G12 = 28, .G13 = 28, .G23 = 28, .nu23 = .25};
  const Layered expected{PlyStack{{Ply{ply, .2, 30}, Ply{core, .5}, Ply{ply, .3, -45}}}, FibreDirection{{1, 0, 0}},
                         Offset{-0.5}};  // the nodes lie in the top
  CHECK(skin->material.thickness() == Approx(1));
  CHECK(skin->material.offset() == Approx(-0.5));
  CHECK(skin->material.density() == Approx(expected.density()).epsilon(1e-14));
  const LaminateStiffness &a = skin->material.laminate_stiffness(), &b = expected.laminate_stiffness();
  CHECK((a.A - b.A).norm() <= 1e-12 * b.A.norm());  // rounding
  CHECK((a.B - b.B).norm() <= 1e-12 * b.B.norm());
  CHECK((a.D - b.D).norm() <= 1e-12 * b.D.norm());
  CHECK(scene.parts[0].material ==
        "Layered{PlyStack{{Ply{ply_7, 0.2, 30}, Ply{ply_8, 0.5}, Ply{ply_7, 0.3, -45}}}, Offset{-0.5}, "
        "FibreDirection{{1, 0, 0}}}");
  CHECK(scene.parts[0].removal == "Erosion{}");
  REQUIRE(scene.materials.size() == 2);
  CHECK_THAT(scene.materials[0].code, ContainsSubstring("ChangChang{.Xt = 2, .Xc = 1.2, .Yt = 0.05, .Yc = 0.2, "
                                                        ".S = 0.09, .beta = 0.5}"));
  CHECK(has(scene.replaced, "Part 1, skin: Material 7: its angle, or BETA of its plates, counts for AOPT 0 and 3"));
  CHECK(has(scene.replaced, "Part 2, rib: the transverse shear by equilibrium stands for SHRF 1"));
  const std::string program = program_of(scene, "a.k", "a");
  const std::size_t at = program.find("  const auto ply_7 = FailingPly{OrthotropicPly{");
  CHECK(at < program.find("  const auto skin_1 = "));
  CHECK(program.find("const auto ply_7", at + 10) == program.npos);
}

TEST_CASE("deck: angles of plies count from where the card says") {
  const auto angles = [](const std::string& text) {  // of the plies of the first part
    std::vector<double> all;
    for (std::size_t at = 0; (at = text.find("Ply{ply_7, ", at)) != text.npos; ++at) {
      const std::string ply = text.substr(at, text.find('}', at) - at);
      const std::size_t second_comma = ply.find(',', ply.find(',') + 1);
      all.push_back(second_comma == ply.npos ? 0 : std::stod(ply.substr(second_comma + 1)));
    }
    return all;
  };
  const auto of = [&](const DeckScene& scene) { return angles(scene.parts.at(0).material); };
  using Angles = std::vector<double>;
  CHECK(of(plates_of(three_plates + composite)) == Angles{30, -45});
  CHECK(of(plates_of(three_plates + composite, "0,,,,0,0,0,20")) == Angles{50, -25});  // MANGLE of AOPT 0
  const std::string beta = "*ELEMENT_SHELL_BETA\n1,1,1,2,5,4\n0,0,0,0,";
  const DeckScene turned = plates_of(beta + "10\n2,1,2,3,6,5\n0,0,0,0,10\n" + composite, "0,,,,0,0,0,20");
  CHECK(of(turned) == Angles{40, -35});  // BETA before MANGLE
  CHECK(turned.cannot == std::vector<std::string>{});
  CHECK(has(plates_of(beta + "10\n2,1,2,3,6,5\n0,0,0,0,11\n" + composite, "0,,,,,,,,").cannot, "of their own differ"));
  CHECK(has(plates_of(beta + "10\n*ELEMENT_SHELL\n2,1,2,3,6,5\n" + composite, "0,,,,,,,,").cannot, "differ"));
}

TEST_CASE("deck: fibres along the first side of each plate are one direction, or are told") {
  const auto scene = [](const char* second_plate) {
    return plates_of(detail::joined({"*ELEMENT_SHELL\n1,1,1,2,5,4\n2,1,", second_plate, "\n"}) + composite,
                     "0,,,,,,,,");
  };
  CHECK(scene("2,3,6,5").cannot == std::vector<std::string>{});
  CHECK(scene("6,5,2,3").cannot == std::vector<std::string>{});  // half a turn
  CHECK_THAT(scene("6,5,2,3").parts.at(0).material, ContainsSubstring("FibreDirection{{1, 0, 0}}"));
  CHECK(has(scene("3,6,5,2").cannot, "turn by up to 90 degrees"));
  CHECK(has(plates_of(three_plates + "*MAT_ENHANCED_COMPOSITE_DAMAGE\n6,1.6,140,9,9,.02,.02,.4\n5,3,4,,2\n"
                                     ",,,0,1,0\n\n0,0\n\n*PART_COMPOSITE\nskin\n1,2\n7,.2,30,,6,.5\n")
                .cannot,
            "several directions"));
}

TEST_CASE("deck: layers that are no plies here are told, with their material") {
  const std::string part = "*PART_COMPOSITE\nskin\n1,2\n7,.2,30,,";
  for (const auto& [layers, sentence] :
       {std::pair{"9,.5", "Material 9 of a layer, *MAT_PLASTIC_KINEMATIC, is neither a ply nor elastic"},
        {"5,.5", "Material 5 of a layer is not known here"}}) {
    const DeckScene scene = plates_of(three_plates + part + layers + "\n");
    CHECK(has(scene.cannot, sentence));
    CHECK(scene.parts.empty());
  }
  CHECK_THROWS_WITH(plates_of(three_plates + part + "7,0,20\n"), ContainsSubstring("THICK of a layer is not positive"));
  CHECK(has(plates_of(three_plates + composite + "*MAT_ADD_EROSION\n7\n,,,,.3\n").cannot, "*MAT_ADD_EROSION of plies"));
  CHECK(has(plates_of("*ELEMENT_SHELL\n1,1,1,2,5\n" + composite).cannot, "triangles of Plate3 with Layered"));
}

TEST_CASE("deck: a ply in a section is as many as its points, and plates may have a thickness of their own") {
  const std::string own = "*ELEMENT_SHELL_THICKNESS\n1,1,1,2,5,4\n.3,.3,.3,.3\n2,1,2,3,6,5\n.3,.3,.3,.3\n";
  const std::string cards =
      "*ELEMENT_SHELL\n3,2,3,7,8,6\n*PART\na\n1,5,7\n*PART\nb\n2,5,7\n*SECTION_SHELL\n5,2,,2\n.8\n";
  const DeckScene scene = plates_of(own + cards);
  CHECK(scene.cannot == std::vector<std::string>{});
  CHECK_THAT(scene.parts.at(0).material, ContainsSubstring("{Ply{ply_7, 0.15}, Ply{ply_7, 0.15}}"));
  CHECK_THAT(scene.parts.at(1).material, ContainsSubstring("{Ply{ply_7, 0.4}, Ply{ply_7, 0.4}}"));

  const std::string metal =
      "*ELEMENT_SHELL\n3,2,3,7,8,6\n*PART\na\n1,5,8\n*PART\nb\n2,5,9\n*SECTION_SHELL\n5,2,,5\n.8\n";
  const DeckScene plain = plates_of(own + metal);
  CHECK(plain.cannot == std::vector<std::string>{});
  CHECK_THAT(plain.parts.at(0).material, ContainsSubstring(", 0.3}"));
  CHECK_THAT(plain.parts.at(1).material, ContainsSubstring(", 0.8}"));
  const std::string tapered = "*ELEMENT_SHELL_THICKNESS\n1,1,1,2,5,4\n.3,.3,.4,.3\n2,1,2,3,6,5\n.3,.3,.4,.3\n";
  CHECK(has(plates_of(tapered + metal).cannot, "Part 1, a: the values of shells of their own differ"));
}

TEST_CASE("deck: the damage of Johnson and Cook is their failure law, and the least strain counts") {
  const auto scene = [](const std::string& damage, const std::string& more = "") {
    return scene_of(
        "*MAT_ELASTIC\n2,7.8,200,.25\n*MAT_ELASTIC\n3,2.7,70,.25\n*MAT_JOHNSON_COOK\n1,7.8,77,,,,1\n"
        ".8,.5,.26,.014,1,1800,300,.001\n.5,-9,2," +
        damage + "\n*EOS_GRUNEISEN\n4,4,1.5,,,2\n" + more + ended +
        "*PART\njc\n9,1,1,4\n*ELEMENT_SOLID\n9,9,1,2,3,4,5,6,7,8\n");
  };
  using Broken = PartOf<DeckHexahedron, Solid<GruneisenEos, JohnsonCook, JohnsonCookFailure>, Erosion>;
  const auto broken = [](const DeckScene& made) {
    for (const StatedPart& part : made.parts)
      if (const auto* found = std::get_if<Broken>(&part.item)) return found->material.failure;
    return JohnsonCookFailure{-1};
  };
  const JohnsonCookFailure law = broken(scene(",.05,3.44,-2.12,.002\n.61,,,.01"));
  CHECK(law.D1 == .05);
  CHECK(law.D5 == .61);
  CHECK(law.reference_rate == .001);
  CHECK(law.initial_temperature == 300);
  CHECK(law.melting_temperature == 1800);
  CHECK(law.least_strain == .01);
  CHECK(broken(scene(",.05\n0")).least_strain == 1e-6);
  CHECK(broken(scene("\n0")).D1 == -1);
  CHECK(has(scene(",0,0,-2\n0").cannot, "D3 to D5 of *MAT_JOHNSON_COOK are left out"));
  CHECK(has(scene(",.05\n0", "*MAT_ADD_EROSION\n1,,,,.3\n\n").cannot, "is left out beside EFFEPS"));

  const auto limit = [](const char* effeps) {
    const DeckScene made = scene_of(three_metals + ended + "*MAT_ADD_EROSION\n2,,,," + effeps + "\n\n");
    return std::get<PartOf<DeckHexahedron, DeckFailingMetal, Erosion>>(made.parts.at(1).item)
        .material.failure.failure_strain;
  };
  CHECK(limit(".2") == .2);
  CHECK(limit(".4") == .3);  // FS of the material
}

TEST_CASE("deck: ties join the nodes of a side that lie near the other") {
  const auto tied = [](const std::string& sides, const std::string& more = "") {
    return scene_of(three_metals + ended + "*CONTACT_TIED_SURFACE_TO_SURFACE\n" + sides + "\n" + more);
  };
  // The cubes are 1 apart: of the upper one the four lower nodes are within 0.6 x 2, the others at 2 are not.
  const DeckScene scene = tied("2,1,3,3\n\n,,-2");
  CHECK(scene.cannot == std::vector<std::string>{});
  REQUIRE(scene.ties.size() == 1);
  CHECK(has(scene.becomes, "of 8 nodes, 4 within 1.2 of the master are tied"));
  CHECK_THAT(scene.ties[0].code,
             StartsWith("Tied{nodes_near(deck.mesh.nodes, surface_nodes(surface(deck.cells_of("
                        "deck.contacts[0].slave.parts))), solid_surface(deck.part(1).hexahedra, 0), 1.2), "
                        "solid_surface(deck.part(1).hexahedra, 0), 1.20"));
  CHECK_THAT(program_of(scene, "a.k", "a"), ContainsSubstring("                     Tied{nodes_near("));
  CHECK(scene.contacts.empty());

  const DeckScene sets = tied("7,8,2,2\n\n,,-2", "*SET_PART_LIST\n7\n2\n*SET_PART_LIST\n8\n1,3\n");
  CHECK(has(sets.becomes, "of 8 nodes, 4 within"));
  CHECK_THAT(sets.ties.at(0).code,
             ContainsSubstring("solid_surface(deck.part(1).hexahedra, 0) + plate_surface(deck.part(3).quadrilaterals, "
                               "0.1, 2)"));
  const DeckScene faces = tied("7,8,4,0\n\n,,-2", "*SET_NODE_LIST\n7\n11,15,5\n*SET_SEGMENT\n8\n5,6,7,8\n");
  CHECK(has(faces.becomes, "of 3 nodes, 1 within"));  // node 5 belongs to the face
  CHECK_THAT(faces.ties.at(0).code, ContainsSubstring("deck.contacts[0].slave.nodes, Surface{deck.contacts[0].master"));

  CHECK(has(tied("2,1,3,3\n\n").cannot, "ties nothing: no node is within 0.0707"));
  CHECK(has(tied("1,3,3,3\n\n").cannot,
            "ties nothing: no node is within 0.212"));  // a twentieth of the diagonal 3 sqrt(2)
  CHECK(has(tied("2,7,3,4\n\n", "*SET_NODE_LIST\n7\n1,2\n").cannot, "and the faces or parts, that it ties"));
  const DeckScene rigid =
      scene_of("*MAT_ELASTIC\n1,7.8,200,.25\n*MAT_RIGID\n2,7.8,200,.25\n*MAT_ELASTIC\n3,2.7,70,.25\n" + ended +
               "*CONTACT_TIED_SURFACE_TO_SURFACE\n2,1,3,3\n\n,,-2\n");
  CHECK(has(rigid.cannot, "of a rigid part is left out"));
  CHECK(rigid.ties.empty());
}

TEST_CASE("deck: rigid walls that are round or end are obstacles of nodes") {
  const DeckScene scene = scene_of(three_metals + ended + R"(*RIGIDWALL_GEOMETRIC_SPHERE
0
1,1,-9,1,1,1,.2
3
*RIGIDWALL_GEOMETRIC_CYLINDER
0
0,0,-9,1,0,-9
2
*RIGIDWALL_PLANAR_FINITE
0
0,0,-4,0,0,1,.3
1,0,-4,5,6
)");
  CHECK(scene.cannot == std::vector<std::string>{});
  CHECK(scene.walls.empty());
  std::vector<std::string> codes;
  for (const auto& one : scene.obstacles) codes.push_back(one.code);
  CHECK(codes == std::vector<std::string>{
                     "Contact{NodeToRigid{deck.walls[0].nodes, RigidSurface{deck.walls[0].corners(), "
                     "{Face{{0, 1, 2, 3}, 0}}}}, Coulomb{.coefficient = 0.3}}",
                     "Contact{NodeToRigid{deck.obstacles[0].nodes, std::get<RigidSphere>(deck.obstacles[0].shape)}, "
                     "Coulomb{.coefficient = 0.2}}",
                     "Contact{NodeToRigid{deck.obstacles[1].nodes, std::get<RigidCylinder>(deck.obstacles[1].shape)}, "
                     "Coulomb{}}"});
  CHECK(has(scene.becomes, "Rigid sphere of radius 3 about {1, 1, -9}"));

  const std::string no_mass = "*RIGIDWALL_PLANAR_MOVING\n0\n0,0,-4,0,0,1\n,1\n";
  CHECK(has(scene_of(three_metals + ended + no_mass).cannot, "A rigid wall that moves is left out: it has no mass."));
  // The farthest node is (1, 1, 3), the box around all nodes 3 x 3 x 4.
  const double far = std::sqrt(51.0) + 10 * std::sqrt(34.0);
  for (const std::string lengths : {"5,0", "0,5"}) {
    const auto strip = [&](const char* moving, const char* motion) {
      return deck_of(three_metals + ended + "*RIGIDWALL_PLANAR_FINITE" + moving + "\n0\n0,0,-4,0,0,1\n1,0,-4," +
                     lengths + "\n" + motion);
    };
    const DynaDeck deck = strip("", ""), moving = strip("_MOVING", "5,1\n");
    const DeckScene endless = deck_scene(deck), driven = deck_scene(moving);
    CHECK(endless.cannot == std::vector<std::string>{});
    CHECK(has(endless.becomes, "Rigid wall with two edges, and 65.4509 long to both sides, from {0, 0, -4}"));
    CHECK_THAT(endless.obstacles.at(0).code, ContainsSubstring("RigidSurface{deck.walls[0].corners(65.45"));
    CHECK(driven.cannot == std::vector<std::string>{});
    CHECK(has(driven.more_nodes, ".corners(65.45"));
    const bool ends_along_y = lengths == "0,5";
    const auto corners = deck.walls[0].corners(far);
    CHECK(corners.at(0) == (ends_along_y ? Eigen::Vector3d(-far, 0, -4) : Eigen::Vector3d(0, -far, -4)));
    CHECK(corners.at(2).isApprox(ends_along_y ? Eigen::Vector3d(far, 5, -4) : Eigen::Vector3d(5, far, -4)));
    CHECK(deck.walls[0].corners().empty());
    CHECK(driven.nodes.back().isApprox(moving.walls[0].corners(far).back()));
  }
  const std::string sticky = "*RIGIDWALL_GEOMETRIC_SPHERE\n0\n1,1,-9,1,1,1,1\n3\n";
  CHECK(has(scene_of(three_metals + ended + sticky).cannot, "nodes stick has friction 0"));
}

TEST_CASE("deck: rigid walls that move are rigid bodies, and the program is the same") {
  const DynaDeck deck = deck_of(three_metals + ended + R"(*RIGIDWALL_PLANAR_MOVING
0
0,0,-4,0,0,1
5,-2
*RIGIDWALL_PLANAR_FINITE_MOVING
0
0,0,-4,0,0,1,.3
1,0,-4,5,6
7,3
*RIGIDWALL_GEOMETRIC_SPHERE_MOTION
0
1,1,-9,1,1,1,.2
3
3,1,0,0,4
*RIGIDWALL_GEOMETRIC_CYLINDER_MOTION
0
0,0,-9,1,0,-9
2,8
2,0,3,0,0
*DEFINE_CURVE
2
0,1
2,3
*DEFINE_CURVE
3
0,0
2,2
)");
  const DeckScene scene = deck_scene(deck);
  CHECK(scene.cannot == std::vector<std::string>{});
  CHECK(scene.walls.empty());
  CHECK(scene.nodes.size() == deck.mesh.nodes.size() + 16);
  REQUIRE(scene.bodies.size() == 4);
  REQUIRE(scene.obstacles.size() == 4);
  CHECK(scene.obstacles[0].code ==
        "Contact{NodeToRigid{deck.walls[0].nodes, Carried{RigidPlane{{0, 0, -4}, {0, 0, 1}}, frame_0}}, Coulomb{}}");
  CHECK(has({scene.bodies[0].code}, "RigidBody{frame_0.nodes, Inertia{5, {0, 0, -4}, "));
  CHECK(has({scene.bodies[0].code}, "}}}.moving({0, 0, -2})"));
  CHECK(has({scene.bodies[2].code}, "BodyDisplacement{deck.obstacles[0].motion->direction, "));
  CHECK(has({scene.bodies[3].code}, "BodyVelocity{deck.obstacles[1].motion->direction, "));
  CHECK(has(scene.becomes, "of the length 8, driven along {1, 0, 0}"));

  // A wall that strikes nothing keeps its velocity; what is driven follows its curve, u = t or v = 1 + t.
  std::vector<Index> of_deck(deck.mesh.nodes.size());
  std::iota(of_deck.begin(), of_deck.end(), Index{0});
  std::vector<DeckBody> walls;
  for (const auto& one : scene.bodies) walls.push_back(one.item);
  Explicit run{
      Scene{scene.nodes, walls, RigidBody{of_deck, Inertia{1, {0, 0, 0}, SymmetricTensor<double>::isotropic(1)}}},
      ExplicitOptions{.largest_step = 1e-3, .print_warnings = false}};
  const auto& bodies = run.nodes().bodies();
  const std::vector<RigidMotion> before(bodies.begin(), bodies.begin() + 4);
  run.until(0.5);
  const auto moved = [&](std::size_t b) { return Eigen::Vector3d(bodies[b].centre() - before[b].centre()); };
  CHECK(moved(0).isApprox(Eigen::Vector3d(0, 0, -1)));
  CHECK(moved(1).isApprox(Eigen::Vector3d(0, 0, 1.5)));
  CHECK(moved(2).isApprox(Eigen::Vector3d(0, 0, 0.5)));
  CHECK(moved(3).isApprox(Eigen::Vector3d(0.625, 0, 0)));

  const std::string program = program_of(scene, "my.k", "my");
  CHECK(has({program}, "  std::vector<Eigen::Vector3d> nodes = deck.mesh.nodes;\n"));
  CHECK(has({program}, "  const Frame frame_0 = add_frame(nodes, {0, 0, -4}, "));
  CHECK(has({program}, "deck.walls[1].corners()) nodes.push_back(corner);"));
  CHECK(has({program}, "  Explicit run{Scene{nodes,"));
}

TEST_CASE("deck: values without effect on the answer do not keep a deck from its run") {
  const DeckScene scene = scene_of(three_metals + ended +
                                   "*SET_NODE_LIST\n4,1.5\n1,2\n*HOURGLASS\n4,6,.1,2,,,.3\n*MAT_NULL\n9,1,,,,,2,.3\n"
                                   "*CONTROL_SHELL\n20,,,,,1,,1\n");
  CHECK(scene.cannot == std::vector<std::string>{});
  for (const char* value :
       {"DA1 to DA4 of *SET_NODE_LIST", "IBQ of *HOURGLASS", "VDC of *HOURGLASS", "YM, of null shells, of *MAT_NULL",
        "PR, of null shells, of *MAT_NULL", "stand for WRPANG, BWC and PROJ"})
    CHECK(has(scene.replaced, value));
  CHECK(has(scene_of(three_metals + ended + "*SECTION_SOLID\n9,1,4\n").cannot, "AET of *SECTION_SOLID"));
}

TEST_CASE("deck: plates of other elements are told") {
  const std::string shells = "*ELEMENT_SHELL\n9,9,21,22,23,24\n*PART\na\n9,9,3\n*SECTION_SHELL\n9,16,,5\n.1\n";
  CHECK(has(scene_of(three_metals + ended + shells).replaced,
            "Part 9, a: plates of one point with hourglass control stand for ELFORM 16."));
  CHECK(!has(scene_of(three_metals + ended).replaced, "ELFORM"));
}

TEST_CASE("deck: a blast is that of its card, in its units, and kinds of bursts that are not there are told") {
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

TEST_CASE("deck: a table of pressures in fluids and in solids that follow von Mises, in hexahedra") {
  const DeckScene scene = scene_of(
      three_metals +
      "*MAT_NULL\n4,1.5,,.01\n*MAT_ELASTIC_PLASTIC_HYDRO\n5,2,1,.1,0,-.3\n*MAT_JOHNSON_COOK\n6,7.8,77\n" +
      "*EOS_TABULATED\n4,2,.5\n0,-.1\n\n0,1\n\n.25,.5\n*EOS_009\n5,,,,7\n*DEFINE_CURVE\n7\n-.1,1\n0,0\n.1,-.5\n" +
      ended +
      "*PART\nwater\n7,1,4,4\n*PART\nclay\n8,1,5,5\n*PART\nsteel\n9,1,6,4\n*ELEMENT_SOLID\n7,7,1,2,3,4,5,6,7,8\n"
      "8,8,1,2,3,4,5,6,7,8\n9,9,1,2,3,4,5,6,7,8\n");
  REQUIRE(scene.parts.size() == 5);
  const auto* const water = std::get_if<PartOf<DeckHexahedron, Fluid<TabulatedEos, Newtonian>>>(&scene.parts[3].item);
  REQUIRE(water);
  CHECK(water->material.viscosity() == .01);
  CHECK(scene.parts[3].material ==
        "Fluid{TabulatedEos{1.5, {{0, 0, 0.25}, {-0.1, 1, 0.5}}, 2, 0.5}, Newtonian{.viscosity = 0.01}}");
  const TabulatedEos written{1.5, {{0, 0, 0.25}, {-0.1, 1, 0.5}}, 2, 0.5};
  for (const double mu : {-.1, 0., .07, .5}) {
    CHECK(water->material.eos.A(mu) == written.A(mu));
    CHECK(water->material.eos.B(mu) == written.B(mu));
  }
  const auto* const clay = std::get_if<PartOf<DeckHexahedron, Solid<TabulatedEos, VonMises>>>(&scene.parts[4].item);
  REQUIRE(clay);
  CHECK(clay->material.eos.pressure_cutoff == -.3);
  CHECK_THAT(scene.parts[4].material, StartsWith("Solid{TabulatedEos{2, {{-0.1, 1}, {0, 0}, {0.1, -0.5}}, 0, 0, -0.3}, "
                                                 "VonMises{.shear_modulus = 1, .yield_stress = 0.1"));
  CHECK(scene.cannot.size() == 1);
  CHECK(has(scene.cannot, "Part 9, steel: hexahedra of Hex8 with Solid are not among the pairs"));
}

TEST_CASE("deck: numbers are written so that they read back as the same") {
  const TabulatedHardening law{1.0 / 3, {{0, 0.1 + 0.2}, {0.1, 0.4}, {2, 0.5}}};
  CHECK(detail::code_of(law) ==
        "TabulatedHardening{0.3333333333333333, {{0, 0.30000000000000004}, {0.1, 0.4}, {2, 0.5}}}");
  CHECK(
      detail::code_of(GruneisenEos{.density = 1, .sound_speed = 2, .S1 = 1.5, .gamma = 2, .pressure_cutoff = -1e-7}) ==
      "GruneisenEos{.density = 1, .sound_speed = 2, .S1 = 1.5, .gamma = 2, .pressure_cutoff = -1e-07}");
}
