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
  const ZeroNormalStress layer{Jelly{{.density = 1000, .youngs_modulus = 1e6}}};
  return layer.density() > 0;
}
