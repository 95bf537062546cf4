// expect: the second policy of Plate3 is what resists the drilling
#include <strike/strike.hpp>

using namespace strike;

int main() {
  const Mesh mesh = triangulated(rectangle({.size = {1, 1}, .cells = {1, 1}}));
  const PlaneStress steel{Elastic{.density = 7850, .youngs_modulus = 200e9, .poissons_ratio = 0.3}};
  Explicit run{
      Scene{mesh.nodes, Part{Plate3{ThicknessChange{}, ThicknessChange{}}, Homogeneous{steel, 0.01}, mesh.triangles}}};
  run.until(1e-3);
}
