// expect: Simpson's rule comes with 3, 5, 7 or 9 points
#include <strike/strike.hpp>

#include "../support/plane_elastic.hpp"

using namespace strike;

int main() { const Homogeneous section{testing::PlaneElastic{200e9, 0.3}, 3.0, Simpson<4>{}}; }
