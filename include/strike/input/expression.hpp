#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <strike/input/source.hpp>
#include <strike/text.hpp>

namespace strike::detail {

/// The value of an expression: a whole number or a real one, which divide differently.
struct ExpressionValue {
  double value = 0;
  bool is_whole = false;
};

/// Rules of an expression: of Fortran, where a sign binds more tightly than a power and whole numbers divide with
/// truncation; or of Python, where -3**2 is -9, and whole numbers divide where nothing is left over, since Python 2 and
/// 3 differ otherwise.
enum class ExpressionRules { fortran, python };

/// The reason why an expression has no value.
struct NotEvaluated {
  std::string why;
};

/// An expression of numbers, names and the functions of LS-DYNA's manual, as in Fortran (LS-DYNA Keyword User's Manual
/// R13, volume I, *PARAMETER_EXPRESSION): + - * / ** (or ^) and parentheses. Whole numbers divide with truncation, 2/5
/// is 0; a sign binds more tightly than a power, -3**2 is 9. `Lookup` gives the std::optional<ExpressionValue> of a
/// name in upper case.
template <class Lookup>
class Formula {
 public:
  Formula(std::string_view text, const Lookup& lookup, ExpressionRules rules = ExpressionRules::fortran)
      : rest_(text), lookup_(lookup), is_python_(rules == ExpressionRules::python) {}

  /// Throws NotEvaluated.
  ExpressionValue value() {
    const ExpressionValue result = sum();
    if (next() != '\0') fail({"'", rest_.substr(0, 20), "' is more than the expression"});
    return result;
  }

 private:
  static constexpr int deepest = 60;

  [[noreturn, gnu::cold]] static void fail(std::initializer_list<std::string_view> why) {
    throw NotEvaluated{joined(why)};
  }
  /// Results are finite, and whole ones exact.
  static ExpressionValue checked(double value, bool is_whole) {
    if (!std::isfinite(value)) fail({"a result is not finite"});
    if (is_whole && std::abs(value) > 9e15) fail({"a whole number is larger than 9e15"});
    return {value, is_whole};
  }
  /// The next character that is not blank.
  char next() {
    while (!rest_.empty() && is_blank(rest_.front())) rest_.remove_prefix(1);
    return rest_.empty() ? '\0' : rest_.front();
  }
  bool take(std::string_view sign) {
    if (next() == '\0' || !rest_.starts_with(sign)) return false;
    rest_.remove_prefix(sign.size());
    return true;
  }
  /// Depth of the recursion while it lives.
  class Level {
   public:
    explicit Level(int& depth) : depth_(depth) {
      if (++depth_ > deepest) fail({"it is more than 60 levels deep"});
    }
    Level(const Level&) = delete;
    Level& operator=(const Level&) = delete;
    ~Level() { --depth_; }

   private:
    int& depth_;
  };

  ExpressionValue sum() {
    const Level level(depth_);
    ExpressionValue left = product();
    while (next() == '+' || next() == '-') {
      const bool plus = take("+");
      if (!plus) take("-");
      const ExpressionValue right = product();
      left = checked(plus ? left.value + right.value : left.value - right.value, left.is_whole && right.is_whole);
    }
    return left;
  }
  ExpressionValue product() {
    const auto factor = [&] { return is_python_ ? signed_power() : power(); };
    ExpressionValue left = factor();
    while (next() == '*' || next() == '/') {
      const bool times = take("*");
      if (!times) take("/");
      const ExpressionValue right = factor();
      const bool is_whole = left.is_whole && right.is_whole;
      if (!times && right.value == 0) fail({"it divides by 0"});
      const double result = times ? left.value * right.value : left.value / right.value;
      if (is_python_ && is_whole && result != std::trunc(result))
        fail(
            {"whole numbers divide with a remainder, which Python 2 drops and 3 keeps: write one of them with a "
             "point"});
      left = checked(is_whole ? std::trunc(result) : result, is_whole);
    }
    return left;
  }
  ExpressionValue power() {
    const Level level(depth_);
    const ExpressionValue base = signed_term();
    if (!take("**") && !take("^")) return base;
    const ExpressionValue exponent = power();
    const bool is_whole = base.is_whole && exponent.is_whole;
    const double result = std::pow(base.value, exponent.value);
    return checked(is_whole ? std::trunc(result) : result, is_whole);
  }
  /// A power of Python, whose sign stands before it.
  ExpressionValue signed_power() {
    const Level level(depth_);
    bool minus = false;
    while (next() == '-' || next() == '+') minus ^= take("-") || !take("+");
    ExpressionValue result = operand();
    if (take("**")) {
      const ExpressionValue exponent = signed_power();
      const bool is_whole = result.is_whole && exponent.is_whole && exponent.value >= 0;
      result = checked(std::pow(result.value, exponent.value), is_whole);
    }
    return {minus ? -result.value : result.value, result.is_whole};
  }
  ExpressionValue signed_term() {
    bool minus = false;
    while (next() == '-' || next() == '+') minus ^= take("-") || !take("+");
    const ExpressionValue term = operand();
    return {minus ? -term.value : term.value, term.is_whole};
  }
  ExpressionValue operand() {
    if (take("(")) {
      const ExpressionValue inner = sum();
      if (!take(")")) fail({"a parenthesis is not closed"});
      return inner;
    }
    const char first = next();
    if ((first >= '0' && first <= '9') || first == '.') return number();
    take("&");
    std::size_t length = 0;
    while (length < rest_.size() && is_of_name(rest_[length])) ++length;
    if (length == 0)
      fail({first == '\0' ? "it ends where a number or a name should stand" : "no number or name is '",
            first == '\0' ? "" : rest_.substr(0, 1), first == '\0' ? "" : "'"});
    const std::string name = upper(rest_.substr(0, length));
    rest_.remove_prefix(length);
    if (take("(")) return function(name);
    if (const std::optional<ExpressionValue> known = lookup_(name)) return *known;
    if (name == "PI") return {std::numbers::pi, false};
    if (name == "DTOR") return {std::numbers::pi / 180, false};
    if (name == "RTOD") return {180 / std::numbers::pi, false};
    fail({"parameter '", name.substr(0, 40), "' is not defined above"});
  }
  static bool is_of_name(char c) { return (upper(c) >= 'A' && upper(c) <= 'Z') || (c >= '0' && c <= '9') || c == '_'; }

