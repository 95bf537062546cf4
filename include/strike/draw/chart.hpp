#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <strike/draw/svg.hpp>
#include <strike/error.hpp>
#include <strike/output/file.hpp>
#include <strike/range.hpp>
#include <strike/text.hpp>

namespace strike {

enum class Scale { linear, logarithmic };

/// An axis of a chart.
struct ChartAxis {
  std::string label = {}, unit = {};
  Scale scale = Scale::linear;
  double lower = std::numeric_limits<double>::quiet_NaN();  ///< first value; NaN: a round one below the data
  double upper = std::numeric_limits<double>::quiet_NaN();  ///< last value; NaN: a round one above the data

  void ranges(const auto& number) const {
    const Range of_scale = scale == Scale::logarithmic ? range::positive : range::finite;
    number("lower", lower, range::or_nan(of_scale));
    number("upper", upper, range::or_nan(of_scale));
    if (!std::isnan(lower)) number("upper", upper, range::or_nan(range::above(lower)));
  }
};

enum class Line { none, solid, dashed, dotted };
enum class Marker { none, circle, square, triangle, diamond, cross };

/// Style of a curve; by default in the next colour of the palette.
struct Style {
  static constexpr int next = -1;
  Line line = Line::solid;
  Marker marker = Marker::none;
  int colour = next;  ///< place in the palette of Okabe and Ito, 0 ... 6
  double width = 2;   ///< [px]

  void ranges(const auto& number) const {
    number("colour", colour, range::between(-1, 6));
    number("width", width, range::not_negative);
  }
};

/// Options of a chart.
struct ChartOptions {
  std::string title = {}, caption = {};
  ChartAxis x = {}, y = {};
  double width = 760, height = 480;  ///< [px], without the caption

  void ranges(const auto& number) const {
    number(x), number(y);
    number("width", width, range::at_least(200));
    number("height", height, range::at_least(200));
  }
};

/// Curves and points over two axes, as SVG: `chart.curve("length", t, L); chart.points("X3D", {80}, {21.47});`
/// Colours are those of Okabe and Ito (2008, "Color Universal Design"), distinct to colour-blind eyes.
class Chart {
 public:
  /// Error: a number out of its range.
  explicit Chart(ChartOptions options) : options_(std::move(options)) { detail::check_ranges(options_); }

  /// A line through the points; NaN leaves a gap. Errors: x and y of different length; a value that a logarithmic axis
  /// cannot show; a style out of its range.
  [[gnu::cold]] void curve(std::string name, std::span<const double> x, std::span<const double> y, Style style = {}) {
    detail::check_ranges(style);
    if (x.size() != y.size())
      throw Error(detail::joined({"strike: the curve '", name, "' has ", std::to_string(x.size()), " x and ",
                                  std::to_string(y.size()), " y: give as many of both."}));
    for (std::size_t i = 0; i < x.size(); ++i)
      if ((options_.x.scale == Scale::logarithmic && x[i] <= 0) ||
          (options_.y.scale == Scale::logarithmic && y[i] <= 0))
        throw Error(detail::joined({"strike: point ", std::to_string(i), " of the curve '", name, "' at (",
                                    detail::shortest(x[i]), ", ", detail::shortest(y[i]),
                                    ") is not on a logarithmic axis: give positive values."}));
    if (style.colour == Style::next) style.colour = static_cast<int>(curves_.size() % palette.size());
    curves_.push_back({std::move(name), {x.begin(), x.end()}, {y.begin(), y.end()}, style});
  }

  /// Points without a line, a new marker for each set unless the style names one.
  void points(std::string name, std::span<const double> x, std::span<const double> y, Style style = {}) {
    constexpr Marker turn[] = {Marker::circle, Marker::square, Marker::triangle, Marker::diamond, Marker::cross};
    if (style.marker == Marker::none) style.marker = turn[curves_.size() % std::size(turn)];
    style.line = Line::none;
    curve(std::move(name), x, y, style);
  }
  void points(std::string name, std::initializer_list<double> x, std::initializer_list<double> y, Style style = {}) {
    points(std::move(name), std::span(x.begin(), x.size()), std::span(y.begin(), y.size()), style);
  }

