#include <array>
#include <cmath>

#include "problems/taylor_bar.hpp"
#include "support/catch.hpp"

using namespace strike;

TEST_CASE("D23: the Taylor bar gives the same dimensionless answer in five systems of units") {
  // Meters, seconds and kilograms per unit of each system. A pound-force second^2 per inch is 175.126835 kg.
  struct System {
    const char* name;
    double length, time, mass;
  };
  const std::array<System, 5> systems{{{"m-s-kg", 1, 1, 1},
                                       {"mm-ms-kg", 1e-3, 1e-3, 1},
                                       {"mm-s-t", 1e-3, 1, 1e3},
                                       {"cm-us-g", 1e-2, 1e-6, 1e-3},
                                       {"in-s-lbf", 0.0254, 1, 4.4482216152605 / 0.0254}}};
  const taylor::Data si{3.2e-3, 32.4e-3, 8930, 117e9, 400e6, 100e6, 227, 80e-6};
  std::array<double, 6> first{};
  for (const System& unit : systems) {
    INFO(unit.name);
    const double stress = unit.mass / (unit.length * unit.time * unit.time);
    const taylor::Data data{.radius = si.radius / unit.length,
                            .length = si.length / unit.length,
                            .density = si.density / (unit.mass / std::pow(unit.length, 3)),
                            .youngs_modulus = si.youngs_modulus / stress,
                            .yield_stress = si.yield_stress / stress,
                            .hardening_modulus = si.hardening_modulus / stress,
                            .speed = si.speed / (unit.length / unit.time),
                            .end = si.end / unit.time};
    auto run = taylor::bar(data, 1, 16, in<Pack<double>>);
    run.until(data.end);
    const std::array<double, 6> answer{taylor::length(run) / data.length,
                                       taylor::radius(run) / data.radius,
                                       taylor::plastic_strain(run),
                                       run.energy().internal / run.energy().initial,
                                       run.energy().hourglass / run.energy().initial,
                                       static_cast<double>(run.steps())};
    if (first[0] == 0) first = answer;
    for (std::size_t i = 0; i < answer.size(); ++i) CHECK(answer[i] == Approx(first[i]).epsilon(1e-6));
  }
}
