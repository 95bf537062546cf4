#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include <strike/material/eos/eos.hpp>
#include <strike/material/eos/gruneisen.hpp>
#include <strike/material/eos/ideal_gas.hpp>
#include <strike/material/eos/polynomial.hpp>
#include <strike/material/eos/tabulated.hpp>
#include <strike/material/fluid.hpp>
#include <strike/material/solid.hpp>
#include <strike/material/strength/von_mises.hpp>
#include <strike/scalar/pack.hpp>
#include <strike/verify/material_point.hpp>

#include "support/catch.hpp"
#include "support/shock.hpp"

using namespace strike;
using namespace strike::verify;
using Points = std::vector<TabulatedEos::Point>;
using State = EosState<TabulatedEos, double>;

static_assert(ThermalEquationOfState<TabulatedEos>);

namespace {

const Points water_points{{-.3, 2e9, .4}, {-.1, .5e9, .5}, {0, 0, .6}, {.2, -.1e9, .3}};
const TabulatedEos water{1000, water_points, 2, 3e5};

double mu_of(double e) { return std::expm1(-e); }
TabulatedEos reversed(const TabulatedEos& eos) {
  Points points = eos.points();
  std::reverse(points.begin(), points.end());
  return {eos.density, points, eos.gamma, eos.initial_energy, eos.pressure_cutoff};
}

/// Another equation at n + 1 equal steps of e.
template <class Eos>
TabulatedEos table_of(const Eos& eos, double from, double to, int n) {
  Points points;
  for (int i = 0; i <= n; ++i) {
    const double e = from + (to - from) * i / n;
    points.push_back({e, eos.A(mu_of(e)), eos.B(mu_of(e))});
  }
  return {eos.density, points, 1, eos.initial_energy};
}

}  // namespace

TEST_CASE("tabulated EOS: the points, lines between them, and the first and the last line beyond") {
  // ln and exp of e err by a rounding of 1 each, so the pressure by that times the slope
  const double margin_C = 4e-16 * 7.5e9, margin_T = 4e-16 * 3;
  for (const auto& [e, C, T] : water_points) {
    CHECK(water.A(mu_of(e)) == Approx(C).epsilon(0).margin(margin_C));
    CHECK(water.B(mu_of(e)) == Approx(2 * T).epsilon(0).margin(margin_T));
  }
  CHECK(water.A(mu_of(-.15)) == Approx(.875e9).epsilon(0).margin(margin_C));  // .5 + (2 - .5)/4
  CHECK(water.B(mu_of(.05)) == Approx(2 * .525).epsilon(0).margin(margin_T));
  CHECK(water.A(mu_of(-.5)) == Approx(3.5e9).epsilon(0).margin(margin_C));
  CHECK(water.B(mu_of(-.5)) == Approx(2 * .3).epsilon(0).margin(margin_T));
  CHECK(water.A(mu_of(.4)) == Approx(-.2e9).epsilon(0).margin(margin_C));
  CHECK(water.B(mu_of(.4)) == Approx(0).margin(margin_T));

  // A point at rest is exact, or what rests would move.
  CHECK(water.A(0.) == 0);
  State state;
  CHECK(begin_eos(water, state) == 2 * .6 * 3e5);
  CHECK(state.internal_energy == 3e5);
  for (double i = 1; i < 20; ++i) CHECK(TabulatedEos{1, {{-.7 / i, 1 / i}, {0, .1 / i}, {.3, -.7}}}.A(0.) == .1 / i);
}

TEST_CASE("tabulated EOS: the bulk modulus is -dC/de without energy, at a point that of the denser side") {
  const TabulatedEos cold{1000, {{-.3, 2e9}, {-.1, .5e9}, {0, 0}, {.2, -.1e9}}};
  State nothing{};
  for (const auto& [e, K] :
       std::vector<std::pair<double, double>>{{-.4, 7.5e9}, {-.2, 7.5e9}, {-.05, 5e9}, {0, 5e9}, {.1, .5e9}, {1, .5e9}})
    CHECK(bulk_modulus(cold, nothing, std::exp(e), cold.A(mu_of(e))) == Approx(K).epsilon(1e-14));
  for (const double e : {-.4, -.2, -.05, .1})
    for (const double E : {0., 3e5, 4e8}) {
      const double J = std::exp(e), mu = 1 / J - 1;
      CHECK(bulk_modulus(water, State{E}, J, water.A(mu) + water.B(mu) * E) ==
            Approx(testing::isentropic_bulk_modulus(water, J, E)).epsilon(1e-7));
    }
}

