#include <strike/material/elastic.hpp>
#include <strike/version.hpp>

const void* version_in_other_unit() { return &strike::version; }
