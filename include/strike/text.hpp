#pragma once
#include <charconv>
#include <cstdio>
#include <initializer_list>
#include <string>
#include <string_view>

#include <strike/cxx20.hpp>

// Text is not worth inlining: that is what `cold` says, and it saves the compiler a second.
namespace strike::detail {

/// The parts one after the other. (Chains of + cost the compiler far more.)
[[gnu::cold]] inline std::string joined(std::initializer_list<std::string_view> parts) {
  std::string whole;
  for (const std::string_view part : parts) whole += part;
  return whole;
}

/// The name of a type, among other words of the compiler.
template <class T>
constexpr std::string_view name_of() {
  return __PRETTY_FUNCTION__;
}

/// A number as a message shows it: six significant digits.
[[gnu::cold]] inline std::string text(double number) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%g", number);
  return buffer;
}

/// The shortest text that reads back as the same number; "nan" and "inf" as such.
[[gnu::cold]] inline std::string shortest(double number) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, number).ptr;
  return {buffer, end};
}

}  // namespace strike::detail
