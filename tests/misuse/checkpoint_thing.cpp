// expect: an item of this Scene has no function serialize for a checkpoint
#include <strike/strike.hpp>

using namespace strike;

struct Wind {
  double gust = 0;
  template <class N>
  void apply_loads(N& nodes, double time) {
    gust = time;
    nodes.add_force(0, {gust, 0, 0});
  }
  template <class N>
  double power(const N& nodes) const {
    return gust * nodes.v(0).x();
  }
};

int main() {
  const Mesh mesh = box({.size = {1, 1, 1}, .cells = {1, 1, 1}});
  const Solid steel{LinearEos{.density = 7850, .bulk_modulus = 160e9},
                    VonMises{.shear_modulus = 80e9, .yield_stress = 4e8}};
  Explicit run{Scene{mesh.nodes, Part{Hex8{}, steel, mesh.hexahedra}, Wind{}}};
  run.until(1e-3, Checkpoint{"steel.checkpoint"});
}
