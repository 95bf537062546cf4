#pragma once
// Reached before any code of strike, by whichever header: older standards would answer with thousands of errors. A
// missing file stops the compiler, which #error does not.

#if __cplusplus < 202002L && (!defined(_MSVC_LANG) || _MSVC_LANG < 202002L)
#include <strike: the headers need C++20, compile with -std=c++20>
#endif