TEST_CASE("tabulated EOS: the order of the points does not change a bit") {
  const TabulatedEos other = reversed(water);
  for (double mu = -.5; mu < 1; mu += .01) {
    CHECK(water.A(mu) == other.A(mu));
    CHECK(water.B(mu) == other.B(mu));
    const double p = water.A(mu) + water.B(mu) * 1e6;
    CHECK(bulk_modulus(water, State{1e6}, 1 / (1 + mu), p) == bulk_modulus(other, State{1e6}, 1 / (1 + mu), p));
  }
}

TEST_CASE("tabulated EOS: a table of another equation errs by h^2/8 of its curvature") {
  const auto error = [](const auto& eos, double from, int n) {  // of p at E, relative to the largest
    const TabulatedEos table = table_of(eos, from, -from, n);
    double worst = 0, most = 0;
    for (int i = 0; i <= 400; ++i) {
      const double mu = mu_of(from - 2 * from * i / 400), E = 1e8;
      const double p = eos.A(mu) + eos.B(mu) * E;
      worst = std::max(worst, std::abs(table.A(mu) + table.B(mu) * E - p)), most = std::max(most, std::abs(p));
    }
    return worst / most;
  };
  const auto check = [&](const auto& eos) {
    const double coarse = error(eos, -.25, 10), fine = error(eos, -.25, 20), finest = error(eos, -.25, 40);
    CHECK(coarse / fine == Approx(4).epsilon(.15));  // the next term is h times as large
    CHECK(fine / finest == Approx(4).epsilon(.08));
  };
  check(PolynomialEos{.density = 1000, .C1 = 2.19e9, .C2 = 9.224e9, .C3 = 8.767e9, .C4 = .4934, .C5 = 1.3937});
  check(GruneisenEos{.density = 8930, .sound_speed = 3940, .S1 = 1.489, .gamma = 1.99, .a = .47});
  check(IdealGas{.density = 1.2, .gamma = 1.4, .initial_energy = 2.5e5});
  // of gamma T = (gamma - 1) e^-e, in the piece of the largest, by its formula
  const double h = .5 / 40;
  CHECK(error(IdealGas{1.2, 1.4, 2.5e5}, -.25, 40) == Approx(h * h / 8).epsilon(2 * h));
}

TEST_CASE("tabulated EOS: the adiabat of a gas is p V^gamma = const to the error of its table") {
  const IdealGas air{.density = 1.2, .gamma = 1.4, .initial_energy = 2.5e5};
  const double half = std::log(.5);
  const auto rise = [&](int n) {  // of ln(p V^gamma) at half the volume, where a point is
    MaterialPoint point{Fluid{table_of(air, half, 0, n)}};
    point.run(uniaxial_strain({.strain = half, .steps = 2000}));
    const auto& end = point.now();
    // the heat is the work
    CHECK(end.state.internal_energy - air.initial_energy == Approx(end.work).epsilon(1e-12));
    return std::log(-end.stress.xx / 1e5) + 1.4 * std::log(end.relative_volume());
  };
  // d ln E = -gamma T V de, and a chord of e^-e lies above it by h^2/12 in the mean
  for (const int n : {5, 10}) {
    const double h = -half / n;
    // the chord's next term h^3/24, and the energy's rule of the trapezium, (ln 2/2000)^2/12 of 1e-8
    CHECK(rise(n) == Approx(-.4 * half * h * h / 12).epsilon(h).margin(2e-8));
  }
}

TEST_CASE("tabulated EOS: a solid's energy is the work on it, there and back, over every piece") {
  const Solid solid{water, VonMises{.shear_modulus = 1e8, .yield_stress = 1e6}};
  MaterialPoint point{solid};
  point.run(cyclic(uniaxial_strain({.strain = -.4, .steps = 200})));
  const auto& end = point.now();
  CHECK(end.work > 0);                                                       // flow heats
  CHECK(end.state.internal_energy - 3e5 == Approx(end.work).epsilon(1e-9));  // the strain of a step to its cube
}

TEST_CASE("tabulated EOS: the shock states of its table are those of water to its error") {
  const PolynomialEos exact{.density = 1000, .C1 = 2.19e9, .C2 = 9.224e9, .C3 = 8.767e9, .C4 = .4934, .C5 = 1.3937};
  const auto table = testing::shock(table_of(exact, -.4, 0, 80), 1000), law = testing::shock(exact, 1000);
  // h^2/8 p'' of p: (.4/80)^2/8 (3.3e10)/3.5e9, the curvature at mu = .4
  CHECK(table.pressure == Approx(law.pressure).epsilon(3e-5));
  CHECK(table.speed == Approx(law.speed).epsilon(3e-5));
}

