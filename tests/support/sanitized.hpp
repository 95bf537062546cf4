#pragma once
// True under an address sanitizer, which takes several times the memory and ends a program that asks for too much.

extern "C" __attribute__((weak)) void __asan_init();

namespace strike::testing {

inline bool is_sanitized() { return &__asan_init != nullptr; }

}  // namespace strike::testing
