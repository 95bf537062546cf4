#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <strike/input/dyna/draft.hpp>

// *PARAMETER with its options (LS-DYNA Keyword User's Manual R13, volume I).
namespace strike::detail::dyna {

/// The name of a parameter and its type: R real, I whole, C text.
struct ParameterName {
  char type;
  std::string name;
};
inline ParameterName parameter_name(std::string_view field, const File& file, std::uint32_t line) {
  const char type = field.empty() ? ' ' : upper(field.front());
  std::string name = upper(trimmed(field.substr(field.empty() ? 0 : 1)));
  const auto is_of_name = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_'; };
  const bool is_name = !name.empty() && (name[0] < '0' || name[0] > '9') && name != "TIME" &&
                       std::all_of(name.begin(), name.end(), is_of_name);
  if ((type != 'R' && type != 'I' && type != 'C') || !is_name)
    file.source().refuse(line, {"the parameter ", shown(field),
                                " has no type or no name: write R, I or C, and a name of letters and digits."});
  return {type, std::move(name)};
}
inline void set_parameter(const ParameterName& key, std::string_view value, File& file, std::uint32_t line) {
  Parameters::Value result{.may_change = file.base().find("_MUTABLE") != std::string_view::npos};
  if (key.type == 'C') {
    result.characters = std::string(value);
  } else {
    try {
      const auto plain = to_number(value);
      result.number = plain ? ExpressionValue{*plain, false} : file.evaluated(value);
    } catch (const NotEvaluated& error) {
      file.source().refuse(line, {"the parameter ", shown(key.name), " has no value, because ", error.why, ": correct ",
                                  shown(value), "."});
    }
    if (key.type == 'I') result.number.value = std::trunc(result.number.value);
    if (key.type == 'I' && std::abs(result.number.value) > 9e15)
      file.source().refuse(line, {"the parameter ", shown(key.name), " is larger than 9e15: make it real (R)."});
    result.number.is_whole = key.type == 'I';
  }
  Parameters& all = file.parameters();
  const bool is_local = file.base().find("_LOCAL") != std::string_view::npos;
  if (all.set(key.name, std::move(result), is_local)) return;
  if (all.duplication == Duplication::error)
    file.source().refuse(line, {"the parameter ", shown(key.name), " is there twice: take one out."});
  if (all.duplication == Duplication::first_with_warning)
    file.ignore_on_line(line, joined({"A second value of the parameter ", shown(key.name)}));
}

/// Pairs of names and values.
inline void parameters(File& file, Draft&) {
  const bool has_kinds = file.base().find("_TYPE") != std::string_view::npos;  // PRTYP, for preprocessors
  file.for_each_card([&](Card card) {
    for (int pair = 0; pair < (has_kinds ? 1 : 4); ++pair) {
      const std::string_view name = card.text(), value = card.text();
      if (name.empty() && value.empty()) continue;
      set_parameter(parameter_name(name, file, file.line()), value, file, file.line());
    }
  });
}
/// A name in the first ten columns, or before a comma, and an expression, which goes on in lines that begin with ten
/// blanks.
inline void parameter_expressions(File& file, Draft&) {
  std::optional<ParameterName> key;
  std::string expression;
  std::uint32_t at = 0;
  const auto set = [&] {
    if (key) set_parameter(*key, trimmed(expression), file, at);
  };
  const std::size_t width = file.width(10);
  file.for_each_line([&](std::string_view line) {
    std::string_view head = line.substr(0, width), rest = line.substr(head.size());
    if (trimmed(head).empty() && key) {
      expression += rest;
      if (expression.size() > 100'000) file.refuse({"the expression is longer than 100,000 characters: cut it."});
      return;
    }
    set();
    if (const std::size_t comma = head.find_first_of(",("); comma != head.npos && head[comma] == ',')
      head = line.substr(0, comma), rest = line.substr(comma + 1);
    key = parameter_name(trimmed(head), file, file.line());
    expression = rest, at = file.line();
  });
  set();
}
inline void parameter_duplication(File& file, Draft&) {
  Card card = file.card();
  const FileNumber flag = card.integer("DFLAG", 1);
  if (flag < 1 || flag > 5) file.refuse({"DFLAG ", std::to_string(flag), " is none: give 1 to 5."});
  file.parameters().duplication = static_cast<Duplication>(flag);
}

inline constexpr Meaning of_parameters{
    "values in other cards", "the same",
    "the kind of `_TYPE`; a second value, unless `*PARAMETER_DUPLICATION` says otherwise"};
inline constexpr Meaning of_duplication{"the value of a parameter that counts", "the same", "nothing"};
inline constexpr auto parameter_keywords = std::to_array<Keyword>({
    {"*PARAMETER_DUPLICATION", parameter_duplication, Invariant::everywhere, &of_duplication},
});
inline constexpr std::array<std::string_view, 4> parameter_options{"_EXPRESSION", "_LOCAL", "_MUTABLE", "_TYPE"};
/// The reader of *PARAMETER with any of its options; null for other keywords.
inline const Keyword* parameter_keyword(std::string_view name) {
  static constexpr Keyword values{"*PARAMETER", parameters, Invariant::everywhere, &of_parameters},
      expressions{"*PARAMETER_EXPRESSION", parameter_expressions, Invariant::everywhere, &of_parameters};
  std::array<bool, 4> has;
  if (!name.starts_with(values.name)) return nullptr;
  if (!has_options(name.substr(values.name.size()), parameter_options, has)) return nullptr;
  return has[0] ? &expressions : &values;
}
inline constexpr auto parameter_families = std::to_array<Family>({
    {"*PARAMETER", {}, parameter_options, parameter_keyword},
});

}  // namespace strike::detail::dyna
