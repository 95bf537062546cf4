#pragma once
#include <string_view>

#include <strike/cxx20.hpp>

namespace strike {

/// Semantic version of these headers. CMake reads it from this line.
inline constexpr std::string_view version = "0.1.0";

}  // namespace strike
