// expect: intact of a material is template <class T> T intact(const State<T>& state) const
#include <strike/strike.hpp>

using namespace strike;

struct Jelly : Elastic {
  bool intact() const { return true; }
};

int main() {
  const ZeroNormalStress layer{Jelly{{.density = 1000, .youngs_modulus = 1e6}}};
  return layer.density() > 0;
}