  /// A thin level line at a value that is known from elsewhere.
  void reference(double y, std::string label) {
    detail::RangeCheck("reference", "")("y", y,
                                        options_.y.scale == Scale::logarithmic ? range::positive : range::finite);
    references_.push_back({y, std::move(label)});
  }

  /// Writes the SVG file. Errors: nothing to draw; a file that cannot be written.
  void write(const std::string& path) const { detail::replace_file(path, svg()); }

  /// The SVG text.
  [[gnu::cold]] std::string svg() const {
    if (curves_.empty())
      throw Error(detail::joined({"strike: the Chart '", options_.title, "' has no curve: add one first."}));
    constexpr double left = 84, right = 32, margin = 32;
    detail::Svg svg;
    double top = 36;
    if (!options_.title.empty()) {
      svg.text(margin, 44, options_.title, {.size = 20, .fill = "#1a1a1a", .weight = "600"});
      top = 72;
    }
    top = draw_legend(svg, margin, top) + 14;
    const double bottom = options_.height - 68;

    Extent x_extent{options_.x, 8}, y_extent{options_.y, 6};
    for (const Curve& curve : curves_)
      for (std::size_t i = 0; i < curve.x.size(); ++i)
        if (std::isfinite(curve.x[i]) && std::isfinite(curve.y[i])) {
          x_extent.include(curve.x[i]);
          y_extent.include(curve.y[i]);
        }
    for (const Reference& reference : references_) y_extent.include(reference.y);
    x_extent.close();
    y_extent.close();
    const auto px = [&](double x) { return left + (options_.width - right - left) * x_extent.fraction(x); };
    const auto py = [&](double y) { return bottom - (bottom - top) * y_extent.fraction(y); };

    for (const auto& [at, label] : y_extent.marks()) {
      svg.line(left, py(at), options_.width - right, py(at), "#e6e6e6", 1);
      svg.text(left - 10, py(at) + 4.5, label, {.fill = "#4d4d4d", .anchor = detail::Anchor::end});
    }
    for (const auto& [at, label] : x_extent.marks()) {
      svg.line(px(at), top, px(at), bottom, "#f0f0f0", 1);
      svg.line(px(at), bottom, px(at), bottom + 5, "#4d4d4d", 1);
      svg.text(px(at), bottom + 21, label, {.fill = "#4d4d4d", .anchor = detail::Anchor::middle});
    }
    svg.line(left, bottom, options_.width - right, bottom, "#4d4d4d", 1.2);
    svg.text((left + options_.width - right) / 2, bottom + 48, options_.x.label + x_extent.unit_label(),
             {.size = 14, .fill = "#1a1a1a", .anchor = detail::Anchor::middle});
    const double middle = (top + bottom) / 2;
    svg.text(26, middle, options_.y.label + y_extent.unit_label(),
             {.size = 14, .fill = "#1a1a1a", .anchor = detail::Anchor::middle, .turn = 90});

    svg.open("clipPath", {{"id", "plot"}});
    svg.element("rect", {{"x", left - 6},
                         {"y", top - 6},
                         {"width", options_.width - right - left + 12},
                         {"height", bottom - top + 12}});
    svg.close();
    svg.open("g", {{"clip-path", "url(#plot)"}});
    for (const Reference& reference : references_)
      svg.line(left, py(reference.y), options_.width - right, py(reference.y), "#808080", 1.2, "2 3");
    for (const Curve& curve : curves_) draw(svg, curve, px, py);
    svg.close();
    for (const Reference& reference : references_)
      svg.text(options_.width - right - 2, py(reference.y) - 6, reference.label,
               {.size = 12, .fill = "#595959", .anchor = detail::Anchor::end, .halo = "#ffffff"});

    double foot = options_.height;
    if (!options_.caption.empty())
      foot = svg.paragraph(margin, foot + 6, options_.caption, options_.width - 2 * margin, {.fill = "#595959"}) + 12;
    return svg.file(options_.width, foot);
  }

