// Particles: birds on a rigid plate by resolution, speed and place of the lattice; jets; Taylor's bar.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "problems/particle_jet.hpp"
#include "problems/particle_taylor.hpp"
#include "row.hpp"

using namespace strike;
using namespace strike::particle_jet;

namespace verification {

namespace {

/// Birds whose lattices lie by chance.
void birds(double across, double speed, unsigned seeds) {
  const std::string text = "particles bird " + std::to_string(static_cast<int>(across)) + " across, " +
                           std::to_string(static_cast<int>(speed)) + " m/s";
  const char* const name = text.c_str();
  if (!is_wanted(name)) return;
  double sum = 0, squares = 0, drift = 0, rings[10] = {};
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    const Jet jet{.across = across, .speed = speed, .is_quarter = false};
    auto run = on_wall(jet, by_chance(jet, seed));
    Gauge gauge(jet, 0.2, 0.5);
    run.until(0.52 * jet.length() / speed, [&] {
      gauge.see(run);
      drift = std::max(drift, std::abs(run.energy().error()));
    });
    sum += gauge.centre(), squares += gauge.centre() * gauge.centre();
    for (std::size_t k = 0; k < 10; ++k) rings[k] += gauge.ring(k) / seeds;
  }
  const double mean = sum / seeds;
  row(name, "centre pressure", {1, 0.05}, mean, "of the stagnation pressure");
  row(name, "error of the balance", {0, 0.6}, 100 * drift, "%");
  std::printf("<!-- %s: %u lattices, deviation %.3f, rings", name, seeds,
              std::sqrt(std::max(0.0, squares / seeds - mean * mean)));
  for (const double p : rings) std::printf(" %.3f", p);
  std::printf(" -->\n");
}

/// Late, when the flow is steady.
void jet_on_wall(const char* name, const Jet& jet, double from, double to) {
  if (!is_wanted(name)) return;
  auto run = on_wall(jet, jet.mesh());
  Gauge gauge(jet, from, to);
  run.until((to + 0.01) * jet.length() / jet.speed, [&] { gauge.see(run); });
  row(name, "force", {1, 0.03}, gauge.force(), "of rho A v^2");
  std::printf("<!-- %s: centre %.3f, rings", name, gauge.centre());
  for (std::size_t k = 0; k < 10; ++k) std::printf(" %.3f", gauge.ring(k));
  std::printf(" -->\n");
}

}  // namespace

void particles() {
  for (const double speed : {116.0, 180.0, 225.0, 300.0})
    for (const double across : {12.0, 16.0}) birds(across, speed, speed == 180 ? 8 : 4);
  birds(10, 180, 4), birds(14, 180, 4), birds(20, 180, 2);
  jet_on_wall("particles round-nosed jet 8 across", {.across = 8, .aspect = 8, .has_round_nose = true}, 0.4, 0.8);
  jet_on_wall("particles round-nosed jet 12 across", {.across = 12, .aspect = 8, .has_round_nose = true}, 0.4, 0.8);
  jet_on_wall("particles plane jet 16 across", {.across = 16, .aspect = 10, .is_plane = true}, 0.4, 0.75);
  birds(24, 180, 4), birds(32, 180, 3);
  for (const double across : {3.0, 4.0, 5.0, 6.0}) {
    const std::string name = "particles taylor " + std::to_string(static_cast<int>(across));
    if (!is_wanted(name)) continue;
    auto run = taylor::bar_of_particles(across);
    double drift = 0;
    run.until(taylor::mm_ms_kg.end, [&] { drift = std::max(drift, std::abs(run.energy().error())); });
    row(name.c_str(), "length", {21.47, 0.43}, taylor::length(run), "mm");
    row(name.c_str(), "radius of the foot", {7.08, 0.1}, taylor::radius(run) + taylor::mm_ms_kg.radius / across / 2,
        "mm");
    row(name.c_str(), "largest plastic strain", unknown, taylor::plastic_strain(run), "");
    row(name.c_str(), "error of the balance", {0, 0.6}, 100 * drift, "%");
  }
}

}  // namespace verification
