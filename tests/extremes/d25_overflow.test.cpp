#include <array>
#include <cmath>

#include "problems/taylor_bar.hpp"
#include "support/catch.hpp"

using namespace strike;

namespace {

using Answer = std::array<double, 5>;

/// The answer without units of a coarse Taylor bar in units of that many millimetres, milliseconds and kilograms.
Answer strike_wall(double length, double time, double mass) {
  taylor::Data data = taylor::mm_ms_kg;
  const double stress = mass / (length * time * time);
  data.radius /= length, data.length /= length, data.end /= time, data.speed /= length / time;
  data.density /= mass / (length * length * length);
  data.youngs_modulus /= stress, data.yield_stress /= stress, data.hardening_modulus /= stress;
  auto run = taylor::bar(data, 1, 16, in<Pack<double>>);
  run.until(data.end);
  const Energy& e = run.energy();
  return {taylor::length(run) / data.length, taylor::radius(run) / data.radius, taylor::plastic_strain(run),
          e.internal / e.initial, static_cast<double>(run.steps())};
}

}  // namespace

TEST_CASE("D25: the same answer for lengths of 1e-9 and 1e9, a modulus of 1e30, a density of 1e-30") {
  const Answer usual = strike_wall(1, 1, 1);
  for (const auto& [length, time, mass] : {std::array{1e-9, 1.0, 1.0},
                                           {1e9, 1.0, 1.0},
                                           {1.0, 1e-12, 1.0},
                                           {1.0, 1e12, 1.0},
                                           {1.0, 1.0, 1e25},
                                           {1.0, 1.0, 1e-28},
                                           {1e9, 1e9, 1e-9}}) {
    INFO("length " << length << ", time " << time << ", mass " << mass);
    const Answer answer = strike_wall(length, time, mass);
    for (std::size_t i = 0; i < answer.size(); ++i) CHECK(answer[i] == Approx(usual[i]).epsilon(1e-9));
  }
}
