// expect: a function of this material takes double alone
#include <strike/strike.hpp>

using namespace strike;

struct Jelly : Elastic {
  using Elastic::stress;
  Moduli<double> moduli(const State<double>&, const SolidKinematics::Rate<double>&) const { return {1e6, 1e6}; }
};

int main() {
  const Jelly material{{.density = 1000, .youngs_modulus = 1e6}};
  const Mesh mesh = box({.size = {1, 1, 1}, .cells = {1, 1, 1}});
  Explicit run{Scene{mesh.nodes, Part{Hex8{}, material, mesh.hexahedra}}};
  run.until(1e-3);
}
