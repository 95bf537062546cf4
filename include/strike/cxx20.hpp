#pragma once
// Reached before any code of strike, by whichever header: older standards would answer with thousands of errors, and
// where the compiler may assume that no number is NaN, every guard against one is gone. A missing file stops the
// compiler, which #error does not.

#if __cplusplus < 202002L && (!defined(_MSVC_LANG) || _MSVC_LANG < 202002L)
#include <strike: the headers need C++20, compile with -std=c++20>
#endif

#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#include <strike: with -ffast-math a run would not see that its numbers are NaN, add -fno-finite-math-only>
#endif
