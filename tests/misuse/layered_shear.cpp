// expect: a Layered takes one shear policy and one Offset at most
#include <strike/strike.hpp>

using namespace strike;

constexpr Elastic steel{.density = 7850, .youngs_modulus = 200e9, .poissons_ratio = 0.3};

int main() { const Layered section{Layer{PlaneStress{steel}, 3.0}, EnergyShear{}, FiveSixthsShear{}}; }
