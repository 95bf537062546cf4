// expect: the number of lanes of a Pack must be a power of two
#include <strike/scalar/pack.hpp>

using namespace strike;

int main() {
  const Pack<double, 3> three = 1.0;
  return static_cast<int>(three[0]);
}
