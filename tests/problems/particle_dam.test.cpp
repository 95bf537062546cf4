// A dam of particles that breaks: its front against the one measured by Martin and Moyce (1952).
#include <algorithm>
#include <cmath>
#include <vector>

#include <strike/contact/rigid_wall.hpp>
#include <strike/dynamics/explicit.hpp>
#include <strike/dynamics/stop_when.hpp>
#include <strike/element/particle.hpp>
#include <strike/load/body_force.hpp>

#include "problems/particle_jet.hpp"
#include "support/catch.hpp"

using namespace strike;

// 2.25 in wide and twice as high; Z = x/a at T = t sqrt(2 g/a). The column was freed by a burning membrane, which
// delays the start; the speed of the front does not know.
TEST_CASE("particles: the front of a breaking dam runs as Martin and Moyce measured it", "[particles]") {
  constexpr int across = 10;
  constexpr double a = 57.15, g = 9.81e-3, s = a / across;
  const double c = 10 * std::sqrt(g * 2 * a);  // ten times what flows at most
  const Mesh mesh =
      particle_jet::filled({0, 0, 0}, {across, 4, 2 * across}, s, a * 2 * a * 4 * s, [](const auto&) { return true; });
  const Mirrors mirrors{Mirror{{1, 0, 0}}, Mirror{{0, 1, 0}}, Mirror{{0, 1, 0}, {0, 4 * s, 0}}};
  const Fluid liquid{CubicEos{.density = 1e-6, .C1 = 1e-6 * c * c, .pressure_cutoff = 0}};
  Explicit run{Scene{mesh.nodes, Part{Particle{Smoothing{}, mirrors}, liquid, mesh.particles}, BodyForce{{0, 0, -g}},
                     RigidWall{{0, 0, 0.5 * s}, {0, 0, 1}}}};
  const auto reaches = [&](double Z) {
    run.until(1000, StopWhen{[&] {
                double front = 0;
                for (std::size_t i = 0; i < mesh.nodes.size(); ++i) front = std::max(front, run.nodes().x(i).x());
                return front + s / 2 > Z * a;
              }});
    return run.time() * std::sqrt(2 * g / a);
  };
  constexpr double measured[][2] = {{2.56, 2.20}, {3.00, 2.51}, {3.44, 2.83}, {4.11, 3.33}};
  std::vector<double> times;
  for (const auto& [Z, T] : measured) {
    times.push_back(reaches(Z));
    CHECK(times.back() == Approx(T).epsilon(0.05));
  }
  CHECK(times.back() - times.front() == Approx(3.33 - 2.20).epsilon(0.04));
  CHECK(std::abs(run.energy().error()) < 6e-3);
}
