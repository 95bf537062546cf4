// expect: the second piece of a Fluid is its viscosity
#include <strike/strike.hpp>

using namespace strike;

int main() {
  const Mesh mesh = box({.size = {1, 1, 1}, .cells = {1, 1, 1}});
  const Solid steel{LinearEos{.density = 7850, .bulk_modulus = 160e9},
                    VonMises{.shear_modulus = 80e9, .yield_stress = 4e8}};
  const Fluid water{CubicEos{.density = 1000, .C1 = 2.2e9}, 1e-3};
  Explicit run{Scene{mesh.nodes, Part{Hex8{}, water, mesh.hexahedra}}};
  run.until(1e-3);
}
