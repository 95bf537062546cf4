// expect: A(mu) of this equation of state takes double alone
#include <strike/strike.hpp>

using namespace strike;

struct Murnaghan {
  double density, K, n;
  double A(double mu) const { return K / n * (std::pow(1 + mu, n) - 1); }
};

int main() {
  const Solid material{Murnaghan{2500, 42e9, 4}, ElasticStrength{.shear_modulus = 29e9}};
  const Mesh mesh = box({.size = {1, 1, 1}, .cells = {1, 1, 1}});
  Explicit run{Scene{mesh.nodes, Part{Hex8{}, material, mesh.hexahedra}}};
  run.until(1e-3);
}
