// expect: this strength has a flow_stress of its own, but the plastic_increment or flow_curve of its base
#include <strike/strike.hpp>

using namespace strike;

struct Own : JohnsonCook {
  template <class T>
  T flow_stress(const T& e, const T&, const T&) const {
    return A + B * e;
  }
};

int main() {
  const Solid material{LinearEos{.density = 2500, .bulk_modulus = 42e9},
                       Own{{.shear_modulus = 1e9, .A = 1e6, .B = 1e6, .n = 1}}};
  const Mesh mesh = box({.size = {1, 1, 1}, .cells = {1, 1, 1}});
  Explicit run{Scene{mesh.nodes, Part{Hex8{}, material, mesh.hexahedra}}};
  run.until(1e-3);
}
