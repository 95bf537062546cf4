#pragma once
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <initializer_list>
#include <memory>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <strike/error.hpp>
#include <strike/output/file.hpp>
#include <strike/text.hpp>

namespace strike {

/// Number of a node, an element, a part or a set in its file, from 1.
using FileNumber = std::int64_t;

namespace detail {

/// Upper bound of the numbers in a file, itself not allowed.
inline constexpr FileNumber number_limit = FileNumber(1) << 40;

/// The content of a file or a pipe. Errors: it cannot be read; it is a device, is binary, or does not fit in memory.
inline std::string content_of_file(const std::string& path) {
  const auto refuse = [&](std::string_view why) { throw Error(joined({"strike: the file '", path, "' ", why})); };
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file) refuse("cannot be opened for reading: check its name and folder.");
  std::string content;
  try {
    if (std::uint64_t bytes = 0; has_size(path, bytes)) content.reserve(static_cast<std::size_t>(bytes) + 1);
    std::array<char, 1 << 16> buffer;
    while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), file.get())) {
      const std::string_view read(buffer.data(), count);
      if (read.find('\0') != read.npos) refuse("is binary: save it as text.");
      content += read;
    }
  } catch (const std::bad_alloc&) {
    refuse("does not fit in memory: give a smaller one.");
  } catch (const std::length_error&) {
    refuse("does not fit in memory: give a smaller one.");
  }
  if (std::ferror(file.get())) refuse("cannot be read: give the path of a file.");
  return content;
}

/// The result of a reader. Error: it does not fit in memory.
template <class Read>
auto within_memory(const std::string& name, const Read& read) {
  try {
    return read();
  } catch (const std::bad_alloc&) {
    throw Error(joined({"strike: the mesh of the file '", name, "' does not fit in memory: give a smaller one."}));
  }
}

inline bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\v'; }

inline std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

inline char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

inline std::string upper(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = upper(c);
  return result;
}

inline bool same_word(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) { return upper(x) == upper(y); });
}

/// Removes the text before the first `mark`, and the mark; returns the text removed.
inline std::string_view taken(std::string_view& text, char mark) {
  const std::size_t end = std::min(text.find(mark), text.size());
  const std::string_view head = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return head;
}

/// A finite number in any of the ways of C and Fortran: 1e-3, 1.0D+3, 1.5-3.
inline std::optional<double> to_number(std::string_view field) {
  field = trimmed(field);
  if (field.size() > 1 && field[0] == '+' && field[1] != '-') field.remove_prefix(1);
  const auto whole = [](std::string_view text) -> std::optional<double> {
    double value = 0;
    const char* const last = text.data() + text.size();
    const auto [end, failure] = std::from_chars(text.data(), last, value);
    if (failure != std::errc{} || end != last || !std::isfinite(value)) return std::nullopt;
    return value;
  };
  if (const auto value = whole(field)) return value;
  std::array<char, 64> plain;
  if (field.size() + 1 > plain.size()) return std::nullopt;
  std::size_t length = 0;
  bool exponent = false;
  for (std::size_t i = 0; i < field.size(); ++i) {
    const char c = field[i];
    const bool letter = upper(c) == 'D' || upper(c) == 'E', sign = c == '+' || c == '-';
    if (i > 0 && !exponent && (letter || sign)) {
      exponent = true;
      plain[length++] = 'e';
      if (c == '-') plain[length++] = c;
    } else if (c != '+' || i == 0 || upper(field[i - 1]) < 'D' || upper(field[i - 1]) > 'E') {
      plain[length++] = c;
    }
  }
  return whole({plain.data(), length});
}

/// A whole number, which may be written 12. or 12.0.
inline std::optional<FileNumber> to_integer(std::string_view field) {
  field = trimmed(field);
  FileNumber value = 0;
  const char* const last = field.data() + field.size();
  if (const auto [end, failure] = std::from_chars(field.data(), last, value); failure == std::errc{} && end == last)
    return value;
  const auto number = to_number(field);
  if (!number || *number != std::floor(*number) || std::abs(*number) > 9e15) return std::nullopt;
  return static_cast<FileNumber>(*number);
}

/// The start of a text, as a message quotes it.
[[gnu::cold]] inline std::string shown(std::string_view text) {
  std::string result = "'";
  for (const char c : trimmed(text).substr(0, 40)) result += c >= ' ' && c <= '~' ? c : '?';
  return result + (trimmed(text).size() > 40 ? "...'" : "'");
}

