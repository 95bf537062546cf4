#pragma once
#include <algorithm>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <strike/input/source.hpp>

namespace strike::detail::dyna {

/// A data line: fields of fixed widths, or between commas. A field that is 0, blank or missing has the fallback.
class Card {
 public:
  Card(std::string_view line, const Source& source)
      : rest_(line), source_(&source), commas_(line.find(',') != line.npos) {}

  std::string_view text(std::size_t width = 10) {
    if (commas_) return trimmed(taken(rest_, ','));
    const std::string_view field = rest_.substr(0, width);
    rest_.remove_prefix(field.size());
    return trimmed(field);
  }
  double number(std::string_view meaning, double fallback = 0, std::size_t width = 10) {
    const std::string_view field = text(width);
    const double value = field.empty() ? 0 : source_->number(field, meaning);
    return value == 0 ? fallback : value;
  }
  FileNumber integer(std::string_view meaning, FileNumber fallback = 0, std::size_t width = 10) {
    const std::string_view field = text(width);
    const FileNumber value = field.empty() ? 0 : source_->integer(field, meaning);
    return value == 0 ? fallback : value;
  }
  /// The number of a node, part or card in the file; 0 for none, if it is blank.
  FileNumber tag(std::string_view meaning, std::size_t width = 10) {
    const std::string_view field = text(width);
    return field.empty() ? 0 : source_->tag(field, meaning, 0);
  }
  /// The number that the card defines.
  FileNumber own_tag(std::string_view meaning, std::string_view thing, std::size_t width = 10) {
    const FileNumber number = tag(meaning, width);
    if (number == 0) source_->refuse({thing[0] == 'e' ? "an " : "a ", thing, " has no number: number from 1."});
    return number;
  }
  double positive(std::string_view meaning) {
    const double value = number(meaning);
    if (!(value > 0)) source_->refuse({meaning, " is not positive: give the material its ", meaning, "."});
    return value;
  }
  Eigen::Vector3d vector(std::string_view meaning) {
    const double x = number(meaning), y = number(meaning), z = number(meaning);
    return {x, y, z};
  }
  void pass(std::size_t fields) {
    while (fields-- > 0) text();
  }
  /// The rest of the line, without conversion.
  std::string_view rest() const { return trimmed(rest_); }
  bool is_blank() const { return rest().empty(); }
  /// True if a field that was not read is neither blank nor 0.
  bool says_more() {
    while (!rest_.empty())
      if (const std::string_view field = text(); !field.empty() && to_number(field) != 0.0) return true;
    return false;
  }

 private:
  std::string_view rest_;
  const Source* source_;
  bool commas_;
};

/// A file, keyword by keyword and card by card (LS-DYNA Keyword User's Manual R13, volume I, "Getting started").
class File {
 public:
  explicit File(Source source) : source_(std::move(source)) {}

  /// Goes to the next keyword, past the cards that are left and through included files. False at *END and at the end.
  /// Error: there is no keyword; a keyword for another format; a file that is not there.
  bool next_keyword() {
    if (!name_.empty() && !is_include()) pass_further_cards();
    std::string_view line;
    while (true) {
      if (is_include() && name_ != "*END") include_files();
      if (name_ == "*END" || !source_.next(line)) {
        if (!any_) refuse({"the file has no keyword: give an LS-DYNA keyword file."});
        if (!source_.leave()) return false;
        name_ = std::move(outer_names_.back()), outer_names_.pop_back();
        continue;
      }
      if (line.empty() || line[0] == '$' || trimmed(line).empty()) continue;
      if (line[0] != '*') refuse({shown(line), " stands before any keyword: begin the file with *KEYWORD."});
      any_ = true;
      begin(upper(trimmed(line)));
      if (!is_include()) return true;
    }
  }
  /// The keyword as in the file, and without _TITLE or _ID.
  const std::string& name() const { return name_; }
  std::string_view base() const { return base_; }
  /// Skips the cards of a keyword that is not read.
  void skip() {
    skipped_.add(name_.substr(0, 60), source_.line());
    is_skipped_ = true;
  }
  /// Counts the elements of a keyword that is not read, a line each.
  void ignore_elements() {
    is_skipped_ = true;
    for_each_card([&](const Card&) { ignored_.add(joined({"Elements of ", base_}), source_.line()); });
  }
  /// The first keyword with this beginning that was skipped, with its line; empty if there is none.
  std::string skipped(std::string_view beginning) const { return skipped_.place_of(beginning, source_); }

