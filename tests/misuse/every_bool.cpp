// expect: an observer returns a bool
#include <strike/strike.hpp>
using namespace strike;
const Mesh bar = box({.size = {1, 1, 1}, .cells = {1, 1, 1}});
const Solid steel{LinearEos{.density = 7850, .bulk_modulus = 160e9},
                  VonMises{.shear_modulus = 80e9, .yield_stress = 4e8}};
int main() {
  Explicit run{Scene{bar.nodes, Part{Hex8{}, steel, bar.hexahedra}}};
  run.until(1e-3, Every{0.1, [&] { return run.energy().kinetic > 0; }});
}
