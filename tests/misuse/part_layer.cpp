// expect: strike: the elements of this part have no layers: leave the layer out, as in field(f).
#include <strike/strike.hpp>

using namespace strike;

int main() {
  const Mesh mesh = box({.size = {1, 1, 1}});
  const Elastic rubber{.density = 1000, .youngs_modulus = 1e6};
  Explicit run{Scene{mesh.nodes, Part{Hex8{}, rubber, mesh.hexahedra}}};
  return run.part<0>().field(2, EquivalentStress{}).empty();
}
