// expect: PhysicalHourglass knows isotropic layers alone
#include <strike/strike.hpp>

using namespace strike;

int main() {
  const Mesh mesh = rectangle({.size = {1, 1}, .cells = {1, 1}});
  const OrthotropicPly carbon{1.6e-9, 140e3, 9e3, 0.3, 5e3, 5e3, 3e3};
  const Layered section{LayUp{carbon, 0.125, {0, 90}}, FibreDirection{{1, 0, 0}}};
  Explicit run{Scene{mesh.nodes, Part{Plate4{PhysicalHourglass{}}, section, mesh.quadrilaterals}}};
  run.until(1e-9);
}
