#pragma once
#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

namespace bench {

inline std::string formatted(const char* format, double number) {
  char text[64];
  std::snprintf(text, sizeof text, format, number);
  return text;
}

/// A row of a table in Markdown.
inline std::string row(const std::vector<std::string>& cells) {
  std::string text = "|";
  for (const std::string& cell : cells) text += cell.empty() ? " |" : " " + cell + " |";
  return text += '\n';
}

/// The head of a table in Markdown: a column of names, the others of numbers.
inline std::string head(const std::vector<std::string>& cells) {
  std::string text = row(cells) + "|---|";
  for (std::size_t i = 1; i < cells.size(); ++i) text += "--:|";
  return text += '\n';
}

}  // namespace bench
