// expect: a Fluid has one or two pieces
#include <strike/strike.hpp>

using namespace strike;

int main() {
  const Fluid material{CubicEos{.density = 1000, .C1 = 2.2e9}, Inviscid{}, UltimateStress{5e8}};
  const Mesh mesh = box({.size = {1, 1, 1}, .cells = {1, 1, 1}});
  Explicit run{Scene{mesh.nodes, Part{Hex8{}, material, mesh.hexahedra}}};
  run.until(1e-3);
}
