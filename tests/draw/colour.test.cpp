#include <cmath>
#include <limits>

#include <strike/draw/colour.hpp>

#include "support/catch.hpp"

using namespace strike;

TEST_CASE("colours: white, black and pure red as Ottosson's space places them") {
  CHECK(Colour{1, 0, 0}.hex() == "#ffffff");
  CHECK(Colour{0, 0, 0}.hex() == "#000000");
  CHECK(Colour{0.627955, 0.257683, 29.2339}.hex() == "#ff0000");                             // OKLCH of sRGB red
  CHECK(Colour{0.5, 0, 123}.srgb()[0] == Approx(Colour{0.5, 0, 7}.srgb()[2]).margin(1e-6));  // greys have no hue
}

TEST_CASE("colour maps: every colour exists on a screen, lightness runs evenly one way") {
  for (const ColourMap& map : {colour_maps::ember, colour_maps::lagoon}) {
    const double step = (map.high.lightness - map.low.lightness) / 256;
    for (int i = 0; i <= 256; ++i) {
      const Colour colour = map(i / 256.0);
      CHECK(colour.lightness == Approx(map.low.lightness + i * step).epsilon(1e-12));
      for (const double channel : colour.srgb()) {
        CHECK(channel >= -0.01);  // a step of 1/255 does not show
        CHECK(channel <= 1.01);
      }
      CHECK(colour.chroma >= 0);
    }
    CHECK(std::abs(map.high.lightness - map.low.lightness) > 0.5);  // readable in grey print
  }
}

TEST_CASE("colour maps: values beyond the ends take the ends, no number is grey") {
  CHECK(colour_maps::ember(-3).hex() == colour_maps::ember(0).hex());
  CHECK(colour_maps::ember(7).hex() == colour_maps::ember(1).hex());
  CHECK(colour_maps::ember(std::numeric_limits<double>::quiet_NaN()).chroma == 0);
}
