// expect: a Layered is made of Layer{material, thickness}, bottom first
#include <strike/strike.hpp>

#include "../support/plane_elastic.hpp"

using namespace strike;

int main() { const Layered section{Layer{testing::PlaneElastic{200e9, 0.3}, 3.0}, 4.0}; }