/// A text being read, line by line. Lines end with LF, CR LF or CR; a byte-order mark of UTF-8 is no text.
class Source {
 public:
  /// Error: the text holds a byte 0.
  Source(std::string_view text, std::string name)
      : rest_(text),
        size_(text.size()),
        name_(std::move(name)),
        end_of_line_(text.find('\n') < text.npos ? '\n' : '\r') {
    if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
    if (const std::size_t zero = text.find('\0'); zero != text.npos)
      refuse(
          1 + static_cast<std::uint32_t>(std::count(text.begin(), text.begin() + std::ptrdiff_t(zero), end_of_line_)),
          {"a byte is 0, as in binary files and UTF-16: save the file as text in ASCII or UTF-8."});
  }

  /// Size of the text [bytes].
  std::size_t size() const { return size_; }
  /// The next line, without its end.
  bool next(std::string_view& line) {
    if (rest_.empty()) return false;
    line = taken(rest_, end_of_line_);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    ++line_;
    return true;
  }
  /// The first character of the next line.
  char peek() const { return rest_.empty() ? '\0' : rest_.front(); }
  /// True if the next line, after blanks, starts with the text.
  bool next_begins_with(std::string_view mark) const {
    const std::size_t first = rest_.find_first_not_of(" \t");
    return first != rest_.npos && rest_.substr(first, mark.size()) == mark;
  }
  /// The number of the last line, from 1.
  std::uint32_t line() const { return line_; }

  /// Throws an Error with file and line: what is wrong there, and what to do.
  [[noreturn, gnu::cold]] void refuse(std::uint32_t line, std::initializer_list<std::string_view> what) const {
    throw Error(joined({"strike: the file '", name_, "', line ", std::to_string(line), ": ", joined(what)}));
  }
  [[noreturn, gnu::cold]] void refuse(std::initializer_list<std::string_view> what) const { refuse(line_, what); }

  double number(std::string_view field, std::string_view meaning) const {
    const auto value = to_number(field);
    if (!value) refuse_field(field, meaning, " is no number: write it as 1.5 or 1.5e-3.");
    return *value;
  }
  FileNumber integer(std::string_view field, std::string_view meaning) const {
    const auto value = to_integer(field);
    if (!value) refuse_field(field, meaning, " is no whole number: correct it.");
    return *value;
  }
  /// The number of a node, element, part or set, within its bounds.
  FileNumber tag(std::string_view field, std::string_view meaning, FileNumber least = 1) const {
    const FileNumber n = integer(field, meaning);
    if (n < least || n >= number_limit)
      refuse({meaning, " ", std::to_string(n), " is out of bounds: number from 1 to 10^12."});
    return n;
  }

 private:
  [[noreturn, gnu::cold]] void refuse_field(std::string_view field, std::string_view meaning,
                                            std::string_view why) const {
    const bool parameter = trimmed(field).substr(0, 2).find_first_of("&<") != field.npos;
    refuse({meaning, " ", shown(field), parameter ? " is a parameter, which is not replaced: write its value." : why});
  }

  std::string_view rest_;
  std::size_t size_;
  std::string name_;
  char end_of_line_;
  std::uint32_t line_ = 0;
};

/// Skipped input by name, with count and lines.
class Skipped {
 public:
  void add(std::string_view name, std::uint32_t line, std::size_t count = 1) {
    const auto known = std::find_if(kinds_.begin(), kinds_.end(), [&](const Kind& k) { return k.name == name; });
    if (known == kinds_.end() && kinds_.size() < 200)
      kinds_.push_back({std::string(name), count, {line}});
    else if (known == kinds_.end())
      ++further_;
    else if (known->count += count; known->lines.size() < 5 && known->lines.back() != line)
      known->lines.push_back(line);
  }
  /// The first name with this beginning, and its line; empty if there is none.
  std::string place_of(std::string_view beginning) const {
    for (const Kind& kind : kinds_)
      if (kind.name.starts_with(beginning)) return joined({kind.name, " on line ", std::to_string(kind.lines.front())});
    return {};
  }
  /// Adds the warnings: "*DAMPING_GLOBAL (2) was skipped: lines 12, 40."
  void tell(std::vector<std::string>& all, std::string_view why) const {
    for (const auto& [name, count, lines] : kinds_) {
      std::string places = lines.size() == 1 ? "line " : "lines ";
      for (const std::uint32_t line : lines) places += std::to_string(line) + ", ";
      places.resize(places.size() - 2);
      all.push_back(joined(
          {name, " (", std::to_string(count), ")", why, places, lines.size() == 5 && count > 5 ? ", ..." : "."}));
    }
    if (further_ > 0) all.push_back(joined({"Others (", std::to_string(further_), ")", why, "not listed."}));
  }

 private:
  struct Kind {
    std::string name;
    std::size_t count;
    std::vector<std::uint32_t> lines;
  };
  std::vector<Kind> kinds_;
  std::size_t further_ = 0;
};

}  // namespace detail
}  // namespace strike
