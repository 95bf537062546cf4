#pragma once
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <strike/output/xml.hpp>
#include <strike/text.hpp>

namespace strike::detail {

enum class Anchor { start, middle, end };

/// Style of a text.
struct Font {
  double size = 13;  // [px]
  std::string_view fill = "#333333";
  Anchor anchor = Anchor::start;
  std::string_view weight = {};  // "600"
  std::string_view halo = {};    // colour of a rim that sets the text off from the drawing below
  double turn = 0;               // counter-clockwise about its place [degrees]
};

/// Width of a text [px], estimated: a mean letter of a plain font is 0.53 of its size wide.
inline double text_width(std::string_view text, double size) {
  const auto letters = std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; });  // UTF-8
  return 0.53 * size * static_cast<double>(letters);
}

/// Words in lines of at most `width` [px].
[[gnu::cold]] inline std::vector<std::string> wrapped(std::string_view text, double size, double width) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::string word(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (!lines.empty() && text_width(lines.back() + ' ' + word, size) <= width)
      lines.back() += ' ' + word;
    else
      lines.push_back(word);
  }
  return lines;
}

/// A drawing being written, y downward, in pixels.
class Svg : public Xml {
 public:
  [[gnu::cold]] void line(double x1, double y1, double x2, double y2, std::string_view stroke, double width,
                          std::string_view dashes = "") {
    element("line", {{"x1", x1},
                     {"y1", y1},
                     {"x2", x2},
                     {"y2", y2},
                     {"stroke", stroke},
                     {"stroke-width", width},
                     {"stroke-dasharray", dashes}});
  }

  [[gnu::cold]] void text(double x, double y, std::string_view words, const Font& font = {}) {
    constexpr std::string_view anchors[] = {"", "middle", "end"};
    const std::string turn = joined({"rotate(", pixels(-font.turn), " ", pixels(x), " ", pixels(y), ")"});
    element("text",
            {{"x", x},
             {"y", y},
             {"font-size", font.size},
             {"fill", font.fill},
             {"text-anchor", anchors[static_cast<int>(font.anchor)]},
             {"font-weight", font.weight},
             {"stroke", font.halo},
             {"stroke-width", font.halo.empty() ? "" : "3"},
             {"paint-order", font.halo.empty() ? "" : "stroke"},
             {"transform", font.turn == 0 ? "" : std::string_view(turn)}},
            xml_escaped(words));
  }

  /// Lines of a paragraph from y downward; gives the y after it.
  [[gnu::cold]] double paragraph(double x, double y, std::string_view words, double width, const Font& font = {}) {
    for (const std::string& line : wrapped(words, font.size, width)) {
      text(x, y, line, font);
      y += 1.45 * font.size;
    }
    return y;
  }

  /// The whole file, on white ground.
  std::string file(double width, double height) const {
    Xml svg;
    svg.open("svg", {{"xmlns", "http://www.w3.org/2000/svg"},
                     {"width", width},
                     {"height", height},
                     {"viewBox", joined({"0 0 ", pixels(width), " ", pixels(height)})},
                     {"font-family", "Inter, 'Helvetica Neue', Helvetica, Arial, 'DejaVu Sans', sans-serif"}});
    svg.element("rect", {{"width", width}, {"height", height}, {"fill", "#ffffff"}});
    svg.raw(str());
    svg.close();
    return svg.str();
  }
};

/// Round positions for marks on an axis: multiples of 1, 2 or 5 times a power of ten.
struct Ticks {
  double step = 1;
  int exponent = 0;  ///< labels are in units of 10^exponent, a multiple of 3, so that they stay short

  /// About `count` steps between two values.
  static Ticks between(double lower, double upper, double count) {
    Ticks ticks;
    const double raw = (upper - lower) / count;
    const double power = std::pow(10.0, std::floor(std::log10(raw)));
    ticks.step = power * (raw <= 1.5 * power ? 1 : raw <= 3.5 * power ? 2 : raw <= 7.5 * power ? 5 : 10);
    const double largest = std::max(std::abs(lower), std::abs(upper));
    if (largest >= 1e4 * (1 + 1e-9) || largest < 0.0099)
      ticks.exponent = 3 * static_cast<int>(std::floor(std::log10(largest * (1 + 1e-9)) / 3));
    return ticks;
  }

  double below(double x) const { return step * std::floor(x / step + 1e-9); }
  double above(double x) const { return step * std::ceil(x / step - 1e-9); }

  /// The multiples of the step in [lower, upper].
  std::vector<double> in(double lower, double upper) const {
    std::vector<double> marks;
    const auto first = static_cast<long>(std::ceil(lower / step - 1e-9));
    for (long i = first; static_cast<double>(i) * step <= upper + 1e-9 * step; ++i)
      marks.push_back(static_cast<double>(i) * step);
    return marks;
  }

  std::string label(double x) const {
    const double unit = std::pow(10.0, exponent);
    const int decimals = std::max(0, -static_cast<int>(std::floor(std::log10(step / unit) + 1e-9)));
    char text[32];
    std::snprintf(text, sizeof text, "%.*f", decimals, std::abs(x) / unit + 0.0);
    return joined({x < -1e-9 * step ? "\u2212" : "", text});
  }

  /// "[unit]", with the power of ten that the labels leave out.
  std::string unit_label(std::string_view unit) const {
    const std::string power = exponent ? power_of_ten(exponent) : "";
    if (power.empty() && unit.empty()) return "";
    return joined({" [", power, power.empty() || unit.empty() ? "" : " ", unit, "]"});
  }

  static std::string power_of_ten(int exponent) {
    constexpr const char* raised[] = {"\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074",
                                      "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
    std::string text = "10";
    if (exponent < 0) text += "\u207b";
    for (const char digit : std::to_string(std::abs(exponent))) text += raised[digit - '0'];
    return text;
  }
};

}  // namespace strike::detail
