// Two translation units with all headers link, and share what the headers define.
#if __has_include(<strike/strike.hpp>)
#include <strike/strike.hpp>
#else
#include <strike/version.hpp>
#endif

const void* version_in_other_unit();

int main() { return &strike::version == version_in_other_unit() ? 0 : 1; }
