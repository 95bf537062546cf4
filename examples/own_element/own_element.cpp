// An element of your own, a truss, with its own pair of measure and stress: a string that swings.
//
//   bash examples/run own_element
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include <strike/draw.hpp>
#include <strike/strike.hpp>

#include "../support/options.hpp"
#include "truss.hpp"

using namespace strike;

namespace {

// Millimetres, milliseconds, kilograms; so kN and GPa.
const Wire steel{.density = 7.85e-6, .youngs_modulus = 200, .yield_stress = 1, .initial_stress = 0.5};
constexpr double length = 1000;
constexpr std::size_t count = 50;

struct Swing {
  std::vector<double> time, deflection;  ///< of the middle
  double period;
};

/// A string between two fixed ends, struck in half a sine, over a swing.
Swing swing() {
  std::vector<Eigen::Vector3d> nodes;
  Cells<2> bars;
  for (std::size_t i = 0; i <= count; ++i) {
    const double s = double(i) / double(count);
    nodes.emplace_back(s * length, 0, 0);
    if (i > 0) bars.push_back({Index(i - 1), Index(i)});
  }
  const InitialVelocityField struck{[](const Eigen::Vector3d& x) -> Eigen::Vector3d {
    return {0, 0.1 * std::sin(std::numbers::pi * x.x() / length), 0};
  }};
  Explicit run{Scene{nodes, Part{Truss{.area = 1}, steel, bars}, struck, Pinned{{0, count}}}};

  std::vector<double> crossings, t{0}, y{0};
  while (crossings.size() < 2) {
    run.step();
    const double time = run.time(), now = run.positions()[count / 2].y();
    if (now * y.back() < 0) crossings.push_back(t.back() + (time - t.back()) * y.back() / (y.back() - now));
    t.push_back(time), y.push_back(now);
  }
  return {t, y, 2 * (crossings[1] - crossings[0])};
}

}  // namespace

int main(int argument_count, char** arguments) {
  return examples::run(argument_count, arguments, [](examples::Options& options) {
    options.check();
    const double exact = 2 * length * std::sqrt(steel.density / steel.initial_stress);
    const auto [time, deflection, found] = swing();
    std::printf("period of the string   %.3f ms\n", found);
    std::printf("2 L sqrt(rho/sigma)    %.3f ms\n", exact);

    std::vector<double> sine;
    for (const double t : time)
      sine.push_back(0.1 * exact / (2 * std::numbers::pi) * std::sin(2 * std::numbers::pi * t / exact));
    Chart chart{{.title = "A string of fifty trusses",
                 .x = {.label = "time", .unit = "ms"},
                 .y = {.label = "deflection", .unit = "mm"}}};
    chart.curve("simulated", time, deflection);
    chart.curve("d'Alembert", time, sine);
    chart.write("string.svg");

    Results results;
    results.add({"period", found, "ms", exact, 1e-3 * exact, "2 L sqrt(rho/sigma)"});
    results.write("results.csv");
  });
}
