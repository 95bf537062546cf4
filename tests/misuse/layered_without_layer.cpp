// expect: a Layered needs at least one Layer{material, thickness}
#include <strike/strike.hpp>

using namespace strike;

int main() { const Layered section{FiveSixthsShear{}}; }
