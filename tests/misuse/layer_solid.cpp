// expect: wrap a solid in PlaneStress{...} or ZeroNormalStress{...}
#include <strike/strike.hpp>

using namespace strike;

int main() {
  const Solid steel{LinearEos{.density = 7850, .bulk_modulus = 160e9},
                    VonMises{.shear_modulus = 80e9, .yield_stress = 4e8}};
  const Layered section{Layer{steel, 3.0}};
}
