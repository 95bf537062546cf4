// expect: flow_curve of a strength takes (const T& strain, double dt), or (const T& strain, const T& temperature
#include <strike/strike.hpp>

using namespace strike;

struct Own : PowerHardening {
  template <class T>
  auto flow_curve(const T& e) const {
    return e;
  }
};

int main() {
  const Solid material{LinearEos{.density = 2500, .bulk_modulus = 42e9},
                       Own{{.shear_modulus = 1e9, .coefficient = 1e6, .exponent = 0.2, .initial_strain = 0.01}}};
  const Mesh mesh = box({.size = {1, 1, 1}, .cells = {1, 1, 1}});
  Explicit run{Scene{mesh.nodes, Part{Hex8{}, material, mesh.hexahedra}}};
  run.until(1e-3);
}
