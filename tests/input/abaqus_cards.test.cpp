#include <cmath>
#include <string>

#include <strike/input/abaqus.hpp>

#include "support/catch.hpp"

using namespace strike;
using Catch::Matchers::ContainsSubstring;

namespace {

AbaqusDeck read(const std::string& text) { return read_abaqus(text, "a.inp"); }

/// Two bricks on each other, a tetrahedron on top of them, and a plate.
const std::string mesh =
    "*NODE, NSET=all\n1,0,0,0\n2,1,0,0\n3,1,1,0\n4,0,1,0\n5,0,0,1\n6,1,0,1\n7,1,1,1\n8,0,1,1\n9,0,0,2\n10,1,0,2\n"
    "11,1,1,2\n12,0,1,2\n13,0,0,3\n21,5,0,0\n22,6,0,0\n23,6,1,0\n24,5,1,0\n"
    "*ELEMENT, TYPE=C3D8R, ELSET=bar\n1,1,2,3,4,5,6,7,8\n2,5,6,7,8,9,10,11,12\n*ELEMENT, TYPE=C3D4, ELSET=tip\n"
    "3,9,10,12,13\n*ELEMENT, TYPE=S4R, ELSET=plate\n4,21,22,23,24\n*NSET, NSET=foot\n1,2,3,4\n";
AbaqusDeck with(const std::string& text) { return read(mesh + text); }
void refused(const std::string& text, const std::string& sentence) {
  CHECK_THROWS_WITH(with(text), ContainsSubstring("strike: the file 'a.inp', line ") && ContainsSubstring(sentence));
}
const std::string section = "*SOLID SECTION, ELSET=BAR, MATERIAL=steel\n1.,\n*MATERIAL, NAME=Steel\n*DENSITY\n8e3,\n";

/// The integral of the normal over segments, and that of (x, n)/3: the enclosed volume.
struct Measured {
  Eigen::Vector3d area = Eigen::Vector3d::Zero();
  double volume = 0;
};
Measured measured(const AbaqusDeck& deck, const std::vector<std::array<Index, 4>>& segments) {
  Measured m;
  for (const auto& c : segments) {
    const auto& x = deck.mesh.nodes;
    const Eigen::Vector3d a = x[c[2]] - x[c[0]], b = x[c[3]] - x[c[1]], n = 0.5 * cross(a, b);
    m.area += n;
    m.volume += n.dot(x[c[0]]) / 3;  // flat faces
  }
  return m;
}

}  // namespace

TEST_CASE("abaqus cards: elastic and plastic materials, by the section of their part") {
  const AbaqusDeck deck = with(section + "*ELASTIC\n2e11, .25\n");
  const Elastic& elastic = deck.material<Elastic>("bar");
  CHECK(elastic.density == 8e3);
  CHECK(elastic.youngs_modulus == 2e11);
  CHECK(elastic.poissons_ratio == .25);
  CHECK(deck.eos<LinearEos>("bar").bulk_modulus == Approx(2e11 / (3 * (1 - 2 * .25))));
  CHECK_THROWS_WITH(deck.material<PlasticMaterial>("bar"),
                    ContainsSubstring("'Steel' of part 'bar' is of another type"));
  CHECK_THROWS_WITH(deck.section("plate"), ContainsSubstring("no section covers the part 'plate'"));
  CHECK(deck.warnings.empty());

  const AbaqusDeck perfect =
      with(section + "*ELASTIC\n2e11, .25\n*PLASTIC\n3e8, 0.\n*RATE DEPENDENT, TYPE=POWER LAW\n40., 5.\n");
  const RateVonMises& law = perfect.material<PlasticMaterial>("bar").strength;
  CHECK(law.shear_modulus == 8e10);
  CHECK(law.yield_stress == 3e8);
  CHECK(law.hardening_modulus == 0);
  CHECK(1 + law.rate_factor * std::pow(40., law.rate_exponent) == Approx(2));  // D doubles the stress

  const AbaqusDeck table = with(section + "*PLASTIC\n3e8, 0.\n4e8, .1\n4.5e8, .5\n*ELASTIC\n2e11, .25\n");
  const auto& hardening = table.material<TabulatedMaterial>("bar");
  CHECK(hardening.strength.flow_stress(0.05) == Approx(3.5e8));
  CHECK(hardening.strength.flow_stress(0.9) == Approx(4.5e8));
  CHECK(hardening.eos.density == 8e3);
  CHECK_FALSE(hardening.rate);
}

