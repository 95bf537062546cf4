#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <strike/input/dyna/card.hpp>
#include <strike/input/source.hpp>

namespace strike::detail::dyna {

/// Row of docs/deck_cards.md: what keywords become in a deck and in the scene of it, and what of them is not honoured.
struct Meaning {
  std::string_view deck, scene, lacks;

  constexpr bool is_whole() const { return !deck.empty() && !scene.empty() && !lacks.empty(); }
};
/// A keyword that names files or folders, which `File` follows.
struct IncludeKeyword {
  std::string_view name;
  bool names_folders, moves;
  const Meaning* meaning;
};
inline constexpr Meaning of_include{"cards of other files, which end at their `*END`", "the same", "nothing"};
inline constexpr Meaning of_moved_include{
    "the same, with offsets of their numbers and nodes moved by TRANID or FCTLEN", "the same",
    "FCTTEM, FCTLEN beside TRANID, and cards that would be others there, which are refused"};
inline constexpr auto include_keywords = std::to_array<IncludeKeyword>({
    {"*INCLUDE", false, false, &of_include},
    {"*INCLUDE_PATH", true, false, &of_include},
    {"*INCLUDE_PATH_RELATIVE", true, false, &of_include},
    {"*INCLUDE_TRANSFORM", false, true, &of_moved_include},
});

/// The motion of the nodes of a file by *INCLUDE_TRANSFORM: TRANID and FCTLEN, then the motion of the file around it.
struct Motion {
  FileNumber transformation;  ///< 0 for none
  double length;
  bool has_units;       ///< of this or a file around it
  std::uint32_t outer;  ///< place plus 1 of the motion of the including file; 0 for none
  std::uint32_t line;
};

/// A file, keyword by keyword and card by card (LS-DYNA Keyword User's Manual R13, volume I, "Getting started").
class File {
 public:
  explicit File(Source source) : context_{std::move(source)} {}
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  /// Goes to the next keyword, past the cards that are left and through included files. False at *END and at the end.
  /// Error: there is no keyword; a file that is not there.
  bool next_keyword() {
    if (!name_.empty() && !is_include()) pass_further_cards();
    std::string_view line;
    while (true) {
      if (is_include()) include_files();
      if (name_ == "*END" || !context_.source.next(line)) {
        if (!any_) refuse({"the file has no keyword: give an LS-DYNA keyword file."});
        if (!leave()) return false;
        continue;
      }
      if (line.empty() || line[0] == '$' || trimmed(line).empty()) continue;
      if (line[0] != '*') refuse({shown(line), " stands before any keyword: begin the file with *KEYWORD."});
      any_ = true;
      begin(upper(trimmed(line.find('&') == line.npos ? std::string(line) : replaced(line))));
      if (!is_include()) return true;
      names_file_ = false;
    }
  }
  /// The keyword as in the file, and without _TITLE or _ID.
  const std::string& name() const { return name_; }
  std::string_view base() const { return base_; }
  /// True for *SET_..._COLLECT: sets of one number are one.
  bool collects() const { return collects_; }
  /// Skips the cards of a keyword that is not read, and counts them.
  void skip() {
    const std::uint32_t at = context_.source.line();
    std::size_t cards = 0;
    for_each_line([&](std::string_view) { ++cards; });
    skipped_.add(name_.substr(0, 60), at, cards);
  }
  /// Passes the cards of a keyword that says nothing.
  void pass() {
    for_each_line([](std::string_view) {});
  }
  /// Counts the elements of a keyword that is not read, of so many lines each; the lines if that is 0.
  void leave_out_elements(std::size_t lines) {
    const std::uint32_t at = context_.source.line();
    std::size_t cards = 0;
    for_each_line([&](std::string_view) { ++cards; });
    if (cards == 0) return;
    const bool exact = lines > 0 && cards % lines == 0;
    const std::size_t count = exact ? cards / lines : cards;
    std::string what = joined({exact ? "Elements of " : "Lines of ", base_.substr(0, 60)});
    if (left_out_.empty())
      left_out_line_ = at, left_out_ = joined({exact ? "elements of " : "lines of ", base_.substr(0, 60)});
    if (left_out_line_ == at || left_out_.ends_with(base_.substr(0, 60))) left_out_count_ += count;
    ignored_.add(what, at, count);
  }
  /// Error: elements were left out.
  void expect_all_elements() const {
    if (!left_out_.empty())
      context_.source.refuse(left_out_line_, {left_out_, " (", std::to_string(left_out_count_),
                                              ") are of a kind that is not read: take them out of the deck, or leave "
                                              "them out with {.leave_out_elements = true}."});
  }
  /// The first keyword with this beginning that was skipped, with its line; empty if there is none.
  std::string skipped(std::string_view beginning) const { return skipped_.place_of(beginning, context_.source); }

