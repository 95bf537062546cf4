// expect: the second policy of Tet4 is the rotation of its tensors
#include <strike/strike.hpp>

using namespace strike;

int main() {
  const Mesh mesh = tetrahedralized(box({.size = {1, 1, 1}, .cells = {1, 1, 1}}));
  const Solid steel{LinearEos{.density = 7850, .bulk_modulus = 160e9},
                    VonMises{.shear_modulus = 80e9, .yield_stress = 4e8}};
  Explicit run{Scene{mesh.nodes, Part{Tet4{NodalPressure{}, BulkViscosity{}}, steel, mesh.tetrahedra}}};
  run.until(1e-3);
}
