#pragma once
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <initializer_list>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

#include <strike/error.hpp>
#include <strike/output/file.hpp>
#include <strike/text.hpp>

namespace strike {

/// Number of a node, an element, a part or a set in its file, from 1.
using FileNumber = std::int64_t;

/// Treatment of cells of second order, with nodes between their corners: an error, only their corners, or pieces at
/// their mid nodes.
enum class SecondOrder { refused, to_corners, in_pieces };

/// Options of the readers of decks.
struct ReadOptions {
  std::string folder = {};          ///< of included files; that of the deck, or none for a text in memory, if empty
  bool anywhere = false;            ///< included files may stand outside of that folder
  bool leave_out_elements = false;  ///< of kinds that are not read, with a warning; an error otherwise
  SecondOrder second_order = SecondOrder::refused;  ///< cells of second order, which are cut to first with a warning
};

namespace detail {

/// Upper bound of the numbers in a file, itself not allowed.
inline constexpr FileNumber number_limit = FileNumber(1) << 40;

/// The content of a file or a pipe. Errors: it cannot be read; it is a device or does not fit in memory; it is binary,
/// unless it may be.
inline std::string content_of_file(const std::string& path, bool may_be_binary = false) {
  const auto refuse = [&](std::string_view why) { throw Error(joined({"strike: the file '", path, "' ", why})); };
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file) refuse("cannot be opened for reading: check its name and folder.");
  std::string content;
  try {
    if (std::uint64_t bytes = 0; has_size(path, bytes)) content.reserve(static_cast<std::size_t>(bytes) + 1);
    std::array<char, 1 << 16> buffer;
    while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), file.get())) {
      const std::string_view read(buffer.data(), count);
      if (!may_be_binary && read.find('\0') != read.npos) refuse("is binary: save it as text.");
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

inline bool is_blank(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return is_blank(c); });
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