  /// Okabe and Ito's colours, the darker ones first; yellow is left out, being too light for a line on white.
  static constexpr std::array<std::string_view, 7> palette{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                           "#000000", "#e69f00", "#56b4e9"};

 private:
  struct Curve {
    std::string name;
    std::vector<double> x, y;
    Style style;
    std::string_view colour() const { return palette[static_cast<std::size_t>(style.colour) % palette.size()]; }
  };
  struct Reference {
    double y;
    std::string label;
  };

  /// The values that an axis spans, and the marks on it.
  struct Extent {
    const ChartAxis& axis;
    double count;  // about how many marks
    double lower = std::numeric_limits<double>::infinity(), upper = -std::numeric_limits<double>::infinity();
    detail::Ticks ticks = {};

    bool logarithmic() const { return axis.scale == Scale::logarithmic; }
    void include(double value) {
      lower = std::min(lower, value);
      upper = std::max(upper, value);
    }
    /// Settles the ends: given, or round ones around the data.
    void close() {
      if (!(lower <= upper)) lower = upper = 1;
      if (!std::isnan(axis.lower)) lower = axis.lower;
      if (!std::isnan(axis.upper)) upper = axis.upper;
      if (logarithmic()) {
        if (std::isnan(axis.lower)) lower = round_below(lower);
        if (std::isnan(axis.upper)) upper = round_above(upper);
        if (!(upper > lower)) upper = 10 * lower;
        return;
      }
      if (!(upper > lower)) {
        const double half = lower != 0 ? 0.1 * std::abs(lower) : 1;
        lower -= half;
        upper += half;
      }
      ticks = detail::Ticks::between(lower, upper, count);
      if (std::isnan(axis.lower)) lower = ticks.below(lower);
      if (std::isnan(axis.upper)) upper = ticks.above(upper);
    }
    double fraction(double value) const {
      return logarithmic() ? std::log(value / lower) / std::log(upper / lower) : (value - lower) / (upper - lower);
    }
    [[gnu::cold]] std::vector<std::pair<double, std::string>> marks() const {
      std::vector<std::pair<double, std::string>> list;
      if (!logarithmic()) {
        for (const double at : ticks.in(lower, upper)) list.emplace_back(at, ticks.label(at));
        return list;
      }
      const bool few = upper / lower < 300;  // decades alone would be too few
      for (int k = static_cast<int>(std::floor(std::log10(lower))); k <= std::ceil(std::log10(upper)); ++k)
        for (const double digit : {1.0, 2.0, 5.0}) {
          const double at = digit * std::pow(10.0, k);
          if (at < lower * (1 - 1e-9) || at > upper * (1 + 1e-9) || (digit > 1 && !few)) continue;
          list.emplace_back(at, label(digit, k));
        }
      return list;
    }
    std::string unit_label() const { return ticks.unit_label(axis.unit); }

   private:
    std::string label(double digit, int exponent) const {
      if (lower >= 0.9e-3 && upper <= 1.1e4) return detail::shortest(digit * std::pow(10.0, exponent));
      const std::string power = detail::Ticks::power_of_ten(exponent);
      return digit > 1 ? detail::joined({detail::shortest(digit), "\u00b7", power}) : power;
    }
    double round_below(double x) const {
      const double power = std::pow(10.0, std::floor(std::log10(x) + 1e-9));
      return power * (x >= 5 * power ? 5 : x >= 2 * power ? 2 : 1);
    }
    double round_above(double x) const {
      const double power = std::pow(10.0, std::floor(std::log10(x) + 1e-9));
      return power * (x <= power * (1 + 1e-9) ? 1 : x <= 2 * power ? 2 : x <= 5 * power ? 5 : 10);
    }
  };

