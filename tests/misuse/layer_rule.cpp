// expect: the third piece of a Layer is the rule over its thickness
#include <strike/strike.hpp>

using namespace strike;

constexpr Elastic steel{.density = 7850, .youngs_modulus = 200e9, .poissons_ratio = 0.3};

int main() { const Layered section{Layer{PlaneStress{steel}, 3.0, 5}}; }
