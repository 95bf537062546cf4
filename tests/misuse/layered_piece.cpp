// expect: a Layered is made of Layer{material, thickness}, bottom first
#include <strike/strike.hpp>

using namespace strike;

constexpr Elastic steel{.density = 7850, .youngs_modulus = 200e9, .poissons_ratio = 0.3};

int main() { const Layered section{Layer{PlaneStress{steel}, 3.0}, 4.0}; }
