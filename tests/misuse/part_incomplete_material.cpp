// expect: this material lacks one of State<T>, density(), stress(state, rate, dt)
#include <strike/strike.hpp>

using namespace strike;

struct Jelly {
  using Kinematics = SolidKinematics;
  template <class T>
  struct State {};
  double density() const { return 1000; }
};

int main() {
  const Mesh mesh = box({.size = {1, 1, 1}, .cells = {1, 1, 1}});
  const Solid steel{LinearEos{.density = 7850, .bulk_modulus = 160e9},
                    VonMises{.shear_modulus = 80e9, .yield_stress = 4e8}};
  Explicit run{Scene{mesh.nodes, Part{Hex8{}, Jelly{}, mesh.hexahedra}}};
  run.until(1e-3);
}