TEST_CASE("abaqus cards: Johnson and Cook's law heats in an adiabatic step alone") {
  const std::string law =
      section +
      "*ELASTIC\n1.24e11, .34\n*PLASTIC, HARDENING=JOHNSON COOK\n9e7, 2.92e8, .31, 1.09, 1356., 298.\n"
      "*RATE DEPENDENT, TYPE=JOHNSON COOK\n.025, 2.\n*SPECIFIC HEAT\n383.,\n*INELASTIC HEAT FRACTION\n.8,\n";
  const AbaqusDeck cold = with(law + "*STEP\n*DYNAMIC, EXPLICIT\n, 8e-5\n*END STEP\n");
  const JohnsonCook& s = cold.material<JohnsonCookMaterial>("bar").strength;
  CHECK(s.A == 9e7);
  CHECK(s.B == 2.92e8);
  CHECK(s.n == .31);
  CHECK(s.m == 1.09);
  CHECK(s.melting_temperature == 1356);
  CHECK(s.initial_temperature == 298);
  CHECK(s.C == .025);
  CHECK(s.reference_rate == 2);
  CHECK(s.heating == 0);
  CHECK(cold.end_time == 8e-5);
  const AbaqusDeck hot = with(law + "*STEP\n*DYNAMIC, EXPLICIT, ADIABATIC\n, 8e-5\n*END STEP\n");
  CHECK(hot.material<JohnsonCookMaterial>("bar").strength.heating == Approx(.8 / (8e3 * 383)));
}

TEST_CASE("abaqus cards: equations of state") {
  const AbaqusDeck fluid = with(section + "*EOS, TYPE=USUP\n1483., 1.75, .28\n*VISCOSITY\n1e-3,\n");
  CHECK(fluid.material<NullMaterial>("bar").viscosity == 1e-3);
  const auto& eos = fluid.eos<GruneisenEos>("bar");
  CHECK(eos.density == 8e3);
  CHECK(eos.sound_speed == 1483);
  CHECK(eos.S1 == 1.75);
  CHECK(eos.gamma == .28);
  const AbaqusDeck metal =
      with(section + "*EOS, TYPE=USUP\n3940., 1.49, 2.\n*ELASTIC, TYPE=SHEAR\n4.7e10,\n*PLASTIC\n1e8\n");
  CHECK(metal.material<HydroMaterial>("bar").strength.shear_modulus == 4.7e10);
  CHECK(metal.material<HydroMaterial>("bar").strength.yield_stress == 1e8);
  const AbaqusDeck charge = with(section + "*EOS, TYPE=JWL\n6930., 3.7e11, 3.2e9, .3, 4.15, .95, 4e6\n");
  const auto& jwl = charge.eos<Jwl>("bar");
  CHECK(jwl.omega == .3);
  CHECK(jwl.R2 == .95);
  CHECK(jwl.initial_energy == 8e3 * 4e6);  // per volume
  CHECK(charge.named_material("bar").detonation_speed == 6930);
}

TEST_CASE("abaqus cards: a material that has no counterpart is told, and is not in the deck") {
  const auto told = [](const std::string& text, const std::string& why) {
    const AbaqusDeck deck = with(section + text);
    CHECK(deck.materials.empty());
    REQUIRE(deck.warnings.size() == 1);
    CHECK_THAT(deck.warnings[0],
               ContainsSubstring("Material 'Steel' on line 30 was not read: ") && ContainsSubstring(why));
    CHECK_THROWS_WITH(deck.material<Elastic>("bar"), ContainsSubstring("names the material 'steel', which is not in"));
  };
  told("", "it has neither *ELASTIC nor *EOS.");
  told("*ELASTIC\n2e11, .3, 20.\n1e11, .3, 400.\n", "*ELASTIC with several lines on line 33 has no counterpart.");
  told("*ELASTIC, TYPE=ORTHOTROPIC\n1,2,3\n", "*ELASTIC with TYPE=ORTHOTROPIC on line 33");
  told("*ELASTIC\n2e11, .3\n*PLASTIC, HARDENING=KINEMATIC\n1,0\n", "*PLASTIC with HARDENING=KINEMATIC on line 35");
  told("*ELASTIC\n2e11, .3\n*PLASTIC, RATE=10\n1,0\n", "*PLASTIC with RATE on line 35");
  told("*ELASTIC\n2e11, .3\n*PLASTIC\n1,0,20\n.5,0,300\n", "*PLASTIC with several temperatures");
  told("*ELASTIC\n2e11, .3\n*PLASTIC\n2,0\n1,.1\n1,.05\n", "sort the points by their strain");
  told("*HYPERELASTIC, NEO HOOKE\n1,2\n", "*HYPERELASTIC on line 33 has no counterpart.");
  told("*EOS, TYPE=IDEALGAS\n1,2\n", "*EOS with TYPE=IDEALGAS on line 33");
  told("*PLASTIC\n1,0\n", "it has neither *ELASTIC nor *EOS.");
  const AbaqusDeck damaged = with(section + "*ELASTIC\n2e11,.3\n*DAMAGE INITIATION, CRITERION=DUCTILE\n.1\n");
  CHECK(damaged.materials.size() == 1);
  CHECK(damaged.warnings == std::vector<std::string>{"*DAMAGE INITIATION (1) was skipped: line 35."});
  refused(section + "*ELASTIC\n2e11, .5\n", "line 34: Poisson's ratio is not between -1 and 0.5");
  refused("*MATERIAL, NAME=a\n*MATERIAL, NAME=A\n", "material 'A' is there twice");
  refused("*SOLID SECTION, ELSET=none, MATERIAL=m\n", "the set of elements 'none' is not in the file");
}

