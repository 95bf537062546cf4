// expect: this failure law needs a member of the state that this Solid does not have
#include <strike/strike.hpp>

using namespace strike;

int main() {
  const Solid material{LinearEos{.density = 2500, .bulk_modulus = 42e9}, ElasticStrength{.shear_modulus = 29e9},
                       FailureStrain{0.5}};
  const Mesh mesh = box({.size = {1, 1, 1}, .cells = {1, 1, 1}});
  Explicit run{Scene{mesh.nodes, Part{Hex8{}, material, mesh.hexahedra}}};
  run.until(1e-3);
}