  ExpressionValue number() {
    const auto digits = [&](std::size_t i) {
      while (i < rest_.size() && rest_[i] >= '0' && rest_[i] <= '9') ++i;
      return i;
    };
    std::size_t end = digits(0);
    bool is_whole = true;
    if (end < rest_.size() && rest_[end] == '.') end = digits(end + 1), is_whole = false;
    if (end < rest_.size() && (upper(rest_[end]) == 'E' || upper(rest_[end]) == 'D')) {
      const std::size_t sign = end + 1 < rest_.size() && (rest_[end + 1] == '+' || rest_[end + 1] == '-') ? 1 : 0;
      if (const std::size_t last = digits(end + 1 + sign); last > end + 1 + sign) end = last, is_whole = false;
    }
    const auto value = to_number(rest_.substr(0, end));
    if (!value) fail({shown(rest_.substr(0, end)), " is no number"});
    rest_.remove_prefix(end);
    return checked(*value, is_whole);
  }

  using Arguments = std::vector<ExpressionValue>;
  /// A function of one real number.
  struct Function {
    std::string_view name;
    double (*of)(double);
  };
  static constexpr std::array<Function, 20> functions{
      {{"SIN", [](double x) { return std::sin(x); }},     {"COS", [](double x) { return std::cos(x); }},
       {"TAN", [](double x) { return std::tan(x); }},     {"CSC", [](double x) { return 1 / std::sin(x); }},
       {"SEC", [](double x) { return 1 / std::cos(x); }}, {"CTN", [](double x) { return 1 / std::tan(x); }},
       {"ASIN", [](double x) { return std::asin(x); }},   {"ACOS", [](double x) { return std::acos(x); }},
       {"ATAN", [](double x) { return std::atan(x); }},   {"SINH", [](double x) { return std::sinh(x); }},
       {"COSH", [](double x) { return std::cosh(x); }},   {"TANH", [](double x) { return std::tanh(x); }},
       {"ASINH", [](double x) { return std::asinh(x); }}, {"ACOSH", [](double x) { return std::acosh(x); }},
       {"ATANH", [](double x) { return std::atanh(x); }}, {"SQRT", [](double x) { return std::sqrt(x); }},
       {"EXP", [](double x) { return std::exp(x); }},     {"LOG", [](double x) { return std::log(x); }},
       {"LOG10", [](double x) { return std::log10(x); }}, {"FLOAT", [](double x) { return x; }}}};

  ExpressionValue function(const std::string& name) {
    Arguments x;
    if (!take(")")) {
      do {
        if (x.size() == 20) fail({name.substr(0, 40), " has more than 20 arguments"});
        x.push_back(sum());
      } while (take(","));
      if (!take(")")) fail({"the parenthesis after ", name.substr(0, 40), " is not closed"});
    }
    if (name == "PI" && x.empty()) return {std::numbers::pi, false};
    const auto expect = [&](std::size_t least, std::size_t most) {
      if (x.size() < least || x.size() > most)
        fail({name, " has ", std::to_string(x.size()), x.size() == 1 ? " argument" : " arguments"});
    };
    if (name == "MIN" || name == "MAX") {
      expect(1, 20);
      const auto below = [](const auto& a, const auto& b) { return a.value < b.value; };
      const bool all_whole = std::all_of(x.begin(), x.end(), [](const auto& a) { return a.is_whole; });
      const auto [least, most] = std::minmax_element(x.begin(), x.end(), below);
      return {name == "MIN" ? least->value : most->value, all_whole};
    }
    if (name == "ATAN2" || name == "SIGN" || name == "MOD") {
      expect(2, 2);
      if (name == "ATAN2") return checked(std::atan2(x[0].value, x[1].value), false);
      if (name == "SIGN") return {x[1].value < 0 ? -std::abs(x[0].value) : std::abs(x[0].value), x[0].is_whole};
      if (std::round(x[1].value) == 0) fail({"MOD divides by 0"});
      return checked(std::fmod(std::round(x[0].value), std::round(x[1].value)), true);
    }
    if (name == "ABS") return expect(1, 1), ExpressionValue{std::abs(x[0].value), x[0].is_whole};
    if (name == "INT" || name == "AINT") return expect(1, 1), checked(std::trunc(x[0].value), name == "INT");
    if (name == "NINT" || name == "ANINT") return expect(1, 1), checked(std::round(x[0].value), name == "NINT");
    for (const Function& known : functions)
      if (known.name == name) return expect(1, 1), checked(known.of(x[0].value), false);
    fail({"no function is called '", name.substr(0, 40), "'"});
  }

  std::string_view rest_;
  const Lookup& lookup_;
  bool is_python_;
  int depth_ = 0;
};

}  // namespace strike::detail
