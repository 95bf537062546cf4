#pragma once
#include <strike/cxx20.hpp>

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

namespace strike {

/// Guard that makes its thread treat denormal numbers as zero, as operands and as results, while it exists. On x86 each
/// of them costs some hundred cycles: bodies nearly at rest would run ten times slower than others. No effect
/// elsewhere.
class FlushDenormals {
 public:
#if defined(__SSE__)
  FlushDenormals() : before_(_mm_getcsr()) { _mm_setcsr(before_ | flush_results | operands_are_zero); }
  ~FlushDenormals() { _mm_setcsr(before_); }
#else
  FlushDenormals() {}
  ~FlushDenormals() {}
#endif
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;

 private:
#if defined(__SSE__)
  static constexpr unsigned flush_results = 0x8000, operands_are_zero = 0x0040;  // of MXCSR
  unsigned before_;
#endif
};

}  // namespace strike
