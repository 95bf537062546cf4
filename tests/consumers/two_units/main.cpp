// A translation unit with all headers, of the installed package, links with another, and shares what the headers
// define. (Units of tests, too, which all have all headers, are linked together.)
#if __has_include(<strike/strike.hpp>)
#include <strike/strike.hpp>
#else
#include <strike/version.hpp>
#endif

const void* version_in_other_unit();

int main() { return &strike::version == version_in_other_unit() ? 0 : 1; }
