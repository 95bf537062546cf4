// expect: the second piece of a Solid is its strength
#include <strike/strike.hpp>

using namespace strike;

int main() {
  const PlaneStress skin{Solid{LinearEos{.density = 8930, .bulk_modulus = 130e9}, 4e8}};
  return skin.density() > 0;
}
