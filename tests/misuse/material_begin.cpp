// expect: begin of a material is template <class T> void begin(State<T>& state) const
#include <strike/strike.hpp>

using namespace strike;

struct Jelly : Elastic {
  template <class T>
  State<T> begin() const {
    return {};
  }
};

int main() {
  const ZeroNormalStress layer{Jelly{{.density = 1000, .youngs_modulus = 1e6}}};
  return layer.density() > 0;
}
