// expect: the third policy of Tet4 is its bulk viscosity
#include <strike/strike.hpp>

using namespace strike;

int main() {
  const Mesh mesh = box({.size = {1, 1, 1}, .cells = {1, 1, 1}});
  const Elastic steel{.density = 7850, .youngs_modulus = 200e9, .poissons_ratio = 0.3};
  Explicit run{Scene{mesh.nodes, Part{Tet4{ElementPressure{}, Jaumann{}, EndStep{}}, steel, mesh.tetrahedra}}};
  run.until(1e-3);
}
