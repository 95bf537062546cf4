// expect: the material of a PlyStack has fibres
#include <strike/strike.hpp>

using namespace strike;

constexpr Elastic steel{.density = 7850, .youngs_modulus = 200e9, .poissons_ratio = 0.3};

int main() { const Layered section{PlyStack{{Ply{PlaneStress{steel}, 3.0}, Ply{PlaneStress{steel}, 3.0}}}}; }
