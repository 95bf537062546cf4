// expect: the shear policy of plies with fibres is EnergyShear{}
#include <strike/strike.hpp>

using namespace strike;

constexpr OrthotropicPly carbon{1.6e-9, 140e3, 9e3, 0.3, 5e3, 5e3, 3e3};

int main() {
  const Layered section{LayUp{carbon, 0.125, {0, 90}}, FibreDirection{{1, 0, 0}}, EffectiveShear{.length = 10}};
}
