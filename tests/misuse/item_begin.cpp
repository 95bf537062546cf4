// expect: begin of an item is called as begin(nodes), or as begin(nodes, parts)
#include <strike/strike.hpp>
using namespace strike;
const Mesh bar = box({.size = {1, 1, 1}, .cells = {1, 1, 1}});
const Elastic steel{.density = 7850, .youngs_modulus = 210e9, .poissons_ratio = 0.3};
struct Sensor {
  template <class N>
  void begin(const N&, int parts) const {
    if (parts < 2) throw Error("two parts are needed");
  }
};
int main() {
  Explicit run{Scene{bar.nodes, Part{Hex8{}, steel, bar.hexahedra}, Sensor{}}};
  run.until(1e-3);
  return run.energy().error() > 0;
}
