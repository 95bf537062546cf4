// expect: PlaneStress is for Elastic and for a Solid of LinearEos and a flow law or ElasticStrength
#include <strike/strike.hpp>

using namespace strike;

int main() {
  const Solid copper{GruneisenEos{.density = 8930, .sound_speed = 3940, .S1 = 1.489, .gamma = 1.99},
                     VonMises{.shear_modulus = 43e9, .yield_stress = 4e8}};
  return PlaneStress{copper}.density() > 0;
}