  /// Outline of a marker of radius r.
  [[gnu::cold]] static std::string marker_path(Marker marker, double x, double y, double r) {
    using Corners = std::vector<std::array<double, 2>>;
    const auto through = [&](const Corners& corners, std::string_view end) {
      std::string path;
      for (const auto& [dx, dy] : corners)
        path += detail::joined({path.empty() ? "M" : "L", detail::pixels(x + r * dx), " ", detail::pixels(y + r * dy)});
      return path += end;
    };
    switch (marker) {
      case Marker::square:
        return through({{-.9, -.9}, {.9, -.9}, {.9, .9}, {-.9, .9}}, "z");
      case Marker::triangle:
        return through({{0, -1.2}, {1.1, .8}, {-1.1, .8}}, "z");
      case Marker::diamond:
        return through({{0, -1.3}, {1.1, 0}, {0, 1.3}, {-1.1, 0}}, "z");
      case Marker::cross:
        return through({{-.9, -.9}, {.9, .9}}, "") + through({{-.9, .9}, {.9, -.9}}, "");
      default: {
        const std::string size = detail::pixels(r), across = detail::pixels(2 * r);
        const auto half_turn = detail::joined({"a", size, " ", size, " 0 1 1 "});
        return detail::joined({through({{-1, 0}}, ""), half_turn, across, " 0", half_turn, "-", across, " 0z"});
      }
    }
  }

  template <class X, class Y>
  [[gnu::cold]] static void draw(detail::Svg& svg, const Curve& curve, const X& px, const Y& py) {
    std::string line, markers;
    double last_x = 0, last_y = 0;
    bool pen_down = false;
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
      if (!std::isfinite(curve.x[i]) || !std::isfinite(curve.y[i])) {
        pen_down = false;  // a gap
        continue;
      }
      const double x = px(curve.x[i]), y = py(curve.y[i]);
      if (curve.style.marker != Marker::none) markers += marker_path(curve.style.marker, x, y, 4.5);
      const bool same = pen_down && i + 1 < curve.x.size() && std::hypot(x - last_x, y - last_y) < 0.4;
      if (same) continue;  // less than half a pixel on
      line += detail::joined({pen_down ? "L" : "M", detail::pixels(x), " ", detail::pixels(y)});
      pen_down = true;
      last_x = x;
      last_y = y;
    }
    constexpr std::string_view dashes[] = {"", "", "8 5", "2 4"};
    if (curve.style.line != Line::none)
      svg.element("path", {{"fill", "none"},
                           {"stroke", curve.colour()},
                           {"stroke-width", curve.style.width},
                           {"stroke-linejoin", "round"},
                           {"stroke-linecap", "round"},
                           {"stroke-dasharray", dashes[static_cast<int>(curve.style.line)]},
                           {"d", line}});
    const bool hollow = curve.style.marker == Marker::cross;
    if (!markers.empty())
      svg.element("path", {{"fill", hollow ? "none" : curve.colour()},
                           {"stroke", hollow ? curve.colour() : "#ffffff"},
                           {"stroke-width", hollow ? 2 : 1},
                           {"d", markers}});
  }

  /// Names of the curves in a row below the title; gives the y below them.
  [[gnu::cold]] double draw_legend(detail::Svg& svg, double margin, double y) const {
    double x = margin;
    for (const Curve& curve : curves_) {
      if (curve.name.empty()) continue;
      const double width = 34 + detail::text_width(curve.name, 13) + 22;
      if (x > margin && x + width > options_.width - margin) {
        x = margin;
        y += 22;
      }
      draw_sample(svg, curve.style, x, y);
      svg.text(x + 34, y + 4.5, curve.name, {.fill = "#1a1a1a"});
      x += width;
    }
    return y + 14;
  }

  static void draw_sample(detail::Svg& svg, const Style& style, double x0, double y0) {
    Style line = style, marker = style;
    line.marker = Marker::none;
    marker.line = Line::none;
    const auto px = [x0](double x) { return x0 + x; };
    const auto py = [y0](double y) { return y0 + y; };
    draw(svg, {.name = {}, .x = {0, 26}, .y = {0, 0}, .style = line}, px, py);
    draw(svg, {.name = {}, .x = {13}, .y = {0}, .style = marker}, px, py);
  }

  ChartOptions options_;
  std::vector<Curve> curves_;
  std::vector<Reference> references_;
};

}  // namespace strike
