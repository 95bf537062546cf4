// expect: strike: with -ffast-math a run would not see that its numbers are NaN, add -fno-finite-math-only
// flags: -ffast-math
#include <strike/strike.hpp>

int main() {}
