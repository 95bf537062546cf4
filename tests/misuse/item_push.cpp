// expect: an item adds forces in apply_loads(nodes, time)
#include <strike/strike.hpp>
using namespace strike;
const Mesh bar = box({.size = {1, 1, 1}, .cells = {1, 1, 1}});
const Solid steel{LinearEos{.density = 7850, .bulk_modulus = 160e9},
                  VonMises{.shear_modulus = 80e9, .yield_stress = 4e8}};
struct Gravity {
  template <class N>
  void push(N& nodes, double) {
    nodes.add_force(0, {0, 0, -9.81});
  }
  template <class N>
  void begin(N&) {}
};
int main() {
  Explicit run{Scene{bar.nodes, Part{Hex8{}, steel, bar.hexahedra}, Gravity{}}};
  run.until(1e-3);
}
