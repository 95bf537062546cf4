// expect: this equation of state has an initial_energy and no B(mu)
#include <strike/strike.hpp>

using namespace strike;

struct Hot : LinearEos {
  double initial_energy;
};

int main() {
  const Solid material{Hot{{.density = 2500, .bulk_modulus = 42e9}, 1e6}, ElasticStrength{.shear_modulus = 29e9}};
  const Mesh mesh = box({.size = {1, 1, 1}, .cells = {1, 1, 1}});
  Explicit run{Scene{mesh.nodes, Part{Hex8{}, material, mesh.hexahedra}}};
  run.until(1e-3);
}
