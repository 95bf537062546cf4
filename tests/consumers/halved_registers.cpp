// Compiled for Zen 4 by the name that older compilers give it: registers of 512 bits on which it works by halves.
#include <strike/scalar/pack.hpp>

#ifndef __AVX512F__
#error "compile it with -march=znver3 -mavx512f"
#endif
static_assert(strike::native_lanes<double> == 4 && strike::native_lanes<float> == 8);
