// Scenes of decks that run: materials against the same scene written by hand, and walls that end in one direction.
#include <cmath>
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
using testing::has;

namespace {

/// Cubes of one element in a row, each of the material of its number.
DynaDeck cubes(int count, const std::string& cards) {
  std::string nodes = "*NODE\n", cells = "*ELEMENT_SOLID\n", parts;
  for (int i = 0; i < count; ++i) {
    const std::string number = std::to_string(i + 1);
    cells += number + "," + number;
    for (int k = 0; k < 8; ++k) {
      const std::string node = std::to_string(8 * i + k + 1);
      nodes += node + "," + std::to_string(2 * i + (k % 4 == 1 || k % 4 == 2)) + "," + std::to_string(k % 4 / 2) + "," +
               std::to_string(k / 4) + "\n";
      cells += "," + node;
    }
    cells += "\n", parts += "*PART\n\n" + number + ",1," + number + "," + number + "\n";
  }
  return read_dyna(
      "*KEYWORD\n*CONTROL_TERMINATION\n.01\n*SECTION_SOLID\n1,1\n" + nodes + cells + parts + cards + "*END\n", "a.k");
}
/// mm, ms, kg, GPa
const std::string steel = "7.8e-6,200,.25", polymer = "1.1e-6";
const std::string laws = "*MAT_018\n1," + steel + ",.6,.2\n.3\n" +                   //
                         "*MAT_018\n2," + steel + ",.6,.2,.04,5\n.3,1\n" +           //
                         "*MAT_098\n3," + steel + ",1\n.3,.4,.3,.02\n" +             //
                         "*MAT_098\n4," + steel + ",1\n.3,.4,.3,.02,.05\n" +         //
                         "*MAT_006\n5," + polymer + ",2,.5,.1,100\n" +               //
                         "*MAT_076\n6," + polymer + ",2\n\n.2,200\n.2,20\n.1,0\n" +  //
                         "*MAT_027\n7," + polymer + ",.49,5e-4,1e-4\n" +             //
                         "*MAT_065\n8,8.93e-6,47.7,.001,0\n.065,.89,.0028,1.15e-4,0,,,1\n,,,3.83e-4\n\n" +
                         "*EOS_GRUNEISEN\n8,3940,1.49,0,0,1.96\n";

using E = DeckHexahedron;
using Tried = AnyPart<PartOf<E, DeckPower>, PartOf<E, DeckRatePower>, PartOf<E, DeckColdJohnsonCook>,
                      PartOf<E, DeckFailingColdJohnsonCook, Erosion>, PartOf<E, DeckRelaxing>,
                      PartOf<E, Solid<LinearEos, MooneyRivlin>>, PartOf<E, Solid<GruneisenEos, ZerilliArmstrong>>,
                      PartOf<E, Solid<LinearEos, Prony<1>>>, PartOf<E, Solid<LinearEos, Prony<3>>>>;

/// The upper nodes begin with a velocity that stretches and shears the cubes.
auto run_of(const std::vector<Eigen::Vector3d>& nodes, const std::vector<Tried>& parts) {
  std::vector<Index> upper;
  for (Index i = 0; i < nodes.size(); ++i)
    if (nodes[i].z() > 0.5) upper.push_back(i);
  return Explicit{Scene{nodes, parts, InitialVelocity{{10, 0, 20}, upper}}, ExplicitOptions{.print_warnings = false}};
}

}  // namespace

TEST_CASE("deck: power laws, cold Johnson and Cook, rubber, relaxation and Zerilli and Armstrong are those by hand") {
  const DynaDeck deck = cubes(8, laws);
  const DeckScene scene = deck_scene(deck);
  CHECK(scene.cannot == std::vector<std::string>{});
  REQUIRE(scene.parts.size() == 8);
  std::vector<Tried> of_deck;
  for (const StatedPart& part : scene.parts)
    std::visit(
        [&](const auto& one) {
          if constexpr (std::is_constructible_v<Tried, decltype(one)>) of_deck.push_back(one);
        },
        part.item);
  REQUIRE(of_deck.size() == 8);

  const double E0 = 200, nu = .25, G = E0 / (2 * (1 + nu)), K = E0 / (3 * (1 - 2 * nu));
  const LinearEos steel_eos{7.8e-6, K}, polymer_eos{1.1e-6, 2};
  const PowerHardening power{G, .6, .2, std::pow(.3 / .6, 1 / .2)};
  const JohnsonCook cold{.shear_modulus = G, .A = .3, .B = .4, .n = .3, .C = .02};
  const double G_rubber = 2 * (5e-4 + 1e-4);
  std::vector<Tried> by_hand;
  const auto add = [&](const auto& material, const auto&... removal) {
    by_hand.push_back(
        Part{E{}, material, deck.part(static_cast<FileNumber>(by_hand.size() + 1)).hexahedra, removal...});
  };
  add(Solid{steel_eos, power});
  add(Solid{steel_eos, CowperSymonds{power, .04, 5}});
  add(Solid{steel_eos, cold});
  add(Solid{steel_eos, cold, FailureStrain{.05}}, Erosion{});
  add(Solid{polymer_eos, Prony<1>{.5, {{(.5 - .1) / .5, 1. / 100}}}});
  add(Solid{polymer_eos,
            Prony<3>{.2 + .2 + .1, {{.2 / (.2 + .2 + .1), 1. / 200}, {.2 / (.2 + .2 + .1), 1. / 20}, {0, 1}}}});
  add(Solid{LinearEos{1.1e-6, 2 * G_rubber * (1 + .49) / (3 * (1 - 2 * .49))}, MooneyRivlin{.C10 = 5e-4, .C01 = 1e-4}});
  add(Solid{GruneisenEos{.density = 8.93e-6, .sound_speed = 3940, .S1 = 1.49, .gamma = 1.96},
            ZerilliArmstrong{.shear_modulus = 47.7,
                             .C0 = .065,
                             .C2 = .89,
                             .C3 = .0028,
                             .C4 = 1.15e-4,
                             .reference_rate = .001,
                             .heating = 1 / (8.93e-6 * 3.83e-4)}});
  auto run = run_of(scene.nodes, of_deck), other = run_of(scene.nodes, by_hand);
  run.until(.01), other.until(.01);
  CHECK(run.positions() == other.positions());
  CHECK(run.energy().internal == other.energy().internal);
  // Each cube has been strained: a law that did nothing would be no test.
  for (std::size_t i = 0; i < 8; ++i) CHECK((run.positions()[8 * i] - scene.nodes[8 * i]).norm() > 1e-3);
}

