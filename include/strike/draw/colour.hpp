#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include <strike/cxx20.hpp>
#include <strike/range.hpp>

namespace strike {

/// A colour by lightness (0 black ... 1 white), chroma (0 grey) and hue [degrees] in OKLab, a space in which equal
/// distances look equal (Ottosson 2020, "A perceptual color space for image processing").
struct Colour {
  double lightness, chroma, hue;

  void ranges(const auto& number) const {
    number("lightness", lightness, range::share);
    number("chroma", chroma, range::not_negative);
    number("hue", hue, range::finite);
  }

  /// Red, green, blue in 0 ... 1 (sRGB, IEC 61966-2-1), unclamped: outside 0 ... 1 no screen shows the colour.
  std::array<double, 3> srgb() const {
    const double a = chroma * std::cos(hue * std::numbers::pi / 180),
                 b = chroma * std::sin(hue * std::numbers::pi / 180);
    const auto cube = [](double x) { return x * x * x; };
    const double l = cube(lightness + 0.3963377774 * a + 0.2158037573 * b);
    const double m = cube(lightness - 0.1055613458 * a - 0.0638541728 * b);
    const double s = cube(lightness - 0.0894841775 * a - 1.2914855480 * b);
    const auto encode = [](double c) { return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055; };
    return {encode(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
            encode(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
            encode(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
  }

  /// Text of the colour in SVG: #rrggbb.
  std::string hex() const {
    std::string text = "#";
    for (const double channel : srgb()) {
      const auto byte = std::lround(255 * std::clamp(channel, 0.0, 1.0));
      text += "0123456789abcdef"[byte / 16];
      text += "0123456789abcdef"[byte % 16];
    }
    return text;
  }

  /// The colour in less light: 1 unchanged, 0 black.
  Colour in_light(double light) const { return {lightness * light, chroma * light, hue}; }
};

/// Colours from small to large values: lightness, and with it the look of the map in grey print or to a colour-blind
/// eye, runs evenly from one end to the other while hue turns.
struct ColourMap {
  Colour low, high;
  double middle_chroma;  ///< chroma runs through it on a parabola

  void ranges(const auto& number) const {
    number(low), number(high);
    number("middle_chroma", middle_chroma, range::not_negative);
  }

  /// The colour at t in 0 ... 1 (clamped); grey if t is not a number.
  Colour operator()(double t) const {
    if (std::isnan(t)) return {0.75, 0, 0};
    t = std::clamp(t, 0.0, 1.0);
    const auto mix = [t](double a, double b) { return a + t * (b - a); };
    const double bulge = 4 * t * (1 - t) * (middle_chroma - (low.chroma + high.chroma) / 2);
    return {mix(low.lightness, high.lightness), mix(low.chroma, high.chroma) + bulge, mix(low.hue, high.hue)};
  }
};

namespace colour_maps {
/// Cream, amber, red, plum.
inline constexpr ColourMap ember{.low = {0.965, 0.035, 95}, .high = {0.30, 0.115, -15}, .middle_chroma = 0.165};
/// Night blue, teal, green, yellow.
inline constexpr ColourMap lagoon{.low = {0.34, 0.095, 275}, .high = {0.93, 0.155, 105}, .middle_chroma = 0.095};
}  // namespace colour_maps

}  // namespace strike
