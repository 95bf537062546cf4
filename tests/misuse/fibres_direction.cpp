// expect: the fibres of a Layered have one direction from which their angles count
#include <strike/strike.hpp>

using namespace strike;

constexpr OrthotropicPly carbon{1.6e-9, 140e3, 9e3, 0.3, 5e3, 5e3, 3e3};

int main() { const Layered section{LayUp{carbon, 0.125, {0, 90}}}; }