TEST_CASE("abaqus cards: the section of a plate, and of the parts of an assembly") {
  const auto reference = [](const std::string& offset) {
    return with("*SHELL SECTION, ELSET=plate, MATERIAL=m" + offset + "\n2e-3, 3\n").section("plate").section.reference;
  };
  const AbaqusDeck deck = with("*SHELL SECTION, ELSET=plate, MATERIAL=m\n2e-3\n");
  CHECK(deck.section("plate").section.thickness == 2e-3);
  CHECK(deck.section("plate").section.points == 5);
  CHECK(reference("") == 0);
  CHECK(reference(", OFFSET=SPOS") == 1);
  CHECK(reference(", OFFSET=SNEG") == -1);
  CHECK(reference(", OFFSET=0.25") == 0.5);
  refused("*SHELL SECTION, ELSET=plate, MATERIAL=m\n0.\n", "the thickness is not positive");

  const AbaqusDeck two = read("*PART, NAME=p\n" + mesh +
                              "*SOLID SECTION, ELSET=bar, MATERIAL=m\n*SURFACE, NAME=end\nbar, S1\n"
                              "*END PART\n*ASSEMBLY, NAME=a\n*INSTANCE, NAME=i, PART=p\n*END INSTANCE\n"
                              "*INSTANCE, NAME=j, PART=p\n0,0,9\n*END INSTANCE\n*END ASSEMBLY\n"
                              "*MATERIAL, NAME=M\n*DENSITY\n1,\n*ELASTIC\n1,\n*BOUNDARY\nj.foot, ENCASTRE\ni.1, 2\n");
  CHECK(two.material<Elastic>("i.bar").density == 1);
  CHECK(two.material<Elastic>("j.bar").density == 1);
  CHECK(two.supports.at(0).nodes == std::vector<Index>{17, 18, 19, 20});
  CHECK(two.supports.at(1).nodes == std::vector<Index>{0});
  CHECK(two.surface("j.end").side.segments.size() == 2);
}

