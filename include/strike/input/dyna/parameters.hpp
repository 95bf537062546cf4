#pragma once
#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <strike/input/expression.hpp>
#include <strike/input/source.hpp>
#include <strike/text.hpp>

namespace strike::detail::dyna {

/// *PARAMETER_DUPLICATION: which of two values of a parameter counts.
enum class Duplication { first_with_warning = 1, last_with_warning, error, last, first };

/// The parameters of a deck, and of each file that is being read its own (LS-DYNA Keyword User's Manual R13, volume I,
/// *PARAMETER). Names are the same in upper and lower case.
class Parameters {
 public:
  struct Value {
    ExpressionValue number = {};
    std::optional<std::string> characters = {};
    bool may_change = false;  ///< MUTABLE
  };

  Duplication duplication = Duplication::first_with_warning;

  /// A file begins or ends, whose LOCAL parameters are its own.
  void enter() { locals_.emplace_back(); }
  void leave() { locals_.pop_back(); }

  /// Null if there is none of that name, in upper case.
  const Value* find(std::string_view name) const {
    for (auto scope = locals_.rbegin(); scope != locals_.rend(); ++scope)
      if (const auto known = scope->find(name); known != scope->end()) return &known->second;
    const auto known = all_.find(name);
    return known == all_.end() ? nullptr : &known->second;
  }
  /// False if the name has a value already, and the rule of duplication keeps it.
  bool set(const std::string& name, Value value, bool is_local) {
    bool known = !is_local && all_.contains(name);
    for (const Scope& scope : locals_) known |= is_local && scope.contains(name);
    Scope& scope = is_local ? locals_.back() : all_;
    const bool keeps = duplication != Duplication::last && duplication != Duplication::last_with_warning;
    const Value* const old = find(name);
    if (known && keeps && !(old && old->may_change && !old->characters)) return false;
    value.may_change |= known && old && old->may_change;
    scope.insert_or_assign(name, std::move(value));
    return true;
  }

  /// The value of a field that names parameters: &name, -&name, <expression>, &name/2. Error: NotEvaluated.
  ExpressionValue evaluated(std::string_view field) const {
    if (field.starts_with('<')) field = field.substr(1, field.ends_with('>') ? field.size() - 2 : field.npos);
    const auto lookup = [&](const std::string& name) -> std::optional<ExpressionValue> {
      const Value* const known = find(name);
      if (known && known->characters)
        throw NotEvaluated{joined({"parameter '", name, "' is the text ", shown(*known->characters)})};
      return known ? std::optional(known->number) : std::nullopt;
    };
    return Formula(field, lookup).value();
  }
  /// A text with &name, or &name^ where more letters follow, replaced where there is a parameter of that name. Error:
  /// NotEvaluated, if it grows beyond any line.
  std::string replaced(std::string_view text) const {
    std::string result;
    while (!text.empty()) {
      result += taken(text, '&');
      if (text.empty()) break;
      std::size_t length = 0;
      const auto is_of_name = [](char c) {
        return (upper(c) >= 'A' && upper(c) <= 'Z') || (c >= '0' && c <= '9') || c == '_';
      };
      while (length < text.size() && is_of_name(text[length])) ++length;
      const Value* const known = find(upper(text.substr(0, length)));
      if (!known) {
        result += '&';
        continue;
      }
      result += known->characters ? *known->characters : written(known->number);
      if (result.size() > 10'000) throw NotEvaluated{"it is longer than 10,000 characters with its parameters"};
      text.remove_prefix(length < text.size() && text[length] == '^' ? length + 1 : length);
    }
    return result;
  }

 private:
  using Scope = std::map<std::string, Value, std::less<>>;

  static std::string written(const ExpressionValue& number) {
    return number.is_whole ? std::to_string(static_cast<FileNumber>(number.value)) : shortest(number.value);
  }

  Scope all_ = {};
  std::vector<Scope> locals_{1};
};

}  // namespace strike::detail::dyna
