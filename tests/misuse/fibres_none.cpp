// expect: no layer of this Layered has fibres: leave out its FibreDirection
#include <strike/strike.hpp>

using namespace strike;

constexpr Elastic steel{.density = 7850, .youngs_modulus = 200e9, .poissons_ratio = 0.3};

int main() { const Layered section{Layer{PlaneStress{steel}, 3.0}, FibreDirection{{1, 0, 0}}}; }
