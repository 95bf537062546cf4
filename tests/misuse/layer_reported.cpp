// expect: write ZeroNormalStress for any other solid
#include <strike/strike.hpp>

using namespace strike;

int main() {
  const Solid copper{GruneisenEos{.density = 8930, .sound_speed = 3940}, ElasticStrength{.shear_modulus = 43e9}};
  const Homogeneous section{PlaneStress{copper}, 3.0};
}
