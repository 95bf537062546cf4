// expect: stiffness of an hourglass control is template <class T> T stiffness
#include <strike/strike.hpp>

using namespace strike;

struct Soft : StiffnessHourglass {
  double stiffness() const { return 0.1; }
};

int main() {
  const Mesh mesh = box({.size = {1, 1, 1}, .cells = {1, 1, 1}});
  const Elastic steel{.density = 7850, .youngs_modulus = 200e9, .poissons_ratio = 0.3};
  Explicit run{Scene{mesh.nodes, Part{Hex8{Soft{}}, steel, mesh.hexahedra}}};
  run.until(1e-3);
}
