#include <cmath>
#include <numbers>
#include <string>

#include <strike/input/expression.hpp>

#include "support/catch.hpp"

using namespace strike::detail;

namespace {

ExpressionValue value_of(const std::string& text) {
  const auto lookup = [](const std::string& name) -> std::optional<ExpressionValue> {
    if (name == "N") return ExpressionValue{5, true};
    if (name == "LENGTH") return ExpressionValue{2.5, false};
    return std::nullopt;
  };
  return Formula(text, lookup).value();
}
std::string reason(const std::string& text) {
  try {
    value_of(text);
  } catch (const NotEvaluated& error) {
    return error.why;
  }
  return "";
}

}  // namespace

TEST_CASE("expression: precedence, signs and powers are those of the manual") {
  const std::pair<const char*, double> real[] = {
      {"1.5+2*3.", 7.5},      {"2.*(1+2)", 6},         {"-3.**2", 9},
      {"2**3.**2", 512},      {"2.^-1", 0.5},          {"8./4/2", 1},
      {"1-2.-3", -4},         {"--2.5", 2.5},          {"1.e2+1.5D-1+2d0", 102.15},
      {"&length * 2", 5},     {"-&Length", -2.5},      {"length/n", 0.5},
      {"2.0/5", 0.4},         {"sqrt(2)**2", 2},       {"sin(pi/6)", 0.5},
      {"cos(60*dtor)", 0.5},  {"atan2(1,1)*rtod", 45}, {"max(1, 2.5,2)", 2.5},
      {"min(n,length)", 2.5}, {"log(exp(3))", 3},      {"log10(1000)", 3},
      {"aint(-2.7)", -2},     {"anint(2.5)", 3},       {"float(7)/2", 3.5},
      {"sign(-4.,8)", 4},     {"acosh(cosh(2))", 2},   {"1/csc(0.5)-sin(.5)", 0}};
  for (const auto& [text, expected] : real) {
    INFO(text);
    CHECK(value_of(text).value == Approx(expected).margin(1e-15));  // to rounding
    CHECK_FALSE(value_of(text).is_whole);
  }
}

TEST_CASE("expression: whole numbers stay whole, and divide with truncation") {
  const std::pair<const char*, double> whole[] = {
      {"2/5", 0},        {"-7/2", -3},        {"n/2*2", 4},     {"-3**2", 9},   {"2**-1", 0},    {"mod(-7,2)", -1},
      {"mod(7.6,3)", 2}, {"int(-48.1)", -48}, {"nint(2.5)", 3}, {"abs(-n)", 5}, {"max(1,n)", 5}, {"sign(-4,8)", 4}};
  for (const auto& [text, expected] : whole) {
    INFO(text);
    CHECK(value_of(text).value == expected);
    CHECK(value_of(text).is_whole);
  }
}

TEST_CASE("expression: without a value, with the reason") {
  const std::pair<std::string, std::string> wrong[] = {{"", "it ends where a number or a name should stand"},
                                                       {"1+", "it ends where a number or a name should stand"},
                                                       {"1 2", "'2' is more than the expression"},
                                                       {"(1", "a parenthesis is not closed"},
                                                       {"sin(1", "the parenthesis after SIN is not closed"},
                                                       {"1/0", "it divides by 0"},
                                                       {"mod(1,0.2)", "MOD divides by 0"},
                                                       {"width*2", "parameter 'WIDTH' is not defined above"},
                                                       {"erf(1)", "no function is called 'ERF'"},
                                                       {"sin(1,2)", "SIN has 2 arguments"},
                                                       {"max()", "MAX has 0 arguments"},
                                                       {"sqrt(-1)", "a result is not finite"},
                                                       {"10.**400", "a result is not finite"},
                                                       {"10**17", "a whole number is larger than 9e15"},
                                                       {"2 ? 3", "'? 3' is more than the expression"},
                                                       {"?", "no number or name is '?'"},
                                                       {".", "'.' is no number"},
                                                       {std::string(1000, '(') + "1", "it is more than 60 levels deep"},
                                                       {"2" +
                                                            [] {
                                                              std::string towers;
                                                              for (int i = 0; i < 1000; ++i) towers += "**1";
                                                              return towers;
                                                            }(),
                                                        "it is more than 60 levels deep"}};
  for (const auto& [text, why] : wrong) {
    INFO(text);
    CHECK(reason(text) == why);
  }
  CHECK(value_of(std::string(100'000, '-') + "1").value == 1);  // no recursion
}
