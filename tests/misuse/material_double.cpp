// expect: a function of this material takes double alone
#include <strike/strike.hpp>

using namespace strike;

struct Jelly : Elastic {
  using Elastic::stress;
  Moduli<double> moduli(const State<double>&, const SolidKinematics::Rate<double>&) const { return {1e6, 1e6}; }
};

int main() {
  const ZeroNormalStress layer{Jelly{{.density = 1000, .youngs_modulus = 1e6}}};
  return layer.density() > 0;
}
