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
  const ZeroNormalStress layer{Jelly{{.density = 1000, .youngs_modulus = 1e6}}};
  return layer.density() > 0;
}
