#pragma once
// True under an address sanitizer, which takes several times the memory and ends a program that asks for too much.

extern "C" __attribute__((weak)) void __asan_init();

namespace strike::testing {

inline bool is_sanitized() { return &__asan_init != nullptr; }

/// The number of repetitions of a test that repeats itself long: under sanitizers, unoptimised, a tenth of them; all
/// without, which of tests that run under sanitizers alone is left to `tests/run full`.
inline int repeated(int times) { return is_sanitized() ? (times + 9) / 10 : times; }

}  // namespace strike::testing
