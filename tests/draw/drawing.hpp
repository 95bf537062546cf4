#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

inline std::size_t count_of(std::string_view text, std::string_view part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string_view::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

/// Tags nest and close, attributes are quoted, nothing but text stands between.
inline bool well_formed(std::string_view xml) {
  std::vector<std::string_view> open;
  std::size_t at = 0;
  while ((at = xml.find('<', at)) != std::string_view::npos) {
    const std::size_t end = xml.find('>', at);
    if (end == std::string_view::npos) return false;
    const std::string_view tag = xml.substr(at + 1, end - at - 1);
    if (tag.find('<') != std::string_view::npos || count_of(tag, "\"") % 2 != 0) return false;
    const std::string_view name = tag.substr(0, tag.find_first_of(" /", 1));
    if (tag.front() == '/') {
      if (open.empty() || open.back() != tag.substr(1)) return false;
      open.pop_back();
    } else if (tag.back() != '/' && tag.front() != '?') {
      open.push_back(name);
    }
    at = end;
  }
  return open.empty() && xml.find("nan") == std::string_view::npos && xml.find("inf") == std::string_view::npos;
}
