#pragma once
// A few headers of strike under the name of all, quick to precompile.
#include <strike/material/elastic.hpp>
#include <strike/version.hpp>
