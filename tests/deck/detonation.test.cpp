// Detonations of decks: where they start, when the front arrives in a run, and what is told.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
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

using Charge = Explosive<Jwl, DetonationPoints>;
using ChargePart = PartOf<DeckHexahedron, Charge>;

/// The deck of tests/deck/charge.k, some of whose text is another one.
std::string charge(const std::vector<std::pair<std::string, std::string>>& changes = {}) {
  std::ifstream file(std::filesystem::path(__FILE__).parent_path() / "charge.k");
  std::string text{std::istreambuf_iterator<char>(file), {}};
  for (const auto& [from, to] : changes) {
    const std::size_t at = text.find(from);
    REQUIRE(at != text.npos);
    text.replace(at, from.size(), to);
  }
  return text;
}
DeckScene scene_of(const std::string& deck) { return deck_scene(read_dyna(deck, "charge.k")); }
const std::string starts = "1,0.0,0.5,0.5,0.0\n0,24.0,0.5,0.5,0.001\n";

}  // namespace

TEST_CASE("deck: an explosive is lit where the cards of its part, and those of all, say") {
  const DeckScene scene = scene_of(charge());
  CHECK(scene.cannot == std::vector<std::string>{});
  REQUIRE(scene.parts.size() == 1);
  const auto* const part = std::get_if<ChargePart>(&scene.parts[0].item);
  REQUIRE(part);
  CHECK(part->cells.size() == 24);
  CHECK(part->material.products.initial_energy == 7);
  CHECK(part->material.density() == 1.63e-6);
  CHECK(part->material.burn.pressure_CJ == 21);
  CHECK(part->material.burn.front_width == Approx(3).epsilon(1e-14));  // of cubes of edge 1
  CHECK(part->material.ignition.points().size() == 2);
  CHECK(has(scene.replaced, "Part 1: the burning front is 3 wide, three elements"));
  CHECK_THAT(scene.parts[0].material,
             ContainsSubstring(", DetonationPoints{{{{0, 0.5, 0.5}, 0}, {{24, 0.5, 0.5}, 0.001}}}, Burn{"));
  CHECK_THAT(program_of(scene, "charge.k", "charge"),
             ContainsSubstring("Part{Hex8{ViscousHourglass{}}, charge_1, deck.part(1).hexahedra}"));
}

TEST_CASE("deck: what lights nothing, and explosives without products or of other cells, are told") {
  const DeckScene everywhere = scene_of(charge({{"*INITIAL_DETONATION\n" + starts, ""}}));
  CHECK(everywhere.cannot == std::vector<std::string>{});
  CHECK(has(everywhere.becomes, "no *INITIAL_DETONATION lights it, so that all of it burns from the time 0"));
  CHECK_THAT(everywhere.parts.at(0).material, ContainsSubstring("DetonationPoints{}, "));

  const DeckScene other = scene_of(charge(
      {{starts, starts + "7,1.0,2.0,3.0\n"}, {"*NODE", "*PART\nb\n7,1,1,1\n*NODE"}, {"2,1,5,6,7", "2,7,5,6,7"}}));
  CHECK(std::get<ChargePart>(other.parts.at(0).item).material.ignition.points().size() == 2);
  CHECK(std::get<ChargePart>(other.parts.at(1).item).material.ignition.points().size() == 2);  // of 0 and of 7
  CHECK(other.cannot == std::vector<std::string>{});
  const std::string inert = "*MAT_HIGH_EXPLOSIVE_BURN\n1,1.63E-6,6930.0,21.0\n";
  const DeckScene none = scene_of(charge({{inert, "*MAT_ELASTIC\n1,1.63E-6,200.0\n"}}));
  CHECK(has(none.cannot, "*INITIAL_DETONATION at {0, 0.5, 0.5} lights nothing: part 1, which is not of"));
  CHECK(has(none.cannot, "*INITIAL_DETONATION at {24, 0.5, 0.5} lights nothing: no part of"));
  const DeckScene products = scene_of(charge({{"1,1,1,1\n", "1,1,1,0\n"}}));
  CHECK(products.parts.empty());
  CHECK(has(products.cannot, "*MAT_HIGH_EXPLOSIVE_BURN has no material here, or lacks its equation of state"));
  CHECK(has(scene_of(charge({{starts, "-1,1.0,2.0,3.0\n4.0,5.0\n" + starts}})).cannot, "PID below 0"));
  CHECK(has(scene_of(charge({{starts, "1,0.0,0.5,0.5,0.0,0.0,3\n"}})).cannot, "Further fields of *INITIAL_DETONATION"));
  CHECK(has(scene_of(charge({{"*NODE", "*CONTROL_EXPLOSIVE_SHADOW\n1\n*NODE"}})).cannot, "*CONTROL_EXPLOSIVE_SHADOW"));
}

TEST_CASE("deck: the fronts of a charge arrive at distance/D, wherever it lies") {
  const double D = 6930, w = 3, late = 1e-3;
  // BETA 2: burnt by the front alone. With BETA 0 compression burns too, never before the front.
  const bool compresses = GENERATE(false, true);
  const std::string beta = compresses ? "21.0,0.0" : "21.0,2.0";
  const DeckScene scene = scene_of(charge({{"21.0", beta}}));
  std::vector<Support> supports;
  for (const auto& one : scene.supports) supports.push_back(one.item);
  Explicit run{Scene{scene.nodes, std::get<ChargePart>(scene.parts.at(0).item), supports}, scene.options};
  double last = 0;
  std::size_t ahead = 0;
  while (run.time() < scene.end) {
    run.step();
    const auto burnt = run.part<0>().field([](const auto& state) { return state.burnt; });
    const auto pressure = run.part<0>().field([](const auto& state) { return state.pressure; });
    for (std::size_t i = 0; i < 24; ++i) {
      const double x = static_cast<double>(i) + 0.5, lit = std::min(x / D, late + (24 - x) / D);
      const double by_front = std::clamp(D * (run.time() - lit) / w, 0.0, 1.0);
      if (compresses)
        REQUIRE(burnt[i] >= by_front - 1e-9);  // rounding of the sum of steps
      else
        REQUIRE(burnt[i] == Approx(by_front).margin(1e-9));
      if (run.time() < lit - 0.5 / D) ahead += pressure[i] == 0;
      if (!compresses && run.time() < lit) REQUIRE(pressure[i] == 0);
    }
    last = run.time();
  }
  CHECK(ahead > 100);
  CHECK(last == Approx(scene.end).epsilon(0.02));
  CHECK(std::abs(run.energy().error()) < 5e-3);  // as that of a slab in problems/detonation
}
