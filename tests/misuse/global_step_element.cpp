// expect: for GlobalStep{} give it resistance(state, material, x, v, dt), as Hex8 has it
#include <strike/strike.hpp>

using namespace strike;

int main() {
  const Mesh cloud = particles(BoxShape{.size = {1, 1, 1}, .cells = {2, 2, 2}});
  const Elastic steel{7850, 210e9, 0.3};
  Explicit run{Scene{cloud.nodes, Part{Particle{}, steel, cloud.particles}}, ExplicitOptions{}, GlobalStep{}};
  run.until(1e-3);
}
