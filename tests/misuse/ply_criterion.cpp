// expect: the second piece of a FailingPly is its criterion
#include <strike/strike.hpp>

using namespace strike;

int main() {
  const OrthotropicPly carbon{1.6e-9, 140e3, 9e3, 0.3, 5e3, 5e3, 3e3};
  const Layered section{LayUp{FailingPly{carbon, UltimateStress{2e3}}, 0.125, {0, 90}}, FibreDirection{{1, 0, 0}}};
}
