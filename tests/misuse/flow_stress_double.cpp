// expect: a formula of this strength takes double alone
#include <strike/strike.hpp>

using namespace strike;

struct Voce {
  double shear_modulus, yield_stress, saturation_stress, saturation_strain;
  double flow_stress(double e) const {
    return saturation_stress - (saturation_stress - yield_stress) * std::exp(-e / saturation_strain);
  }
};

int main() {
  const Solid material{LinearEos{.density = 2500, .bulk_modulus = 42e9}, Voce{29e9, 3e8, 5e8, 0.2}};
  const Mesh mesh = box({.size = {1, 1, 1}, .cells = {1, 1, 1}});
  Explicit run{Scene{mesh.nodes, Part{Hex8{}, material, mesh.hexahedra}}};
  run.until(1e-3);
}
