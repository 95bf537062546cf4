#if __has_include(<strike/strike.hpp>)
#include <strike/strike.hpp>
#else
#include <strike/version.hpp>
#endif

const void* version_in_other_unit() { return &strike::version; }