TEST_CASE("tabulated EOS: float, lanes and dual numbers give the value of double") {
  using Lanes = Pack<double, 4>;
  using D = Dual<double, 1>;
  const double all[4] = {-.3, -.05, .2, .7};
  const Lanes mu = Lanes::generate([&](std::size_t k) { return all[k]; });
  const Lanes A = water.A(mu), B = water.B(mu);
  for (std::size_t k = 0; k < 4; ++k) {
    // a rounding of the logarithm, which is below 1
    CHECK(A[k] == Approx(water.A(all[k])).epsilon(4e-16).margin(2e-16 * 7.5e9));
    CHECK(B[k] == Approx(water.B(all[k])).epsilon(4e-16).margin(2e-16 * 3));
    CHECK(water.A(float(all[k])) == Approx(water.A(double(float(all[k])))).epsilon(2e-7).margin(1e-7 * 7.5e9));
    const D dual = water.A(D::variable(all[k], 0));
    CHECK(dual.value() == Approx(water.A(all[k])).epsilon(4e-16).margin(2e-16 * 7.5e9));
    const double h = 1e-6;
    CHECK(dual.derivative(0) == Approx((water.A(all[k] + h) - water.A(all[k] - h)) / (2 * h)).epsilon(1e-8));
  }
}

TEST_CASE("tabulated EOS: other units, the same bits") {
  const double unit = 1024;  // of stress and of energy
  Points points = water_points;
  for (auto& point : points) point.C *= unit;
  const TabulatedEos scaled{1000, points, 2, 3e5 * unit, -1e5 * unit};
  TabulatedEos plain = water;
  plain.pressure_cutoff = -1e5;
  for (const double J : {.6, .9, .999, 1.001, 1.3}) {
    State a{3e5}, b{3e5 * unit};
    CHECK(advance_pressure(scaled, b, J, -.01, 1e6 * unit, 1e3 * unit) ==
          unit * advance_pressure(plain, a, J, -.01, 1e6, 1e3));
    CHECK(b.internal_energy == unit * a.internal_energy);
    CHECK(bulk_modulus(scaled, b, J, 1e6 * unit) == unit * bulk_modulus(plain, a, J, 1e6));
  }
}

TEST_CASE("tabulated EOS: tables that are none are refused") {
  const auto refuses = [](const Points& points, const std::string& sentence) {
    CHECK_THROWS_WITH((TabulatedEos{1000, points, 1}), "strike: " + sentence);
  };
  refuses({}, "a TabulatedEos has 0 points: give it at least two.");
  refuses({{0, 0}}, "a TabulatedEos has 1 point: give it at least two.");
  refuses({{0, 0}, {0, 1}},
          "the volumetric_strain of point 1 of TabulatedEos is 0; it must be below 0: sort the points by their strain, "
          "each once.");
  refuses({{-.2, 2e9}, {-.1, 1e9}, {-.15, .5e9}},
          "the volumetric_strain of point 2 of TabulatedEos is -0.15; it must be above -0.1: sort the points by their "
          "strain, each once.");
  refuses({{0, 0}, {-.1, 1e9}, {-.1, 2e9}},
          "the volumetric_strain of point 2 of TabulatedEos is -0.1; it must be below -0.1: sort the points by their "
          "strain, each once.");
  refuses({{0, 0}, {-.1, 1e9}, {-.2, .5e9}},
          "the C of point 2 of TabulatedEos is 5e+08; it must be above 1e+09: the bulk modulus from point 1 to point 2 "
          "is -5e+09, so let C fall as the volume grows.");
  refuses(
      {{-.2, 1e9}, {-.1, 0}, {.1, 0}},
      "the C of point 2 of TabulatedEos is 0; it must be below 0: the bulk modulus from point 1 to point 2 is 0, so "
      "let C fall as the volume grows.");
  refuses({{-.2, std::nan("")}, {0, 0}}, "the C of point 0 of TabulatedEos is nan; it must be finite.");
  refuses({{-.2, 1e9, 1e200}, {0, 0}},
          "the T of point 0 of TabulatedEos is 1e+200; it must be finite and at most 1e+100 in size.");
  // heat alone may carry a piece, not a cold one
  CHECK_NOTHROW(TabulatedEos{1, {{-1, 0, 3}, {0, 0, 1}}, .4, 1});
  CHECK_THROWS(TabulatedEos{1, {{-1, 0, 3}, {0, 0, 1}}, 0, 1});
  CHECK_THROWS(TabulatedEos{1, {{-1, 0, 3}, {0, 1, 1}}, .4, 1});

  const auto wrong = [](double TabulatedEos::*number, double value) {
    TabulatedEos eos = water;
    eos.*number = value;
    CHECK_THROWS_AS(strike::detail::check_ranges(Fluid{eos}), Error);
  };
  wrong(&TabulatedEos::density, 0), wrong(&TabulatedEos::gamma, -1);
  wrong(&TabulatedEos::pressure_cutoff, 1), wrong(&TabulatedEos::initial_energy, std::nan(""));
  CHECK_NOTHROW(strike::detail::check_ranges(Fluid{water}));
}
