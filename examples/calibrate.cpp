// Strength parameters from measurements: first a stress-strain curve whose truth is known, then copper bars that struck
// a wall.
//
//   bash examples/run calibrate
//   bash examples/run calibrate cells=3
#include <array>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

#include <strike/calibrate.hpp>
#include <strike/draw.hpp>
#include <strike/strike.hpp>

#include "support/options.hpp"

using namespace strike;
using namespace strike::calibrate;

namespace {

// Millimetres, milliseconds, kilograms; so kN and GPa.
const LinearEos elastic{.density = 8.93e-6, .bulk_modulus = 130};
const VonMises copper{.shear_modulus = 43.3, .yield_stress = 0.3, .hardening_modulus = 0.2};

template <std::size_t N>
void print(const Fit<N>& fitted) {
  for (std::size_t i = 0; i < N; ++i)
    std::printf("  %-22s%9.4f  +- %6.4f   95 %% in %.4f ... %.4f\n", fitted.unknowns[i].name.c_str(),
                fitted.parameters[i], fitted.standard_errors[i], fitted.intervals[i].lower, fitted.intervals[i].upper);
  std::printf("  scatter of the data %.4f, %zu degrees of freedom, %zu evaluations%s\n", fitted.standard_deviation(),
              fitted.degrees_of_freedom, fitted.evaluations, fitted.end == FitEnd::converged ? "" : ", not at the end");
}

/// A tension test of a known metal, with noise of 5 MPa.
struct TensionTest {
  static constexpr double yield_stress = 0.4, hardening_modulus = 0.1, noise = 0.005;
  std::vector<double> strains, stresses;

  TensionTest() {
    std::mt19937 random(2024);
    std::normal_distribution<double> scatter(0, noise);
    for (int i = 1; i <= 20; ++i) strains.push_back(0.01 * i);
    const VonMises truth{43.3, yield_stress, hardening_modulus};
    for (const double stress : uniaxial_stresses(Solid{elastic, truth}, strains, {}))
      stresses.push_back(stress + scatter(random));
  }

  Fit<2> fitted() const {
    const auto residuals = [&](const auto& p) {
      const Sensitive law{copper, p, &VonMises::yield_stress, &VonMises::hardening_modulus};
      auto r = uniaxial_stresses(Solid{elastic, law}, strains, {}, in<Dual<double, 2>>);
      for (std::size_t i = 0; i < r.size(); ++i) r[i] = (r[i] - stresses[i]) / noise;
      return r;
    };
    return fit(residuals, {{"yield stress [GPa]", 0.2}, {"hardening [GPa]", 0.5}});
  }
};

/// Bars of copper as they were found after the impact: final over first length, and radius of the foot over the first.
struct Specimen {
  double length, radius, speed, shortened, widened;
};
constexpr std::array specimens{Specimen{34.5, 3.9, 162, 0.763, 1.701}, Specimen{34.5, 3.9, 167, 0.743, 1.772},
                               Specimen{34.5, 3.9, 225, 0.645, 2.056}, Specimen{34.5, 3.9, 316, 0.464, 2.724}};
constexpr Specimen other{23.47, 3.81, 210, 0.630, 2.204};

/// The shape of a bar at rest, after 2.6 times its loss of length over its speed.
template <class Law, class Number>
auto rest(const Specimen& s, const Law& law, Index cells, Number number) {
  const auto layers = static_cast<Index>(std::lround(s.length / s.radius * cells));
  const Mesh bar = cylinder({.radius = s.radius, .length = s.length, .cells = cells, .layers = layers});
  const auto on = [&](Axis axis) { return nodes_where(bar.nodes, on_plane(axis, 0)); };
  Explicit run{Scene{bar.nodes, Part{Hex8{}, Solid{elastic, law}, bar.hexahedra}, InitialVelocity{{0, 0, -s.speed}},
                     Symmetry{Axis::x, on(Axis::x)}, Symmetry{Axis::y, on(Axis::y)}, Symmetry{Axis::z, on(Axis::z)}},
               {},
               number};
  run.until(2.6 * (1 - s.shortened) * s.length / s.speed);
  return bar_profile(bar, run.nodes());
}

/// Model over measurement less one, for length and foot of each specimen: equal weights of relative errors.
template <std::size_t N, class MakeLaw>
auto shape_residuals(MakeLaw make_law, Index cells) {
  return [=](const std::array<Dual<double, N>, N>& p) {
    std::vector<Dual<double, N>> r;
    for (const Specimen& s : specimens) {
      const auto profile = rest(s, make_law(p), cells, in<Dual<Pack<double>, N>>);
      r.push_back(profile.length() / (s.shortened * s.length) - 1.0);
      r.push_back(profile.foot_radius() / (s.widened * s.radius) - 1.0);
    }
    return r;
  };
}

Fit<2> fitted_bars(Index cells) {
  const auto law = [](const auto& p) {
    return Sensitive{copper, p, &VonMises::yield_stress, &VonMises::hardening_modulus};
  };
  return fit(shape_residuals<2>(law, cells), {{"yield stress [GPa]", 0.3}, {"hardening [GPa]", 0.2}},
             {.tolerance = 1e-5});
}

/// Fit with the rate factor (1 + C r^0.2) too, r in 1/ms, in three evaluations.
Fit<3> fitted_rate(const Fit<2>& without, Index cells) {
  const auto law = [](const auto& p) {
    return Sensitive{RateVonMises{.shear_modulus = 43.3, .yield_stress = 0.3, .rate_exponent = 0.2}, p,
                     &RateVonMises::yield_stress, &RateVonMises::hardening_modulus, &RateVonMises::rate_factor};
  };
  return fit(shape_residuals<3>(law, cells),
             {{"yield stress [GPa]", 0.9 * without.parameters[0]},
              {"hardening [GPa]", 0.9 * without.parameters[1]},
              {"rate factor [ms^0.2]", 0.05, Sign::any}},
             {.tolerance = 1e-5, .evaluations = 3});
}

void chart(const TensionTest& test, const Fit<2>& fitted) {
  const VonMises found{43.3, fitted.parameters[0], fitted.parameters[1]};
  Chart chart{{.title = "A tension test and the law found from it",
               .x = {.label = "logarithmic strain"},
               .y = {.label = "stress", .unit = "GPa", .lower = 0}}};
  chart.points("with noise", test.strains, test.stresses);
  chart.curve("fitted", test.strains, uniaxial_stresses(Solid{elastic, found}, test.strains, {}));
  chart.write("tension.svg");
}
void chart(const Fit<2>& fitted, const std::vector<double>& speeds) {
  std::vector<double> lengths, radii, length_errors, radius_errors;
  for (std::size_t i = 0; i < specimens.size(); ++i) {
    lengths.push_back(specimens[i].shortened), radii.push_back(specimens[i].widened);
    length_errors.push_back(specimens[i].shortened * (1 + fitted.residuals[2 * i]));
    radius_errors.push_back(specimens[i].widened * (1 + fitted.residuals[2 * i + 1]));
  }
  Chart chart{{.title = "Copper bars at rest, measured and fitted",
               .x = {.label = "speed of impact", .unit = "m/s"},
               .y = {.label = "final over first", .lower = 0}}};
  chart.points("length, measured", speeds, lengths);
  chart.curve("length, fitted", speeds, length_errors);
  chart.points("foot radius, measured", speeds, radii);
  chart.curve("foot radius, fitted", speeds, radius_errors);
  chart.write("bars.svg");
}

}  // namespace

