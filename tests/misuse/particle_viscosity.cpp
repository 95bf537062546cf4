// expect: the fourth policy of Particle is its bulk viscosity
#include <strike/strike.hpp>

using namespace strike;

int main() {
  const Mesh ball = particles(SphereShape{.radius = 1}, 4);
  const Elastic steel{.density = 7850, .youngs_modulus = 200e9, .poissons_ratio = 0.3};
  Explicit run{
      Scene{ball.nodes, Part{Particle{Smoothing{}, Mirrors{}, Jaumann{}, ViscousHourglass{}}, steel, ball.particles}}};
  run.until(1e-3);
}
