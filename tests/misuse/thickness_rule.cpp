// expect: Simpson's rule comes with 3, 5, 7 or 9 points
#include <strike/strike.hpp>

using namespace strike;

constexpr Elastic steel{.density = 7850, .youngs_modulus = 200e9, .poissons_ratio = 0.3};

int main() { const Homogeneous section{PlaneStress{steel}, 3.0, Simpson<4>{}}; }
