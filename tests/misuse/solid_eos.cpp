// expect: the first piece of a Solid is its equation of state
#include <strike/strike.hpp>

using namespace strike;

int main() {
  const Mesh mesh = box({.size = {1, 1, 1}, .cells = {1, 1, 1}});
  const Solid steel{LinearEos{.density = 7850, .bulk_modulus = 160e9},
                    VonMises{.shear_modulus = 80e9, .yield_stress = 4e8}};
  const Solid copper{VonMises{.shear_modulus = 43e9, .yield_stress = 4e8},
                     LinearEos{.density = 8930, .bulk_modulus = 130e9}};
  Explicit run{Scene{mesh.nodes, Part{Hex8{}, copper, mesh.hexahedra}}};
  run.until(1e-3);
}
