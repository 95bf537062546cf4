// expect: the first policy of Plate3 is its thickness
#include <strike/strike.hpp>

using namespace strike;

int main() {
  const Mesh mesh = triangulated(rectangle({.size = {1, 1}, .cells = {1, 1}}));
  const PlaneStress steel{Elastic{.density = 7850, .youngs_modulus = 200e9, .poissons_ratio = 0.3}};
  Explicit run{Scene{mesh.nodes, Part{Plate3{PlateHourglass{}}, Homogeneous{steel, 0.01}, mesh.triangles}}};
  run.until(1e-3);
}
