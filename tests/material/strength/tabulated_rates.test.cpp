#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <strike/material/eos/linear.hpp>
#include <strike/material/plane_stress.hpp>
#include <strike/material/solid.hpp>
#include <strike/material/strength/strength.hpp>
#include <strike/material/strength/tabulated_hardening.hpp>
#include <strike/material/strength/tabulated_rates.hpp>
#include <strike/scalar/dual.hpp>
#include <strike/scalar/pack.hpp>

#include "support/catch.hpp"

using namespace strike;
using Catch::Matchers::ContainsSubstring;

static_assert(RateDependentFlow<TabulatedRates> && !RateIndependentFlow<TabulatedRates>);
static_assert(detail::FoundByCurve<TabulatedRates, double> && RateDependentFlow<TabulatedRates, Pack<float, 8>>);

namespace {
constexpr double G = 80e9;
using Tests = std::vector<TabulatedRates::Test>;
using Between = TabulatedRates::Between;
const std::vector<TabulatedRates::Point> slow{{0, 400e6}, {.02, 450e6}, {.1, 440e6}}, fast{{0, 520e6}, {.05, 600e6}};
const Tests tests{{1e-2, slow}, {1e2, fast}, {1e4, {{0, 800e6}}}};

double increment(const TabulatedRates& law, double e, double q, double dt) {
  return plastic_increment<TabulatedRates, double>(law, {e}, q, dt);
}
}  // namespace

TEST_CASE("tabulated rates: at each rate its test, between two of them straight in the rate or in its logarithm") {
  for (const Between between : {Between::rates, Between::logarithms}) {
    const TabulatedRates law{G, tests, between};
    for (const double e : {0.0, .01, .02, .03, .05, .07, .1, .2, 3.0}) {
      double slower = TabulatedHardening{G, slow}.flow_stress(e);
      CHECK(law.flow_stress(e, 0.0) == slower);
      CHECK(law.flow_stress(e, 1e-3) == slower);
      double rate = 1e-2;
      for (const auto& [next, points] : tests) {
        const double stress = TabulatedHardening{G, points}.flow_stress(e);
        CHECK(law.flow_stress(e, next) == Approx(stress).epsilon(1e-14));
        const double middle = between == Between::rates ? .5 * (rate + next) : std::sqrt(rate * next);
        CHECK(law.flow_stress(e, middle) == Approx(.5 * (slower + stress)).epsilon(1e-14));
        slower = stress, rate = next;
      }
      CHECK(law.flow_stress(e, 1e9) == 800e6);
    }
  }
  CHECK(TabulatedRates{G, {{0, slow}, {100, fast}}}.flow_stress(.05, 25.0) ==
        Approx(.75 * 446.25e6 + .25 * 600e6).epsilon(1e-15));  // the slow test is between its points there
}

TEST_CASE("tabulated rates: every step ends on the table, whatever strains and rates it passes") {
  for (const Between between : {Between::rates, Between::logarithms}) {
    const TabulatedRates law{G, tests, between};
    for (const double e : {0.0, .0199, .049, .3})
      for (const double dl : {1e-12, 1e-9, 1e-6, 1e-4, 1e-2, .1})
        for (const double dt : {1e-9, 1e-7, 1e-5, 1e-2}) {
          const double q = law.flow_stress(e + dl, dl / dt) + 3 * G * dl;
          CHECK(std::abs(increment(law, e, q, dt) - dl) <= 1e-13 * q / (3 * G));  // 3 G is the least slope but for
          CHECK(increment(law, e, .99 * law.flow_stress(e, 0.0), dt) == 0);       // the fall of 125 MPa
        }
  }
}

TEST_CASE("tabulated rates: one test is TabulatedHardening, and equal tests are") {
  const TabulatedHardening table{G, slow};
  for (const Tests& same : {Tests{{7, slow}}, Tests{{1, slow}, {50, slow}}}) {
    const TabulatedRates law{G, same};
    for (const double q : {390e6, 401e6, 450e6, 2e9, 20e9})
      for (const double e : {0.0, .05})
        CHECK(std::abs(increment(law, e, q, 1e-7) - table.plastic_increment(q, e, 1.0)) <= 1e-14 * q / (3 * G));
  }
}

