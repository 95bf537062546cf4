// expect: Debris is the law of a part of particles
#include <strike/strike.hpp>

using namespace strike;

int main() {
  const Mesh mesh = box({.size = {1, 1, 1}, .cells = {1, 1, 1}});
  const Solid steel{LinearEos{.density = 7850, .bulk_modulus = 160e9},
                    VonMises{.shear_modulus = 80e9, .yield_stress = 4e8}};
  Explicit run{Scene{mesh.nodes, Part{Hex8{}, steel, mesh.hexahedra, Debris{.of = 0}}}};
  run.until(1e-3);
}