TEST_CASE("deck: the code of further materials reads as they would be written") {
  const DeckScene scene = deck_scene(cubes(8, laws));
  const auto code = [&](std::size_t i) { return scene.parts.at(i).material; };
  CHECK_THAT(code(0), ContainsSubstring("PowerHardening{.shear_modulus = 80, .coefficient = 0.6, .exponent = 0.2"));
  CHECK_THAT(code(1), ContainsSubstring("CowperSymonds{PowerHardening{"));
  CHECK_THAT(code(1), ContainsSubstring("}, 0.04, 5}}"));
  CHECK_THAT(code(3), ContainsSubstring("JohnsonCook{"));
  CHECK_THAT(code(3), ContainsSubstring("FailureStrain{.failure_strain = 0.05}"));
  CHECK(code(4) ==
        "Solid{LinearEos{.density = 1.1e-06, .bulk_modulus = 2}, Prony<1>{.shear_modulus = 0.5, .terms = {{0.8, "
        "0.01}}}}");
  CHECK_THAT(code(5), ContainsSubstring("Prony<2>{.shear_modulus = 0.5, .terms = {{0.4, 0.005}, {0.4, 0.05}}}"));
  CHECK_THAT(code(6), ContainsSubstring("MooneyRivlin{.C10 = 5e-04, .C01 = 1e-04"));
  CHECK_THAT(code(7), ContainsSubstring("ZerilliArmstrong{"));
}

TEST_CASE("deck: more terms of relaxation than the program holds are told") {
  std::string terms;
  for (int i = 0; i < 7; ++i) terms += ".1," + std::to_string(i + 1) + "\n";
  const DeckScene scene = deck_scene(cubes(1, "*MAT_076\n1,1e-6,2\n\n" + terms));
  CHECK(has(scene.cannot, "Part 1 is left out: its material has 7 terms of relaxation, and this program holds 6."));
  CHECK(scene.parts.empty());
}

TEST_CASE("deck: a wall that ends in one direction stops what falls on it, and what falls beside it falls on") {
  const auto cube_at = [](double x, double y) {
    std::string nodes = "*NODE\n";
    for (int k = 0; k < 8; ++k)
      nodes += std::to_string(k + 1) + "," + std::to_string(x + (k % 4 == 1 || k % 4 == 2)) + "," +
               std::to_string(y + k % 4 / 2) + "," + std::to_string(k / 4 + 0.01) + "\n";
    const DeckScene scene = deck_scene(read_dyna(
        "*KEYWORD\n*CONTROL_TERMINATION\n1\n" + nodes +
            "*ELEMENT_SOLID\n1,1,1,2,3,4,5,6,7,8\n*PART\n\n1,1,1\n*SECTION_SOLID\n1,1\n*MAT_ELASTIC\n1,1,1e4,0\n"
            "*RIGIDWALL_PLANAR_FINITE\n0\n0,0,0,0,0,1\n1,0,0,0,5\n*INITIAL_VELOCITY\n\n0,0,-1\n*END\n",
        "a.k"));
    REQUIRE(scene.cannot.empty());
    Explicit run{Scene{scene.nodes, std::get<PartOf<DeckHexahedron, Elastic>>(scene.parts.at(0).item),
                       std::get<DeckContactWith<RigidSurface>>(scene.obstacles.at(0).item),
                       scene.velocities.at(0).item}};
    run.until(1);  // the wave, as fast as 100, has gone there and back
    return run.positions()[0].z();
  };
  CHECK(cube_at(2, 2) > 0);
  CHECK(cube_at(-20, 2) > 0);  // the wall has no end along x
  CHECK(cube_at(40, 2) > 0);
  CHECK(cube_at(2, 7) == Approx(-0.99));
}
