// expect: check_parts of an item is a constant function
#include <strike/strike.hpp>
using namespace strike;
const Mesh bar = box({.size = {1, 1, 1}, .cells = {1, 1, 1}});
const Elastic steel{.density = 7850, .youngs_modulus = 210e9, .poissons_ratio = 0.3};
struct Sensor {
  template <class N>
  void begin(const N&) {}
  void check_parts(std::size_t parts) const {
    if (parts < 2) throw Error("two parts are needed");
  }
};
int main() {
  Explicit run{Scene{bar.nodes, Part{Hex8{}, steel, bar.hexahedra}, Sensor{}}};
  run.until(1e-3);
  return run.energy().error() > 0;
}