TEST_CASE("abaqus cards: supports, motions and amplitudes") {
  const AbaqusDeck deck = with(
      "*AMPLITUDE, NAME=ramp\n0., 0., 1e-3, 1.,\n2e-3, 1., 5e-3, 0.\n*BOUNDARY\nfoot, XSYMM\n5, PINNED\n6, 2, 3\nFoot, "
      "6\n"
      "*STEP\n*DYNAMIC, EXPLICIT\n, 1.\n*BOUNDARY, AMPLITUDE=Ramp, TYPE=VELOCITY\nfoot, 3, 3, -4.\n*BOUNDARY\n"
      "7, 5, , .1\n*END STEP\n*STEP\n*BOUNDARY\n8, ENCASTRE\n*END STEP\n");
  REQUIRE(deck.supports.size() == 4);
  CHECK(deck.supports[0].nodes.size() == 4);
  CHECK(deck.supports[0].held == std::array{true, false, false});
  CHECK(deck.supports[0].held_turns == std::array{false, true, true});
  CHECK(deck.supports[1].held == std::array{true, true, true});
  CHECK(deck.supports[2].held == std::array{false, true, true});
  CHECK(deck.supports[3].held_turns == std::array{false, false, true});
  REQUIRE(deck.motions.size() == 2);
  CHECK(deck.motions[0].kind == MotionCard::Kind::velocity);
  CHECK(deck.motions[0].direction == Eigen::Vector3d(0, 0, 1));
  CHECK(deck.motions[0].value == -4);
  CHECK(deck.curve(deck.motions[0].amplitude).points ==
        std::vector<std::array<double, 2>>{{0, 0}, {1e-3, 1}, {2e-3, 1}, {5e-3, 0}});
  CHECK(deck.motions[1].kind == MotionCard::Kind::displacement);
  CHECK(deck.motions[1].turns);
  CHECK(deck.motions[1].direction == Eigen::Vector3d(0, 1, 0));
  CHECK(deck.warnings == std::vector<std::string>{"*BOUNDARY of a further step (1) was skipped: line 45."});
  refused("*BOUNDARY\nnone, 1\n", "line 29: the set of nodes 'none' is not in the file");
  refused("*BOUNDARY\n99, 1\n", "node 99 is not in the file");
  refused("*BOUNDARY\nfoot, FIXED\n", "the boundary condition 'FIXED' is not known");
  refused("*BOUNDARY\nfoot, 3, 1\n", "the degrees of freedom end before they begin");
  refused("*BOUNDARY, AMPLITUDE=none\nfoot, 1, 1, 2.\n", "the amplitude 'none' is not in the file");
  refused("*AMPLITUDE, NAME=a\n1, 0, 0, 1\n", "the times of the amplitude 'a' fall");
  const AbaqusDeck smooth =
      with("*AMPLITUDE, NAME=a, DEFINITION=SMOOTH STEP\n0,0,1,1\n*BOUNDARY, AMPLITUDE=a\nfoot,1,1,2.\n");
  CHECK(smooth.warnings == std::vector<std::string>{"*AMPLITUDE with DEFINITION=SMOOTHSTEP (1) was skipped: line 28."});
  CHECK_THROWS_AS(smooth.curve("a"), Error);
}

TEST_CASE("abaqus cards: velocities of a node are those of its last lines") {
  const AbaqusDeck deck = with(
      "*INITIAL CONDITIONS, TYPE=VELOCITY\nall, 3, -200.\nfoot, 1, 5.\n1, 3, 7.\n"
      "*INITIAL CONDITIONS, TYPE=TEMPERATURE\nall, 300.\n");
  REQUIRE(deck.velocities.size() == 3);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  std::size_t count = 0;
  for (const VelocityCard& card : deck.velocities) {
    sum += double(card.nodes.size()) * card.velocity;
    count += card.nodes.size();
  }
  CHECK(count == deck.mesh.nodes.size());
  CHECK(sum == Eigen::Vector3d(4 * 5., 0, -200. * 16 + 7));
  CHECK(deck.warnings == std::vector<std::string>{"*INITIAL CONDITIONS, TYPE=TEMPERATURE (1) was skipped: line 32."});
}

TEST_CASE("abaqus cards: faces of elements look outward, free ones enclose the body") {
  const AbaqusDeck deck = with(
      "*SURFACE, NAME=skin\nbar\n*SURFACE, NAME=tip\ntip, \n*SURFACE, NAME=plate\nplate, SNEG\n*SURFACE, TYPE=NODE, "
      "NAME=n\nfoot\n7,\n");
  const Measured skin = measured(deck, deck.surface("SKIN").side.segments);
  CHECK(deck.surface("skin").side.segments.size() == 10);  // of 12 faces two lie on each other
  CHECK(skin.area.norm() < 1e-14);
  CHECK(skin.volume == Approx(2));
  CHECK(measured(deck, deck.surface("tip").side.segments).volume == Approx(1. / 6));
  CHECK(measured(deck, deck.surface("plate").side.segments).area == Eigen::Vector3d(0, 0, -1));
  CHECK(deck.surface("n").side.nodes.size() == 5);
  const std::array<Eigen::Vector3d, 6> outward{{{0, 0, -1}, {0, 0, 1}, {0, -1, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}}};
  for (int f = 0; f < 6; ++f) {
    const AbaqusDeck one = with("*SURFACE, NAME=s\n1, S" + std::to_string(f + 1) + "\n");
    CHECK(measured(one, one.surface("s").side.segments).area == outward[std::size_t(f)]);
  }
  double volume = 0;
  for (int f = 1; f < 5; ++f) {
    const AbaqusDeck one = with("*SURFACE, NAME=s\ntip, S" + std::to_string(f) + "\n");
    volume += measured(one, one.surface("s").side.segments).volume;
  }
  CHECK(volume == Approx(1. / 6));
  refused("*SURFACE, NAME=s\ntip, S5\n", "element 3 has no face S5: give one of S1 to S4");
  refused("*SURFACE, NAME=s\nbar, SPOS\n", "element 1 has no face SPOS");
  refused("*SURFACE, NAME=s\nbar, E1\n", "the face 'E1' is none of S1 to S6");
  refused("*SURFACE, NAME=s\nnone\n", "line 29: the set of elements 'none' is not in the file");
  refused("*SURFACE, NAME=s\nbar\n*SURFACE, NAME=S\nbar\n", "the surface 'S' is there twice");
}

