// expect: the first piece of an Explosive is the equation of state of its products
#include <strike/strike.hpp>

using namespace strike;

int main() {
  const Explosive material{LinearEos{.density = 2500, .bulk_modulus = 42e9}, DetonationPoint{{0, 0, 0}},
                           Burn{.detonation_velocity = 6930, .front_width = 0.01}};
  const Mesh mesh = box({.size = {1, 1, 1}, .cells = {1, 1, 1}});
  Explicit run{Scene{mesh.nodes, Part{Hex8{}, material, mesh.hexahedra}}};
  run.until(1e-3);
}