  /// The next card of the keyword; a blank one if there is none.
  Card card() {
    std::string_view line;
    return next_line(line) ? Card(line, source_) : Card({}, source_);
  }
  bool pass_card() {
    std::string_view line;
    return next_line(line);
  }
  /// Calls f with each card that is left; blank lines are skipped.
  template <class F>
  void for_each_card(F f) {
    std::string_view line;
    while (next_line(line))
      if (!trimmed(line).empty()) f(Card(line, source_));
  }
  /// Calls f with each heading, which may be blank, and the card after it.
  template <class F>
  void for_each_headed_card(F f) {
    std::string_view heading, line;
    while (next_line(heading)) {
      line = {};
      next_line(line);
      if (!trimmed(heading).empty() || !trimmed(line).empty()) f(trimmed(heading), Card(line, source_));
    }
  }
  /// Calls f with each card that is left, of a keyword with _TITLE or _ID after its title.
  template <class F>
  void for_each_titled_card(F f) {
    if (titled_)
      for_each_headed_card([&](std::string_view, const Card& card) { f(card); });
    else
      for_each_card(f);
  }
  /// The next line as a text.
  std::string heading() { return std::string(card().rest()); }
  /// The title that stands before the cards of a keyword with _TITLE or _ID.
  std::string title() { return titled_ ? heading() : std::string(); }

  /// Lists a value that has no counterpart here, unless it is 0.
  void ignore(double value, std::string_view what) {
    if (value != 0) values_.add(joined({what, " of ", name_}), source_.line());
  }
  /// Lists fields of cards that were not read and are neither blank nor 0.
  template <class... Cards>
  void ignore_rest(Cards&... cards) {
    (ignore(cards.says_more(), "Further fields"), ...);
  }
  void ignore_on_line(std::uint32_t line, std::string_view what) { values_.add(what, line); }

  const Source& source() const { return source_; }
  std::uint32_t line() const { return source_.line(); }
  [[noreturn, gnu::cold]] void refuse(std::initializer_list<std::string_view> what) const { source_.refuse(what); }

  void tell(std::vector<std::string>& warnings) const {
    skipped_.tell(warnings, " was skipped: ", &source_);
    ignored_.tell(warnings, " were ignored: ", &source_);
    values_.tell(warnings, " had no effect: ", &source_);
  }

 private:
  bool is_include() const { return name_.starts_with("*INCLUDE"); }
  /// The name of a file or folder, which goes on after " +" at the end of a line. False after the last one.
  bool next_path(std::string& path) {
    path.clear();
    std::string_view line;
    while (next_line(line)) {
      line = trimmed(line);
      const bool goes_on = line.ends_with(" +");
      path += trimmed(goes_on ? line.substr(0, line.size() - 1) : line);
      if (!goes_on && !path.empty()) return true;
    }
    return !path.empty();
  }
  /// Goes into the next file that the keyword names, or notes the folders that it names.
  void include_files() {
    std::string path;
    const bool relative = name_ == "*INCLUDE_PATH_RELATIVE";
    if (relative || name_ == "*INCLUDE_PATH") {
      while (next_path(path)) {
        std::replace(path.begin(), path.end(), '\\', '/');
        folders_.push_back(path.starts_with('/') ? path : joined({source_.folder(), "/", path}));
      }
    } else if (name_ == "*INCLUDE") {
      if (next_path(path)) {
        source_.include(path, folders_);
        outer_names_.push_back(std::exchange(name_, {}));
      }
    } else {
      refuse({name_, " is not read, and takes more or less from a file than its text: write the cards that it gives."});
    }
  }
  /// The next data line of the keyword, without comments.
  bool next_line(std::string_view& line) {
    while (source_.peek() != '\0' && source_.peek() != '*') {
      source_.next(line);
      if (line.empty() || line[0] != '$') return true;
    }
    return false;
  }
  void pass_further_cards() {
    std::string_view line;
    if (!next_line(line)) return;
    const std::uint32_t at = source_.line();
    bool blank = trimmed(line).empty();
    while (next_line(line)) blank &= trimmed(line).empty();
    if (!is_skipped_ && !blank) values_.add(joined({"What follows the cards of ", name_}), at);
  }
  void begin(const std::string& line) {
    name_ = line.substr(0, line.find_first_of(" \t,"));
    is_skipped_ = false;
    if (name_.back() == '-') name_.pop_back();
    std::string packed;
    for (const char c : line)
      if (!detail::is_blank(c)) packed += c;
    const auto has = [&](std::string_view option) { return packed.find(option) != packed.npos; };
    if (packed.ends_with('+') || packed.ends_with('%') ||
        (name_ == "*KEYWORD" && (has("LONG=Y") || has("LONG=K") || has("I10=Y"))))
      refuse({"the file is in the long or the I10 format: write it in the standard one."});
    base_ = name_;
    const auto drop = [&](std::string_view option) {
      const bool found = base_.size() > option.size() && base_.ends_with(option);
      if (found) base_.resize(base_.size() - option.size());
      return found;
    };
    const bool contact = base_.starts_with("*CONTACT_");
    const bool has_id = contact || base_.starts_with("*BOUNDARY_") || base_.starts_with("*RIGIDWALL_");
    titled_ = (has_id && drop("_ID")) || ((contact || !has_id) && drop("_TITLE"));
  }

  Source source_;
  std::string name_ = {}, base_ = {};
  std::vector<std::string> outer_names_ = {};  ///< the keywords that include the files being read
  std::vector<std::string> folders_ = {};      ///< of *INCLUDE_PATH
  bool any_ = false;
  bool titled_ = false, is_skipped_ = false;
  Skipped skipped_ = {}, ignored_ = {}, values_ = {};
};

}  // namespace strike::detail::dyna
