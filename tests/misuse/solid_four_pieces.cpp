// expect: a Solid has two or three pieces
#include <strike/strike.hpp>

using namespace strike;

int main() {
  const Solid material{LinearEos{.density = 2500, .bulk_modulus = 42e9},
                       VonMises{.shear_modulus = 29e9, .yield_stress = 4e8}, NoFailure{}, UltimateStress{5e8}};
  const Mesh mesh = box({.size = {1, 1, 1}, .cells = {1, 1, 1}});
  Explicit run{Scene{mesh.nodes, Part{Hex8{}, material, mesh.hexahedra}}};
  run.until(1e-3);
}
