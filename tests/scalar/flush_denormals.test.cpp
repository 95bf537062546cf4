#include <limits>

#include <strike/scalar/flush_denormals.hpp>

#include "support/catch.hpp"

using namespace strike;

TEST_CASE("flush denormals: they are zero while it lives, and numbers again after") {
  volatile double least = std::numeric_limits<double>::min(), half = 0.5;
  volatile double denormal = least * half;
  CHECK(denormal > 0);
  {
    const FlushDenormals flush;
#if defined(__SSE__)
    CHECK(least * half == 0);
    CHECK(denormal * 1e300 == 0);
#endif
    CHECK(least * 2.0 * half == least);
  }
  CHECK(least * half == denormal);
}
