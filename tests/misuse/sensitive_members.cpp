// expect: after its parameters Sensitive names as many members of its law
#include <strike/strike.hpp>

using namespace strike;

int main() {
  const std::array p{Dual<double, 2>::variable(4e8, 0), Dual<double, 2>::variable(1e8, 1)};
  const VonMises law{.shear_modulus = 80e9, .yield_stress = 4e8};
  const Solid steel{LinearEos{.density = 7850, .bulk_modulus = 160e9}, Sensitive{law, p, &VonMises::yield_stress}};
  return static_cast<int>(steel.density());
}
