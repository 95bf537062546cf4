// expect: ZeroNormalStress takes a material of solid elements
#include <strike/strike.hpp>

using namespace strike;

int main() {
  const Elastic steel{.density = 7850, .youngs_modulus = 200e9, .poissons_ratio = .3};
  return ZeroNormalStress{PlaneStress{steel}}.density() > 0;
}
