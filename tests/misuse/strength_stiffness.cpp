// expect: stiffness of a strength is template <class T> T stiffness(const State<T>& state, const T& J) const
#include <strike/strike.hpp>

using namespace strike;

struct Rubber : MooneyRivlin {
  template <class T>
  T stiffness(const State<T>&) const {
    return T(2 * shear_modulus);
  }
};

int main() {
  const Solid material{LinearEos{.density = 2500, .bulk_modulus = 42e9}, Rubber{{.C10 = 1e6}}};
  const Mesh mesh = box({.size = {1, 1, 1}, .cells = {1, 1, 1}});
  Explicit run{Scene{mesh.nodes, Part{Hex8{}, material, mesh.hexahedra}}};
  run.until(1e-3);
}
