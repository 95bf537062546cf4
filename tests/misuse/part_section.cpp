// expect: wrap a solid in PlaneStress{...} or ZeroNormalStress{...}
#include <strike/strike.hpp>

using namespace strike;

int main() {
  const Mesh mesh = box({.size = {1, 1, 1}, .cells = {1, 1, 1}});
  const Elastic steel{.density = 7850, .youngs_modulus = 200e9, .poissons_ratio = 0.3};
  Explicit run{Scene{mesh.nodes, Part{Plate4{}, Layered{Layer{steel, 3.0}}, Cells<4>{}}}};
  run.until(1e-3);
}
