#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <strike/input/expression.hpp>
#include <strike/input/source.hpp>
#include <strike/text.hpp>

namespace strike::detail::abaqus {

/// A name as a label is compared: without blanks and in capitals, unless it stands in quotes, which keep its blanks.
inline std::string label(std::string_view text) {
  text = trimmed(text);
  if (text.size() > 1 && text.front() == '"' && text.back() == '"') return upper(text.substr(1, text.size() - 2));
  std::string result;
  for (const char c : text)
    if (!is_blank(c)) result += upper(c);
  return result;
}
/// The same as it is written, without quotes.
inline std::string shown_label(std::string_view text) {
  text = trimmed(text);
  if (text.size() > 1 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
  return std::string(text);
}
/// The next field of a line; commas between quotes are part of it.
inline std::string_view field(std::string_view& line) {
  bool quoted = false;
  std::size_t end = 0;
  for (; end < line.size() && (quoted || line[end] != ','); ++end) quoted ^= line[end] == '"';
  const std::string_view head = line.substr(0, end);
  line.remove_prefix(std::min(end + 1, line.size()));
  return trimmed(head);
}

/// Keyword lines `*NAME, PARAMETER=VALUE` and data lines of fields between commas, of the deck and of the files that it
/// includes, with the values of *PARAMETER in place of <name> (Abaqus Analysis User's Guide, "Input syntax rules" and
/// "Parametric input").
class File {
 public:
  using Parameters = std::map<std::string, std::string, std::less<>>;

  explicit File(Source source) : source_(std::move(source)) {}
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  const Source& source() const { return source_; }
  std::uint32_t line() const { return source_.line(); }
  [[noreturn, gnu::cold]] void refuse(std::initializer_list<std::string_view> what) const { source_.refuse(what); }
  [[noreturn, gnu::cold]] void refuse(std::uint32_t line, std::initializer_list<std::string_view> what) const {
    source_.refuse(line, what);
  }

  /// Goes to the next keyword, past the data lines that are left. False at the end.
  bool next_keyword() {
    while (true) {
      std::string_view line;
      input_is_open_ = true;  // that of a keyword that is skipped is not opened
      while (raw_data(line)) {
      }
      if (!more()) return false;
      begin_keyword();
      if (word_ != "*PARAMETER") break;
      read_parameters();
    }
    keyword_line_ = source_.line();
    input_is_open_ = find("INPUT") == nullptr;
    return true;
  }
  /// The keyword without blanks, and as it is written, in capitals.
  const std::string& word() const { return word_; }
  const std::string& name() const { return name_; }
  std::uint32_t keyword_line() const { return keyword_line_; }
  const Parameters& parameters() const { return parameters_; }
  const std::string* find(std::string_view key) const {
    const auto found = parameters_.find(key);
    return found == parameters_.end() ? nullptr : &found->second;
  }
  /// The value of a parameter as a label; empty if there is none.
  std::string label_of(std::string_view key) const {
    const std::string* const value = find(key);
    return value ? label(*value) : std::string();
  }
  /// The value of a parameter, without which the keyword means nothing.
  std::string required(std::string_view key) const {
    const std::string* const value = find(key);
    if (!value || value->empty()) refuse({name_, " has no ", key, ": write ", name_, ", ", key, "=..."});
    return shown_label(*value);
  }

  /// The next data line, without comments. False before a keyword and at the end.
  bool data(std::string_view& line) {
    if (!raw_data(line)) return false;
    if (line.find('<') != line.npos) line = replaced_ = replaced(line);
    return true;
  }
  /// The same as it is written, without values for parameters.
  bool raw_data(std::string_view& line) {
    if (!input_is_open_) open_input();
    while (more()) {
      if (!source_.next_begins_with("*")) {
        source_.next(line);
        if (!is_blank(line)) return true;
      } else if (source_.next_begins_with("**")) {
        source_.next(line);
        is_of_gmsh_ |= line.starts_with("******* E L E M E N T S");
      } else if (next_is_include()) {
        include();
      } else {
        return false;
      }
    }
    return false;
  }
  /// True if gmsh has written the file.
  bool is_of_gmsh() const { return is_of_gmsh_; }

  double number(std::string_view text, std::string_view meaning) const { return source_.number(text, meaning); }
  /// A number that is 0 where nothing is written.
  double number_or(std::string_view text, double otherwise, std::string_view meaning) const {
    text = trimmed(text);
    return text.empty() ? otherwise : source_.number(text, meaning);
  }
  FileNumber tag(std::string_view text, std::string_view meaning, FileNumber least = 1) const {
    return source_.tag(text, meaning, least);
  }
  /// The number of a node or an element at the start of a line, which loses it.
  FileNumber next_tag(std::string_view& line, std::string_view meaning) const {
    if (const auto plain = taken_number<FileNumber>(line, ',')) return source_.expect_tag(*plain, meaning);
    return source_.tag(taken(line, ','), meaning);
  }
  /// A number at the start of a line, which loses it: 0 where nothing is written.
  double next_number(std::string_view& line, std::string_view meaning) const {
    if (const auto plain = taken_number<double>(line, ',')) return *plain;
    return number_or(taken(line, ','), 0, meaning);
  }
  FileNumber tag_or(std::string_view text, FileNumber otherwise, std::string_view meaning, FileNumber least = 1) const {
    text = trimmed(text);
    return text.empty() ? otherwise : source_.tag(text, meaning, least);
  }

 private:
  struct Value {
    std::string name, text;
    std::optional<ExpressionValue> number;
  };

  /// False at the end of the deck.
  bool more() {
    while (source_.peek() == '\0')
      if (!source_.leave()) return false;
    return true;
  }
  bool next_is_include() const {
    const std::string_view line = source_.peek_line();
    return label(line.substr(0, line.find(','))) == "*INCLUDE";
  }
  /// Data lines from the file of INPUT=.
  [[gnu::cold]] void open_input() {
    input_is_open_ = true;
    source_.include(*find("INPUT"));
  }
  [[gnu::cold]] void include() {
    const std::string word = word_, name = name_;
    const Parameters parameters = parameters_;
    begin_keyword();
    const std::string file = find("INPUT") ? *find("INPUT") : "";
    if (file.empty()) refuse({"*INCLUDE has no INPUT: write *INCLUDE, INPUT=..."});
    word_ = word, name_ = name, parameters_ = parameters;
    source_.include(file);
  }

  void begin_keyword() {
    std::string_view line;
    source_.next(line);
    std::string whole(trimmed(line));
    while (!whole.empty() && whole.back() == ',' && !source_.next_begins_with("*") && source_.next(line))
      whole += trimmed(line);
    if (whole.find('<') != whole.npos) whole = replaced(whole);
    std::string_view rest = whole;
    name_ = upper(field(rest));
    word_ = label(name_);
    parameters_.clear();
    while (!rest.empty()) {
      std::string_view value = field(rest);
      const std::string key = whole_parameter(label(taken(value, '=')));
      value = trimmed(value);
      if (key == "INPUT" && value.size() > 1 && value.front() == '"' && value.back() == '"')
        value = value.substr(1, value.size() - 2);
      if (!key.empty()) parameters_[key] = std::string(value);
    }
  }
  static constexpr std::array<std::string_view, 11> known_parameters{
      "ELSET", "GENERATE", "INPUT", "INSTANCE", "INTERNAL", "NAME", "NSET", "PART", "SYSTEM", "TYPE", "UNSORTED"};
  /// Abaqus takes the first letters of a parameter for it.
  static std::string whole_parameter(std::string key) {
    for (const std::string_view whole : known_parameters)
      if (key.size() > 2 && whole.starts_with(key)) return std::string(whole);
    return key;
  }

  /// The text with values in place of <name>.
  [[gnu::cold]] std::string replaced(std::string_view text) const {
    std::string result;
    while (!text.empty()) {
      const std::size_t begin = text.find('<'), end = text.find('>', std::min(begin, text.size()));
      if (begin == text.npos || end == text.npos) break;
      const std::string_view name = trimmed(text.substr(begin + 1, end - begin - 1));
      const auto known = values_.find(upper(name));
      if (known == values_.end())
        refuse({"parameter ", shown(name), " is not defined above: define it with *PARAMETER, or write its value."});
      result.append(text.substr(0, begin)).append(known->second.text);
      text.remove_prefix(end + 1);
    }
    return result.append(text);
  }
  /// Lines `name = expression` or `name = 'text'`, with comments after #.
  [[gnu::cold]] void read_parameters() {
    if (!parameters_.empty())
      refuse({"*PARAMETER with ", parameters_.begin()->first.substr(0, 40),
              " is not read: write its values with *PARAMETER alone."});
    std::string_view line;
    while (raw_data(line)) {
      std::string_view rest = trimmed(taken(line, '#'));
      if (rest.empty()) continue;
      const std::string name(trimmed(taken(rest, '=')));
      rest = trimmed(rest);
      bool is_name = !name.empty() && !(name[0] >= '0' && name[0] <= '9');
      for (const char c : name) is_name &= (upper(c) >= 'A' && upper(c) <= 'Z') || (c >= '0' && c <= '9') || c == '_';
      if (!is_name || rest.empty()) refuse({"a parameter is a line name = value, and no ", shown(name), "."});
      Value value{name, {}, {}};
      const bool is_text = rest.size() > 1 && (rest[0] == '\'' || rest[0] == '"') && rest.back() == rest[0];
      if (is_text) {
        value.text = std::string(rest.substr(1, rest.size() - 2));
        if (value.text.size() > 80) refuse({"the text of parameter ", shown(name), " has more than 80 characters."});
      } else {
        value.number = evaluated(name, rest);
        value.text = value.number->is_whole ? std::to_string(static_cast<FileNumber>(value.number->value))
                                            : shortest(value.number->value);
      }
      const auto [known, is_new] = values_.try_emplace(upper(name), value);
      if (!is_new && known->second.name != name)
        refuse({"parameters ", shown(known->second.name), " and ", shown(name),
                " differ in capitals alone: give them different names."});
      known->second = value;
    }
  }
  ExpressionValue evaluated(const std::string& name, std::string_view expression) const {
    const auto look_up = [&](const std::string& other) -> std::optional<ExpressionValue> {
      const auto known = values_.find(other);
      return known == values_.end() ? std::nullopt : known->second.number;
    };
    try {
      return Formula(expression, look_up, ExpressionRules::python).value();
    } catch (const NotEvaluated& reason) {
      refuse({"parameter '", name.substr(0, 40), "' has no value: ", reason.why, "."});
    }
  }

  Source source_;
  std::string word_ = {}, name_ = {}, replaced_ = {};
  std::uint32_t keyword_line_ = 0;
  Parameters parameters_ = {};
  std::map<std::string, Value> values_ = {};
  bool is_of_gmsh_ = false, input_is_open_ = true;
};

}  // namespace strike::detail::abaqus