TEST_CASE("abaqus cards: loads") {
  const AbaqusDeck deck = with(
      "*AMPLITUDE, NAME=a\n0,1\n*SURFACE, NAME=top\ntip, S3\n*STEP\n*DLOAD, AMPLITUDE=a\nbar, P1, 3.\nplate, P, 2.\n"
      ", GRAV, 9.81, 0, 0, -2.\nbar, BX, 1.\n*DSLOAD\ntop, P, 4.\n*CLOAD\nfoot, 2, -5.\n1, 4, 1.\n*BULK "
      "VISCOSITY\n.1,\n*END STEP\n");
  REQUIRE(deck.pressures.size() == 3);
  CHECK(measured(deck, deck.pressures[0].segments).area == Eigen::Vector3d(0, 0, -2));
  CHECK(deck.pressures[0].amplitude == "a");
  CHECK(measured(deck, deck.pressures[1].segments).area == Eigen::Vector3d(0, 0, -1));  // pushes along the normal
  CHECK(deck.pressures[2].value == 4);
  CHECK(deck.pressures[2].segments.size() == 1);
  CHECK(deck.gravities.at(0).acceleration == Eigen::Vector3d(0, 0, -9.81));
  CHECK(deck.gravities.at(0).set.empty());
  CHECK(deck.forces.at(0).force == Eigen::Vector3d(0, -5, 0));
  CHECK(deck.forces.at(0).nodes.size() == 4);
  CHECK(deck.bulk_viscosity == std::array{1.2, .1});
  CHECK(deck.warnings == std::vector<std::string>{"*DLOAD BX (1) was skipped: line 37.",
                                                  "a moment of *CLOAD (1) had no effect: line 42."});
  refused("*DSLOAD\nnone, P, 1\n", "the surface 'none' has no faces, or is not in the file");
  refused("*DLOAD\nbar, GRAV, 1\n", "GRAV has no direction");
}

TEST_CASE("abaqus cards: contact of pairs and of all") {
  const std::string surfaces =
      "*SURFACE, NAME=a\nbar\n*SURFACE, NAME=b\nplate, SPOS\n*SURFACE INTERACTION, NAME=rough\n*FRICTION\n.3,\n"
      "*SURFACE INTERACTION, NAME=fading\n*FRICTION, EXPONENTIAL DECAY\n.3, .1, 2.\n";
  const AbaqusDeck pair = with(surfaces + "*CONTACT PAIR, INTERACTION=Fading\na, B\n");
  REQUIRE(pair.contacts.size() == 1);
  CHECK(pair.contacts[0].kind == "PAIR");
  CHECK(pair.contacts[0].slave.segments.size() == 10);
  CHECK(pair.contacts[0].master.segments.size() == 1);
  CHECK(pair.contacts[0].static_friction == .3);
  CHECK(pair.contacts[0].dynamic_friction == .1);
  CHECK(pair.contacts[0].decay == 2);
  const AbaqusDeck all =
      with(surfaces + "*CONTACT\n*CONTACT INCLUSIONS, ALL EXTERIOR\n*CONTACT PROPERTY ASSIGNMENT\n , , rough\n");
  REQUIRE(all.contacts.size() == 1);
  CHECK(all.contacts[0].kind == "INCLUSIONS");
  CHECK(all.contacts[0].slave.segments.empty());
  CHECK(all.contacts[0].dynamic_friction == .3);
  const AbaqusDeck some = with(surfaces + "*CONTACT INCLUSIONS\na, b\na,\n*CONTACT PROPERTY ASSIGNMENT\na, b, rough\n");
  CHECK(some.contacts.at(0).static_friction == .3);
  CHECK(some.contacts.at(1).static_friction == 0);
  refused("*CONTACT PAIR\na, b\n", "line 29: the surface 'a' is not in the file, or was skipped");
  refused(surfaces + "*CONTACT PAIR, INTERACTION=none\na, b\n", "the interaction 'NONE' is not in the file");
}
