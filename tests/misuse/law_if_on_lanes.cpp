// expect: an `if` on lanes has one answer for each: write select(condition, then, otherwise), or
#include <strike/strike.hpp>

using namespace strike;

struct Voce {
  double shear_modulus, yield_stress, saturation_stress, saturation_strain;
  template <class T>
  T flow_stress(const T& e) const {
    if (e > saturation_strain) return saturation_stress;
    return yield_stress + (saturation_stress - yield_stress) * (1 / saturation_strain) * e;
  }
};

int main() {
  const Solid material{LinearEos{.density = 2500, .bulk_modulus = 42e9}, Voce{29e9, 3e8, 5e8, 0.2}};
  const Mesh mesh = box({.size = {1, 1, 1}, .cells = {1, 1, 1}});
  Explicit run{Scene{mesh.nodes, Part{Hex8{}, material, mesh.hexahedra}}};
  run.until(1e-3);
}
