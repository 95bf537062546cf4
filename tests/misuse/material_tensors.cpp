// expect: spatial_tensors of a State is auto spatial_tensors() { return std::tie(...); }, not const
#include <strike/strike.hpp>

using namespace strike;

struct Jelly : Elastic {
  template <class T>
  struct State : Elastic::State<T> {
    auto spatial_tensors() const { return std::tie(this->stress); }
  };
};

int main() {
  const Jelly material{{.density = 1000, .youngs_modulus = 1e6}};
  const Mesh mesh = box({.size = {1, 1, 1}, .cells = {1, 1, 1}});
  Explicit run{Scene{mesh.nodes, Part{Hex8{}, material, mesh.hexahedra}}};
  run.until(1e-3);
}