TEST_CASE("tabulated rates: a lane is what it is alone, in float and double") {
  const TabulatedRates law{G, tests, Between::logarithms};
  using P = Pack<double, 8>;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int round = 0; round < 50; ++round) {
    const P e = P::generate([&](std::size_t) { return .2 * unit(random); });
    const P rate = P::generate([&](std::size_t) { return std::pow(10, 8 * unit(random) - 3); });
    const P q = P::generate([&](std::size_t) { return 1e9 * unit(random); });
    const P stress = law.flow_stress(e, rate), dl = plastic_increment<TabulatedRates, P>(law, {e}, q, 1e-7);
    const Pack<float, 8> ef = Pack<float, 8>::generate([&](std::size_t l) { return float(lane(e, l)); });
    const Pack<float, 8> rf = Pack<float, 8>::generate([&](std::size_t l) { return float(lane(rate, l)); });
    const Pack<float, 8> in_float = law.flow_stress(ef, rf);
    for (std::size_t l = 0; l < 8; ++l) {
      CHECK(lane(stress, l) == Approx(law.flow_stress(lane(e, l), lane(rate, l))).epsilon(1e-14));
      CHECK(std::abs(lane(dl, l) - increment(law, lane(e, l), lane(q, l), 1e-7)) <= 1e-14 * 1e9 / (3 * G));
      CHECK(double(lane(in_float, l)) == Approx(lane(stress, l)).epsilon(1e-5));  // 2^-24 of ln r over 9
    }
  }
}

TEST_CASE("tabulated rates: derivatives by dual numbers are the slopes of the cell") {
  using D = Dual<double, 2>;
  const D e = D::variable(.01, 0), rate = D::variable(1.0, 1);
  const D stress = TabulatedRates{G, tests, Between::logarithms}.flow_stress(e, rate);  // half way
  CHECK(stress.derivative(0) == Approx(.5 * (50e6 / .02) + .5 * (80e6 / .05)).epsilon(1e-14));
  CHECK(stress.derivative(1) == Approx((536e6 - 425e6) / std::log(1e4)).epsilon(1e-14));
}

TEST_CASE("tabulated rates: in plane stress too every step ends on the table") {
  const TabulatedRates law{G, tests, Between::logarithms};
  const PlaneStress sheet{Solid{LinearEos{.density = 1, .bulk_modulus = 160e9}, law}};
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto u = [&] { return unit(random); };
  for (int path = 0; path < 200; ++path) {
    decltype(sheet)::State<double> state;
    const double dt = std::pow(10, -6 + 3 * u());
    for (int i = 0; i < 5; ++i) {
      const double e = state.equivalent_plastic_strain, size = std::pow(10, -3 + u());
      sheet.stress(state, {{size * u() / dt, size * u() / dt, size * u() / dt}}, dt);
      if (const double dl = state.equivalent_plastic_strain - e; dl > 0)
        CHECK(equivalent_stress(state.stress) == Approx(law.flow_stress(e + dl, dl / dt)).epsilon(1e-12));
    }
  }
}

TEST_CASE("tabulated rates: what no table can be is refused in one sentence") {
  const auto refused = [](const Tests& given, const std::string& why, Between between = Between::rates) {
    CHECK_THROWS_WITH((TabulatedRates{G, given, between}), ContainsSubstring(why));
  };
  refused({}, "strike: a TabulatedRates has no tests: give it at least one.");
  refused({{1, slow}, {2, {}}}, "strike: a TabulatedHardening, in test 2, has no points");
  refused({{1, slow}, {1, fast}}, "the rate of test 2 of TabulatedRates is 1; it must be above 1: sort the tests");
  refused({{-1, slow}}, "the rate of test 1 of TabulatedRates is -1; it must be zero or positive");
  refused({{0, slow}, {1, fast}}, "the rate of test 1 of TabulatedRates is 0; it must be positive",
          Between::logarithms);
  refused({{0, slow}, {1, {{.01, 1e9}}}}, "the plastic_strain of point 0 of TabulatedHardening, in test 2, is 0.01");
  refused({{0, fast}, {1, slow}},
          "the stress of test 2 at the plastic strain 0 of TabulatedRates is 4e+08; it must be "
          "at least 5.2e+08: the stress of a test is not below that of a slower one.");
  refused({{0, {{0, 1e6}, {1, 2e6}}}, {1, {{0, 1e6}, {.5, 2e6}, {1, 1.9e6}}}}, "at the plastic strain 1");
  CHECK(!TabulatedRates{G, tests}.warning().empty());  // the slow one falls
  CHECK(TabulatedRates{G, {{0, fast}}}.warning().empty());
}