  /// The next card of the keyword; a blank one if there is none.
  Card card() {
    std::string_view line;
    return next_line(line) ? Card(line, context_) : Card({}, context_);
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
      if (!trimmed(line).empty()) f(Card(line, context_));
  }
  /// Calls f with each line that is left and is not blank.
  template <class F>
  void for_each_line(F f) {
    std::string_view line;
    while (next_line(line))
      if (!trimmed(line).empty()) f(line);
  }
  /// Calls f with each heading, which may be blank, and the card after it.
  template <class F>
  void for_each_headed_card(F f) {
    std::string_view heading, line;
    while (next_line(heading)) {
      line = {};
      next_line(line);
      if (!trimmed(heading).empty() || !trimmed(line).empty()) f(named(trimmed(heading)), Card(line, context_));
    }
  }
  /// Calls f with each card that is left, of a keyword with _TITLE or _ID after its title.
  template <class F>
  void for_each_titled_card(F f) {
    if (titled_)
      for_each_headed_card([&](const std::string&, const Card& card) { f(card); });
    else
      for_each_card(f);
  }
  /// The next line as a text.
  std::string heading() { return std::string(card().rest()); }
  /// The next line as the name of a part.
  std::string part_heading() { return named(card().rest()); }
  /// The title that stands before the cards of a keyword with _TITLE or _ID.
  std::string title() { return titled_ ? named(card().rest()) : std::string(); }

  /// The same of a contact, whose number stands before its title.
  std::string id_title(FileNumber& number) {
    if (!titled_) return {};
    Card whole = card(), after = whole;
    const auto given = to_integer(after.text());
    if (!given) return named(whole.rest());
    number = *given;
    return named(after.rest());
  }
  bool titled() const { return titled_; }
  /// True for a contact with _MPP.
  bool is_parallel() const { return is_parallel_; }
  /// True if the next card of a contact begins with a lone `&`, as the second one of _MPP does.
  bool goes_on_with_ampersand() {
    std::string_view line;
    while (context_.source.peek() == '$') context_.source.next(line);
    line = context_.source.peek_line();
    return line.starts_with('&') && (line.size() == 1 || detail::is_blank(line[1]) || line[1] == ',');
  }

  Parameters& parameters() { return context_.parameters; }
  std::size_t width(std::size_t standard) const { return context_.width(standard); }
  ExpressionValue evaluated(std::string_view expression) const { return context_.parameters.evaluated(expression); }
  /// The place in `motions` of what moves the nodes of the file being read, plus 1; 0 if nothing does.
  std::uint32_t motion() const { return here_.motion; }
  const std::vector<Motion>& motions() const { return motions_; }

  /// Lists a value that has no counterpart here, unless it is 0.
  void ignore(double value, std::string_view what) {
    if (value != 0) values_.add(joined({what, " of ", name_}), context_.source.line());
  }
  /// Lists fields of cards that were not read and are neither blank nor 0.
  template <class... Cards>
  void ignore_rest(Cards&... cards) {
    (ignore(cards.says_more(), "Further fields"), ...);
  }
  void ignore_here(std::string_view what) { values_.add(what, context_.source.line()); }
  void ignore_on_line(std::uint32_t line, std::string_view what) { values_.add(what, line); }

  const Source& source() const { return context_.source; }
  std::uint32_t line() const { return context_.source.line(); }
  [[noreturn, gnu::cold]] void refuse(std::initializer_list<std::string_view> what) const {
    context_.source.refuse(what);
  }

  void tell(std::vector<std::string>& warnings) const {
    skipped_.tell(warnings, " was skipped: ", &context_.source, "card");
    ignored_.tell(warnings, " were left out: ", &context_.source);
    values_.tell(warnings, " had no effect: ", &context_.source);
  }