int main(int count, char** arguments) {
  return examples::run(count, arguments, [](examples::Options& options) {
    const Index cells = options.count("cells", 2);
    options.check();
    Results results;

    const TensionTest test;
    const Fit<2> tension = test.fitted();
    std::printf("A tension test of Y = %.1f and H = %.1f GPa with a noise of %.0f MPa\n", test.yield_stress,
                test.hardening_modulus, 1000 * test.noise);
    print(tension);
    for (const auto& [i, truth] : {std::pair{0, test.yield_stress}, {1, test.hardening_modulus}}) {
      const auto k = static_cast<std::size_t>(i);
      results.add({"tension: " + tension.unknowns[k].name, tension.parameters[k], "GPa", truth,
                   4 * tension.standard_errors[k], "known truth, 4 standard errors"});
    }

    std::printf("\nFour copper bars, length and foot as measured (Zelepugin 2023), sigma = Y + H e\n");
    const Fit<2> bars = fitted_bars(cells);
    print(bars);
    std::printf(
        "  correlation of the two %.2f\n\n  speed [m/s]  length, measured  model less that  foot, measured  model less "
        "that\n",
        bars.correlation(0, 1));
    History table(
        "bars.csv",
        {{"speed", "m/s"}, {"length", "1"}, {"length error", "1"}, {"foot radius", "1"}, {"foot radius error", "1"}});
    std::vector<double> speeds;
    const auto row = [&](const Specimen& s, double length, double foot) {
      std::printf("  %11.0f%18.3f%16.1f %%%16.3f%16.1f %%\n", s.speed, s.shortened, 100 * length, s.widened,
                  100 * foot);
      table.row(s.speed, s.shortened, length, s.widened, foot);
    };
    for (std::size_t i = 0; i < specimens.size(); ++i) {
      row(specimens[i], bars.residuals[2 * i], bars.residuals[2 * i + 1]);
      speeds.push_back(specimens[i].speed);
    }
    const auto foretold = rest(other, VonMises{43.3, bars.parameters[0], bars.parameters[1]}, cells, in<Pack<double>>);
    std::printf("  foretold, a bar of another stock (%.2f x %.2f mm):\n", other.length, 2 * other.radius);
    row(other, foretold.length() / (other.shortened * other.length) - 1,
        foretold.foot_radius() / (other.widened * other.radius) - 1);

    std::printf("\nThe same with a rate, sigma = (Y + H e)(1 + C r^0.2): can these bars tell it?\n");
    const Fit<3> rate = fitted_rate(bars, cells);
    print(rate);
    std::printf("  correlation of yield stress and rate factor %.4f: %s\n", rate.correlation(0, 2),
                rate.intervals[2].contains(0) ? "they cannot, C = 0 is as good" : "they can");

    for (std::size_t i = 0; i < 2; ++i) results.add({"bars: " + bars.unknowns[i].name, bars.parameters[i], "GPa"});
    results.add({"bars: scatter", bars.standard_deviation(), "1"});
    results.add({"bars: correlation of yield stress and rate", rate.correlation(0, 2), "1"});
    results.write("results.csv");
    chart(test, tension);
    chart(bars, speeds);
    std::printf("\nWritten: bars.csv, bars.svg, tension.svg, results.csv\n");
  });
}
