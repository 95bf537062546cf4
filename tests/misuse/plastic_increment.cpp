// expect: plastic_increment of a strength is template <class T> T plastic_increment
#include <strike/strike.hpp>

using namespace strike;

struct Voce {
  double shear_modulus, yield_stress, saturation_stress, saturation_strain;
  template <class T>
  T flow_stress(const T& e) const {
    return yield_stress + saturation_stress * e;
  }
  template <class T>
  T plastic_increment(const T& q, const T& e) const {
    return max(T(0.0), q - yield_stress - saturation_stress * e) * (1 / (3 * shear_modulus + saturation_stress));
  }
};

int main() {
  const Solid material{LinearEos{.density = 2500, .bulk_modulus = 42e9}, Voce{29e9, 3e8, 5e8, 0.2}};
  const Mesh mesh = box({.size = {1, 1, 1}, .cells = {1, 1, 1}});
  Explicit run{Scene{mesh.nodes, Part{Hex8{}, material, mesh.hexahedra}}};
  run.until(1e-3);
}