 private:
  /// The state that an included file changes until its end.
  struct Surroundings {
    std::string name = {};  ///< the keyword that includes the file
    Format format = Format::standard;
    Offsets offsets = {};
    std::uint32_t motion = 0;
    std::string prefix = {}, suffix = {};  ///< of titles
  };

  std::string replaced(std::string_view line) const {
    try {
      return context_.parameters.replaced(line);
    } catch (const NotEvaluated& error) {
      refuse({shown(line), " is no name, because ", error.why, ": shorten it."});
    }
  }
  bool is_include() const { return name_.starts_with("*INCLUDE"); }
  std::string named(std::string_view title) const { return joined({here_.prefix, title, here_.suffix}); }

  /// The name of a file or folder, which goes on after " +" at the end of a line. False after the last one.
  bool next_path(std::string& path) {
    path.clear();
    std::string_view line;
    while (next_line(line)) {
      line = trimmed(line);
      const bool goes_on = line.ends_with(" +");
      path += trimmed(goes_on ? line.substr(0, line.size() - 1) : line);
      if (!goes_on && !path.empty()) break;
    }
    if (path.find('&') != path.npos) path = replaced(path);
    return !path.empty();
  }
  /// Goes into the next file that the keyword names, or notes the folders that it names.
  void include_files() {
    std::string path;
    const auto known = std::find_if(include_keywords.begin(), include_keywords.end(),
                                    [&](const IncludeKeyword& keyword) { return keyword.name == name_; });
    if (known == include_keywords.end())
      refuse({name_, " is not read, and takes more or less from a file than its text: write the cards that it gives."});
    if (known->names_folders) {
      while (next_path(path)) {
        std::replace(path.begin(), path.end(), '\\', '/');
        folders_.push_back(path.starts_with('/') ? path : joined({context_.source.folder(), "/", path}));
      }
    } else {
      if (!next_path(path)) {
        if (!names_file_) refuse({name_, " names no file: write its name below, or take the keyword out."});
        return;
      }
      Surroundings inner = here_;
      inner.format = context_.format;
      Offsets offsets = context_.offsets;
      if (known->moves) transform(inner, offsets);
      context_.source.include(path, folders_);
      context_.parameters.enter();
      outer_.push_back(std::move(here_));
      outer_.back().name = std::exchange(name_, {});
      outer_.back().format = context_.format;
      outer_.back().offsets = context_.offsets;
      here_ = std::move(inner), context_.offsets = offsets, context_.format = keyword_format_ = here_.format;
    }
  }
  /// The cards of *INCLUDE_TRANSFORM after the name of the file.
  void transform(Surroundings& inner, Offsets& offsets) {
    const auto add = [&](Card& from, Id id, std::string_view meaning) {
      FileNumber& offset = offsets[static_cast<std::size_t>(id)];
      const FileNumber more = from.integer(meaning);
      if (std::abs(more) >= number_limit || std::abs(offset + more) >= number_limit)
        refuse({meaning, " ", std::to_string(more), " is out of bounds: give less than 10^12."});
      offset += more;
    };
    Card first = card();
    add(first, Id::node, "IDNOFF"), add(first, Id::element, "IDEOFF"), add(first, Id::part, "IDPOFF");
    add(first, Id::material, "IDMOFF"), add(first, Id::set, "IDSOFF"), add(first, Id::curve, "IDFOFF");
    add(first, Id::define, "IDDOFF");
    Card second = card();
    add(second, Id::other, "IDROFF");
    second.pass(1);
    if (const std::string prefix(second.text()); !prefix.empty()) inner.prefix += prefix + ".";
    if (const std::string suffix(second.text()); !suffix.empty()) inner.suffix = "." + suffix + inner.suffix;
    if (inner.prefix.size() + inner.suffix.size() > 200)
      refuse({"PREFIX and SUFFIX have more than 200 characters together: shorten them."});
    Card units = card();
    const double mass = units.number("FCTMAS", 1), time = units.number("FCTTIM", 1), length = units.number("FCTLEN", 1);
    const std::string_view temperature = units.text();
    if (!(mass > 0) || !(time > 0) || !(length > 0))
      refuse({"a factor of units is not positive: give FCTMAS, FCTTIM and FCTLEN above 0."});
    if (!temperature.empty() && to_number(temperature) != 1.0 && to_number(temperature) != 0.0)
      refuse({"FCTTEM ", shown(temperature), " is not read: convert the temperatures in the included file."});
    const FileNumber transformation = card().tag("TRANID", Id::define);
    const std::uint32_t line = context_.source.line();
    if (transformation != 0 && length != 1)
      refuse(
          {"FCTLEN and TRANID together are not read: scale the included file, or add a SCALE to the transformation."});
    if (transformation == 0 && mass == 1 && time == 1 && length == 1) return;
    const bool outer_has_units = inner.motion != 0 && motions_[inner.motion - 1].has_units;
    motions_.push_back(
        {transformation, length, outer_has_units || mass != 1 || time != 1 || length != 1, inner.motion, line});
    inner.motion = static_cast<std::uint32_t>(motions_.size());
  }
  bool leave() {
    if (!context_.source.leave()) return false;
    context_.parameters.leave();
    here_ = std::move(outer_.back()), outer_.pop_back();
    name_ = std::exchange(here_.name, {});
    names_file_ = true;
    context_.format = keyword_format_ = here_.format;
    context_.offsets = here_.offsets;
    return true;
  }
  /// The next data line of the keyword, without comments.
  bool next_line(std::string_view& line) {
    while (context_.source.peek() != '\0' && context_.source.peek() != '*') {
      context_.source.next(line);
      if (line.empty() || line[0] != '$') return true;
    }
    return false;
  }
  void pass_further_cards() {
    std::string_view line;
    if (!next_line(line)) return;
    const std::uint32_t at = context_.source.line();
    bool blank = trimmed(line).empty();
    while (next_line(line)) blank &= trimmed(line).empty();
    if (!blank) values_.add(joined({"What follows the cards of ", name_}), at);
  }
  void begin(const std::string& line) {
    name_ = line.substr(0, line.find_first_of(" \t,"));
    std::string packed;
    for (const char c : line)
      if (!detail::is_blank(c)) packed += c;
    const char last = packed.back();
    while (name_.size() > 1 && (name_.back() == '-' || name_.back() == '+' || name_.back() == '%')) name_.pop_back();
    if (name_.starts_with("*KEYWORD")) {
      const auto has = [&](std::string_view option) { return packed.find(option) != packed.npos; };
      if (has("LONG=Y") || has("LONG=K"))
        keyword_format_ = Format::wide;
      else if (has("I10=Y"))
        keyword_format_ = Format::i10;
      else if (has("LONG=") || has("I10="))
        keyword_format_ = Format::standard;
    }
    context_.format = last == '+'   ? Format::wide
                      : last == '%' ? Format::i10
                      : last == '-' ? Format::standard
                                    : keyword_format_;
    base_ = name_;
    const auto drop = [&](std::string_view option) {
      const bool found = base_.size() > option.size() && base_.ends_with(option);
      if (found) base_.resize(base_.size() - option.size());
      return found;
    };
    const bool contact = base_.starts_with("*CONTACT_");
    const bool has_id = contact || base_.starts_with("*BOUNDARY_") || base_.starts_with("*RIGIDWALL_") ||
                        base_.starts_with("*LOAD_") || base_.starts_with("*DATABASE_HISTORY_");
    titled_ = (has_id && drop("_ID")) || ((contact || !has_id) && drop("_TITLE"));
    is_parallel_ = false;
    while (contact)
      if (drop("_MPP"))
        is_parallel_ = true;
      else if (drop("_ID") || drop("_TITLE"))
        titled_ = true;
      else
        break;
    collects_ = base_.starts_with("*SET_") && drop("_COLLECT");
    if (collects_) titled_ |= drop("_TITLE");
  }

  Context context_;
  std::string name_ = {}, base_ = {};
  Surroundings here_ = {};
  std::vector<Surroundings> outer_ = {};
  std::vector<Motion> motions_ = {};
  Format keyword_format_ = Format::standard;  ///< of the keywords that have no sign of their own
  std::vector<std::string> folders_ = {};     ///< of *INCLUDE_PATH
  bool is_parallel_ = false;
  bool any_ = false;
  bool names_file_ = false;  ///< the *INCLUDE that is being read has named one
  bool titled_ = false, collects_ = false;
  Skipped skipped_ = {}, ignored_ = {}, values_ = {};
  std::string left_out_ = {};  ///< the first kind of elements that was left out
  std::uint32_t left_out_line_ = 0;
  std::size_t left_out_count_ = 0;
};

}  // namespace strike::detail::dyna
