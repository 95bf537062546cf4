// expect: viscosity of a material is double viscosity() const
#include <strike/strike.hpp>

using namespace strike;

struct Jelly : Elastic {
  template <class T>
  T viscosity(const State<T>&) const {
    return T(1e3);
  }
};

int main() {
  const Jelly material{{.density = 1000, .youngs_modulus = 1e6}};
  const Mesh mesh = box({.size = {1, 1, 1}, .cells = {1, 1, 1}});
  Explicit run{Scene{mesh.nodes, Part{Hex8{}, material, mesh.hexahedra}}};
  run.until(1e-3);
}
