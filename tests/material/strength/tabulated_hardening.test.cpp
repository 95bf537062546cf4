#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <strike/material/eos/linear.hpp>
#include <strike/material/plane_stress.hpp>
#include <strike/material/solid.hpp>
#include <strike/material/strength/cowper_symonds.hpp>
#include <strike/material/strength/rate_von_mises.hpp>
#include <strike/material/strength/strength.hpp>
#include <strike/material/strength/tabulated_hardening.hpp>
#include <strike/material/strength/von_mises.hpp>

#include "support/catch.hpp"

using namespace strike;

static_assert(RateIndependentFlow<TabulatedHardening> && RateDependentFlow<CowperSymonds<TabulatedHardening>>);
static_assert(!RateIndependentFlow<CowperSymonds<TabulatedHardening>>);

namespace {
constexpr double G = 80e9;
using Points = std::vector<TabulatedHardening::Point>;

std::string refused(const Points& points) {
  try {
    TabulatedHardening{G, points};
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}
}  // namespace

TEST_CASE("tabulated hardening: straight between the points, level after the last, and back to it from any step") {
  // rises, falls almost as steeply as 3 G, is level, rises
  const Points points{{0, 400e6}, {.02, 500e6}, {.0205, 400e6}, {.1, 400e6}, {.5, 700e6}};
  const TabulatedHardening law{G, points};
  CHECK(!law.warning().empty());
  for (const auto& [strain, stress] : points) CHECK(law.flow_stress(strain) == stress);
  CHECK(law.flow_stress(.01) == Approx(450e6).epsilon(1e-15));
  CHECK(law.flow_stress(.3) == Approx(550e6).epsilon(1e-15));
  CHECK(law.flow_stress(7.0) == 700e6);

  for (const double e : {0.0, .019, .0202, .05, .4999, 3.0})
    for (const double dl : {1e-12, 1e-6, 4e-4, 1e-3, .3, 2.0}) {
      const double sigma = law.flow_stress(e + dl), q = sigma + 3 * G * dl;
      const double found = law.plastic_increment(q, e, 1.0);
      CHECK(std::abs(found - dl) <= 1e-14 * q / (3 * G + -200e9));  // the roundings over the least slope
      CHECK(law.plastic_increment(law.flow_stress(e), e, 1.0) == 0);
      CHECK(law.plastic_increment(.5 * law.flow_stress(e), e, 1.0) == 0);
    }
}

TEST_CASE("tabulated hardening: two points are linear hardening, and with Cowper and Symonds' factor RateVonMises") {
  const TabulatedHardening table{G, {{0, 300e6}, {1, 1300e6}}};
  CHECK(table.warning().empty());
  const VonMises linear{.shear_modulus = G, .yield_stress = 300e6, .hardening_modulus = 1e9};
  const CowperSymonds rated{table, 40.4, 5};
  const RateVonMises closed{.shear_modulus = G,
                            .yield_stress = 300e6,
                            .hardening_modulus = 1e9,
                            .rate_factor = std::pow(40.4, -.2),
                            .rate_exponent = .2};
  CHECK(rated.flow_stress(.5, 40.4) == Approx(1600e6).epsilon(1e-15));
  for (const double q : {299e6, 310e6, 500e6, 5e9}) {
    CHECK(table.plastic_increment(q, .01, 1.0) == Approx(linear.plastic_increment(q, .01, 1.0)).epsilon(1e-14));
    const StrengthState<CowperSymonds<TabulatedHardening>, double> state{.01};
    CHECK(std::abs(plastic_increment<CowperSymonds<TabulatedHardening>, double>(rated, state, q, 1e-7) -
                   closed.plastic_increment(q, .01, 1e-7)) < 1e-14 * q / (3 * G));
  }
}

TEST_CASE("tabulated hardening: in plane stress too every step ends on the table, however many points it passes") {
  const TabulatedHardening law{G, {{0, 90e6}, {.001, 150e6}, {.002, 155e6}, {.003, 220e6}, {.01, 180e6}, {.3, 310e6}}};
  const PlaneStress sheet{Solid{LinearEos{.density = 1, .bulk_modulus = 160e9}, law}};
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto u = [&] { return unit(random); };
  for (int path = 0; path < 500; ++path) {
    decltype(sheet)::State<double> state;
    for (int i = 0; i < 5; ++i) {
      const double e = state.equivalent_plastic_strain, size = std::pow(10, -3 + u());
      sheet.stress(state, {{size * u(), size * u(), size * u()}}, 1.0);
      if (state.equivalent_plastic_strain > e)
        CHECK(equivalent_stress(state.stress) ==
              Approx(law.flow_stress(state.equivalent_plastic_strain)).epsilon(5e-14));
    }
  }
}

TEST_CASE("tabulated hardening: what no table can be is refused in one sentence") {
  CHECK(refused({}).find("no points") != std::string::npos);
  CHECK(refused({{.002, 400e6}}).find("start at 0") != std::string::npos);
  CHECK(refused({{0, 400e6}, {.1, 500e6}, {.1, 600e6}}).find("point 2") != std::string::npos);
  CHECK(refused({{0, 400e6}, {.1, -1}}).find("must be zero or positive") != std::string::npos);
  CHECK(refused({{0, 400e6}, {.1, std::nan("")}}).find("must be zero or positive") != std::string::npos);
  CHECK(refused({{0, 400e6}, {.1, 500e6}, {.101, 100e6}}).find("more than 0.00166667") != std::string::npos);
}