/// Removes a number as C++ writes it and the mark behind it; nothing is removed if the text begins otherwise.
template <class Number>
std::optional<Number> taken_number(std::string_view& text, char mark) {
  const char *first = text.data(), *const last = first + text.size();
  while (first != last && *first == ' ') ++first;
  Number value{};
  const auto [end, failure] = std::from_chars(first, last, value);
  if (failure != std::errc{} || (end != last && *end != mark)) return std::nullopt;
  if constexpr (std::is_floating_point_v<Number>)
    if (!std::isfinite(value)) return std::nullopt;
  text = {end == last ? end : end + 1, last};
  return value;
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

/// The path without symbolic links; empty if nothing is there.
[[gnu::cold]] inline std::string canonical(const std::string& path) {
  const std::unique_ptr<char, void (*)(void*)> real(::realpath(path.c_str(), nullptr), &std::free);
  return real ? std::string(real.get()) : std::string();
}

/// The folder of a file, as its path names it.
[[gnu::cold]] inline std::string folder_of(const std::string& path) {
  const std::size_t end = path.rfind('/');
  return end == path.npos ? "." : end == 0 ? "/" : path.substr(0, end);
}

/// A text being read, line by line, and the files that it includes. Lines end with LF, CR LF or CR; a byte-order mark
/// of UTF-8 is no text. Lines are counted through all files, so that a line's number tells its file too.
class Source {
 public:
  /// Limits of what a text includes: files within files, and files in all.
  static constexpr std::size_t deepest = 32, most_files = 10'000;

  /// Error: the text holds a byte 0.
  Source(std::string_view text, std::string name) : Source(text, std::move(name), {}) {}
  /// A text of lines and of bytes between them. `expect_text` refuses one of bytes.
  static Source binary(std::string_view text, std::string name) {
    Source source({}, std::move(name));
    source.begin(text, true);
    return source;
  }
  /// `options.folder` is that of included files; without it there are none.
  Source(std::string_view text, std::string name, ReadOptions options) : options_(std::move(options)) {
    if (!options_.folder.empty()) root_ = canonical(options_.folder);
    if (folder_of(name) == options_.folder) current_.real = canonical(name);
    names_.push_back(std::move(name));
    begin(text);
  }
  Source(Source&&) = default;

  /// Size of the texts so far; a file that is included twice counts twice [bytes].
  std::size_t size() const { return size_; }
  /// The next line, without its end. False at the end of the text, or of the included file.
  bool next(std::string_view& line) {
    if (current_.rest.empty()) return false;
    line = taken(current_.rest, current_.end_of_line);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    ++line_;
    return true;
  }
  /// The next bytes, fewer at the end of the text. Lines count the ends of lines among them.
  std::string_view bytes(std::size_t count) {
    const std::string_view read = current_.rest.substr(0, count);
    current_.rest.remove_prefix(read.size());
    line_ += static_cast<std::uint32_t>(std::count(read.begin(), read.end(), '\n'));
    return read;
  }
  /// How many bytes are left.
  std::size_t bytes_left() const { return current_.rest.size(); }
  /// Error: what is left holds a byte 0.
  void expect_text() const { expect_text(current_.rest, line_); }
  /// The first character of the next line; '\0' at the end of the text, or of the included file.
  char peek() const { return current_.rest.empty() ? '\0' : current_.rest.front(); }
  /// The next line, which is next again.
  std::string_view peek_line() const { return current_.rest.substr(0, current_.rest.find(current_.end_of_line)); }
  /// About how many lines there are before the next mark, if all are as long as the next one.
  std::size_t lines_before(char mark) const {
    const std::size_t bytes = std::min(current_.rest.find(mark), current_.rest.size());
    return 1 + bytes / std::max<std::size_t>(peek_line().size(), 16);
  }
  /// True if the next line, after blanks, starts with the text.
  bool next_begins_with(std::string_view mark) const {
    const std::size_t first = current_.rest.find_first_not_of(" \t");
    return first != current_.rest.npos && current_.rest.substr(first, mark.size()) == mark;
  }
  /// The number of the last line, from 1, through all files.
  std::uint32_t line() const { return line_; }

  /// Goes into an included file; `leave` returns behind the last line. `folders` are searched after the deck's and that
  /// of the including file. Lines of a file may be kept until the file after it is left. Errors: there is no such file;
  /// it stands outside of the deck's folder, which `anywhere` allows; it includes itself; more files than the limits.
  [[gnu::cold]] void include(std::string_view file, std::span<const std::string> folders = {}) {
    if (root_.empty())
      refuse({"the file ", shown(file), " is included by a text in memory: give the folder of its files."});
    const std::string path = found(file, folders), real = canonical(path);
    const auto is_open = [&](const Text& text) { return text.real == real; };
    if (is_open(current_) || std::any_of(outer_.begin(), outer_.end(), is_open))
      refuse({"the file ", shown(file), " includes itself: take one *INCLUDE out."});
    if (outer_.size() >= deepest)
      refuse({"files are included in files more than ", std::to_string(deepest), " deep: include ", shown(file),
              " from a file further up."});
    if (names_.size() > most_files)
      refuse({"more than ", std::to_string(most_files), " files are included: put their texts together."});
    auto content = std::make_unique<const std::string>(content_of_file(path));
    outer_.push_back(std::move(current_));
    const Place at = places_.empty() ? Place{0, 0, 0} : places_.back();
    current_ = {.outer_lines = line_ - at.before + at.lines,
                .real = real,
                .name = names_.size(),
                .content = std::move(content)};
    names_.push_back(path);
    begin(*current_.content);
    places_.push_back({line_, current_.name, 0});
  }
  /// Returns from an included file. False in the outermost text.
  [[gnu::cold]] bool leave() {
    if (outer_.empty()) return false;
    last_ = std::move(current_.content);
    const std::uint32_t lines = current_.outer_lines;
    current_ = std::move(outer_.back());
    outer_.pop_back();
    places_.push_back({line_, current_.name, lines});
    return true;
  }
  /// The folder of included files; empty if there is none.
  const std::string& folder() const { return options_.folder; }
  /// Depth of the file being read: 0 in the outermost text.
  std::size_t depth() const { return outer_.size(); }

  /// A line as a sentence on the deck names it: "12", and "4 of 'mesh.k'" in an included file.
  [[gnu::cold]] std::string place(std::uint32_t line) const { return place(line, 0); }
  /// The same in a sentence on another line: the file is named where it is another one.
  [[gnu::cold]] std::string place_beside(std::uint32_t line, std::uint32_t other) const {
    return place(line, place_of(other).name);
  }

  /// Throws an Error with file and line: what is wrong there, and what to do.
  [[noreturn, gnu::cold]] void refuse(std::uint32_t line, std::initializer_list<std::string_view> what) const {
    const Place at = place_of(line);
    throw Error(joined({"strike: the file '", names_[at.name], "', line ", std::to_string(line - at.before + at.lines),
                        ": ", joined(what)}));
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
    return expect_tag(integer(field, meaning), meaning, least);
  }
  FileNumber expect_tag(FileNumber n, std::string_view meaning, FileNumber least = 1) const {
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

  /// A text that is being read, or goes on after an included file.
  struct Text {
    std::string_view rest = {};
    char end_of_line = '\n';
    std::uint32_t outer_lines = 0;  ///< of the file that includes it, so far
    std::string real = {};          ///< its path without symbolic links
    std::size_t name = 0;
    std::unique_ptr<const std::string> content = {};
  };
  /// Lines after `before`, through all files, are those after the first `lines` of the file.
  struct Place {
    std::uint32_t before;
    std::size_t name;
    std::uint32_t lines;
  };

  void begin(std::string_view text, bool may_be_binary = false) {
    current_.rest = text;
    current_.end_of_line = text.find('\n') < text.npos ? '\n' : '\r';
    if (text.starts_with("\xEF\xBB\xBF")) current_.rest.remove_prefix(3);
    size_ += text.size();
    if (!may_be_binary) expect_text(text, 0);
  }
  void expect_text(std::string_view text, std::uint32_t lines_before) const {
    const std::size_t zero = text.find('\0');
    if (zero == text.npos) return;
    const auto lines = std::count(text.begin(), text.begin() + std::ptrdiff_t(zero), current_.end_of_line);
    throw Error(
        joined({"strike: the file '", names_[current_.name], "', line ", std::to_string(1 + lines_before + lines),
                ": a byte is 0, as in binary files and UTF-16: save the file as text in ASCII or UTF-8."}));
  }
  Place place_of(std::uint32_t line) const {
    const auto after = std::lower_bound(places_.begin(), places_.end(), line,
                                        [](const Place& place, std::uint32_t number) { return place.before < number; });
    return after == places_.begin() ? Place{0, 0, 0} : *(after - 1);
  }
  std::string place(std::uint32_t line, std::size_t known) const {
    const Place at = place_of(line);
    const std::string number = std::to_string(line - at.before + at.lines);
    return at.name == known ? number : joined({number, " of '", names_[at.name], "'"});
  }
  /// The path of an included file: below the deck's folder, the including file's, or one of `folders`.
  std::string found(std::string_view file, std::span<const std::string> folders) const {
    std::string name(file);
    std::replace(name.begin(), name.end(), '\\', '/');
    std::vector<std::string> all{options_.folder};
    if (!outer_.empty()) all.push_back(folder_of(names_[current_.name]));
    all.insert(all.end(), folders.begin(), folders.end());
    if (name.starts_with('/')) all = {""};
    std::string outside;
    for (const std::string& folder : all) {
      const std::string path = folder.empty() || folder == "." ? name : joined({folder, "/", name});
      std::uint64_t bytes = 0;
      if (!has_size(path, bytes)) continue;
      if (options_.anywhere || canonical(path).starts_with(root_ == "/" ? root_ : root_ + "/")) return path;
      outside = path;
    }
    if (outside.empty())
      refuse({"the included file ", shown(file), " is not there: correct its name, or put it into the folder '",
              options_.folder, "'."});
    refuse({"the included file '", outside, "' is outside of the folder '", options_.folder,
            "': move it there, or allow it with {.anywhere = true}."});
  }

  ReadOptions options_;
  std::string root_ = {};  ///< the folder of included files, without symbolic links
  Text current_ = {};
  std::vector<Text> outer_ = {};
  std::unique_ptr<const std::string> last_ = {};  ///< of the file that was left last
  std::vector<std::string> names_ = {};
  std::vector<Place> places_ = {};
  std::size_t size_ = 0;
  std::uint32_t line_ = 0;
};

/// Skipped input by name, with count and lines.
class Skipped {
 public:
  void add(std::string_view name, std::uint32_t line, std::size_t count = 1) {
    const auto known = std::find_if(kinds_.begin(), kinds_.end(), [&](const Kind& k) { return k.name == name; });
    if (known == kinds_.end() && kinds_.size() < 200)
      kinds_.push_back({std::string(name), count, {line}, false});
    else if (known == kinds_.end())
      ++further_;
    else if (known->count += count; known->lines.back() == line || known->lines.size() == 5)
      known->has_more |= known->lines.back() != line;
    else
      known->lines.push_back(line);
  }
  /// The first name with this beginning, and its line; empty if there is none.
  std::string place_of(std::string_view beginning, const Source& source) const {
    for (const Kind& kind : kinds_)
      if (kind.name.starts_with(beginning)) return joined({kind.name, " on line ", source.place(kind.lines.front())});
    return {};
  }
  /// Adds the warnings: "*DAMPING_GLOBAL (2) was skipped: lines 12, 40.", and "(2 cards)" with a unit. With the source,
  /// lines of included files are named with their file: "lines 12, 4 of 'mesh.k'."
  void tell(std::vector<std::string>& all, std::string_view why, const Source* source = nullptr,
            std::string_view unit = {}) const {
    for (const auto& [name, count, lines, has_more] : kinds_) {
      std::string places = lines.size() == 1 ? "line " : "lines ";
      for (const std::uint32_t line : lines) places += (source ? source->place(line) : std::to_string(line)) + ", ";
      places.resize(places.size() - 2);
      const std::string units = unit.empty() ? "" : joined({" ", unit, count == 1 ? "" : "s"});
      all.push_back(joined({name, " (", std::to_string(count), units, ")", why, places, has_more ? ", ..." : "."}));
    }
    if (further_ > 0) all.push_back(joined({"Others (", std::to_string(further_), ")", why, "not listed."}));
  }

 private:
  struct Kind {
    std::string name;
    std::size_t count;
    std::vector<std::uint32_t> lines;
    bool has_more = false;
  };
  std::vector<Kind> kinds_;
  std::size_t further_ = 0;
};

}  // namespace detail
}  // namespace strike
