// expect: the third piece of a Layer is the rule over its thickness
#include <strike/strike.hpp>

#include "../support/plane_elastic.hpp"

using namespace strike;

int main() { const Layered section{Layer{testing::PlaneElastic{200e9, 0.3}, 3.0, 5}}; }
