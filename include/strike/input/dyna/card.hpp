#pragma once
#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <strike/input/dyna/parameters.hpp>
#include <strike/input/source.hpp>

namespace strike::detail::dyna {

/// Widths of fields: as the manual has them, none below 10, or all of 20.
enum class Format { standard, i10, wide };

/// The kind of things that a number in a file counts, as far as *INCLUDE_TRANSFORM tells them apart.
enum class Id { node, element, part, material, set, curve, define, other };
using Offsets = std::array<FileNumber, 8>;  ///< added to the numbers in an included file, by Id

/// How the cards of a file are read.
struct Context {
  Source source;
  Parameters parameters = {};
  Format format = Format::standard;
  Offsets offsets = {};

  std::size_t width(std::size_t standard) const {
    return format == Format::standard ? standard
           : format == Format::i10    ? std::max<std::size_t>(standard, 10)
                                      : std::max<std::size_t>(standard, 20);
  }
  /// The value of a field with parameters; nothing if it has none. Error: it has no value.
  [[gnu::cold]] std::optional<ExpressionValue> evaluated(std::string_view field, std::string_view meaning) const {
    if (field.find('&') == field.npos && !field.starts_with('<')) return std::nullopt;
    try {
      return parameters.evaluated(field);
    } catch (const NotEvaluated& error) {
      source.refuse({meaning, " ", shown(field), " has no value, because ", error.why, ": correct it."});
    }
  }
};

/// A data line: fields of fixed widths, or between commas. A field that is 0, blank or missing has the fallback.
class Card {
 public:
  Card(std::string_view line, const Context& context)
      : rest_(line), context_(&context), commas_(line.find(',') != line.npos) {}

  std::string_view text(std::size_t width = 10) {
    if (commas_) {
      const std::size_t first = rest_.find_first_not_of(" \t");
      const bool is_expression = first != rest_.npos && rest_[first] == '<';  // which may have commas
      if (const std::size_t end = is_expression ? rest_.find('>') : rest_.npos; end != rest_.npos) {
        const std::string_view field = rest_.substr(first, end + 1 - first);
        rest_.remove_prefix(end + 1);
        taken(rest_, ',');
        return field;
      }
      return trimmed(taken(rest_, ','));
    }
    const std::string_view field = rest_.substr(0, context_->width(width));
    rest_.remove_prefix(field.size());
    return trimmed(field);
  }
  double number(std::string_view meaning, double fallback = 0, std::size_t width = 10) {
    const std::string_view field = text(width);
    if (field.empty()) return fallback;
    double value = 0;
    if (const auto plain = to_number(field))
      value = *plain;
    else if (const auto evaluated = context_->evaluated(field, meaning))
      value = evaluated->value;
    else
      value = context_->source.number(field, meaning);
    return value == 0 ? fallback : value;
  }
  FileNumber integer(std::string_view meaning, FileNumber fallback = 0, std::size_t width = 10) {
    const std::string_view field = text(width);
    const FileNumber value = field.empty() ? 0 : integer_of(field, meaning);
    return value == 0 ? fallback : value;
  }
  /// The number of a node, part or card in the file, with the offset of the file; 0 for none, if it is 0 or blank.
  FileNumber tag(std::string_view meaning, Id id, std::size_t width = 10) {
    const std::string_view field = text(width);
    const FileNumber number = field.empty() ? 0 : integer_of(field, meaning);
    const FileNumber offset = number == 0 ? 0 : context_->offsets[static_cast<std::size_t>(id)];
    if (number < 0 || number >= number_limit || number + offset < (number == 0 ? 0 : 1) ||
        number + offset >= number_limit)
      refuse_tag(meaning, number, offset);
    return number + offset;
  }
  /// The number that the card defines.
  FileNumber own_tag(std::string_view meaning, std::string_view thing, Id id, std::size_t width = 10) {
    const FileNumber number = tag(meaning, id, width);
    if (number == 0) context_->source.refuse({thing[0] == 'e' ? "an " : "a ", thing, " has no number: number from 1."});
    return number;
  }
  double positive(std::string_view meaning) {
    const double value = number(meaning);
    if (!(value > 0)) context_->source.refuse({meaning, " is not positive: give the material its ", meaning, "."});
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
  FileNumber integer_of(std::string_view field, std::string_view meaning) const {
    if (const auto plain = to_integer(field)) return *plain;
    const auto evaluated = context_->evaluated(field, meaning);
    if (!evaluated) return context_->source.integer(field, meaning);
    const double value = evaluated->value;
    if (value != std::floor(value) || std::abs(value) > 9e15)
      context_->source.refuse(
          {meaning, " ", shown(field), " is ", strike::detail::text(value), ", which is no whole number: correct it."});
    return static_cast<FileNumber>(value);
  }
  [[noreturn, gnu::cold]] void refuse_tag(std::string_view meaning, FileNumber number, FileNumber offset) const {
    context_->source.refuse({meaning, " ", std::to_string(number), offset == 0 ? "" : " with the offset of its file",
                             " is out of bounds: number from 1 to 10^12."});
  }

  std::string_view rest_;
  const Context* context_;
  bool commas_;
};

}  // namespace strike::detail::dyna
