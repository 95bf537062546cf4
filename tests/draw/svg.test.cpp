#include <cmath>

#include <strike/draw/svg.hpp>

#include "support/catch.hpp"

using namespace strike::detail;

TEST_CASE("ticks are multiples of 1, 2 or 5 times a power of ten, about as many as asked") {
  for (double range = 1.37e-7; range < 1e9; range *= 1.7) {
    const Ticks ticks = Ticks::between(0, range, 6);
    const double mantissa = ticks.step / std::pow(10, std::floor(std::log10(ticks.step) + 1e-9));
    CHECK((std::abs(mantissa - 1) < 1e-9 || std::abs(mantissa - 2) < 1e-9 || std::abs(mantissa - 5) < 1e-9));
    CHECK(range / ticks.step > 6 / 2.4);  // the rounding of the step is at most by 7.5/5 up or 3.5/2 down
    CHECK(range / ticks.step < 6 * 2);
  }
}

TEST_CASE("ticks cover the range between round ends") {
  const Ticks ticks = Ticks::between(-0.3, 1.24, 6);
  CHECK(ticks.step == Approx(0.2));
  CHECK(ticks.below(-0.3) == Approx(-0.4));
  CHECK(ticks.above(1.24) == Approx(1.4));
  CHECK(ticks.above(1.2) == Approx(1.2));
  CHECK(ticks.in(-0.4, 1.4).size() == 10);
  CHECK(ticks.label(0.6) == "0.6");
  CHECK(ticks.label(-0.4) == "\u22120.4");
  CHECK(ticks.label(-1e-17) == "0.0");
}

TEST_CASE("ticks leave a power of ten to the unit where labels would be long") {
  const Ticks micro = Ticks::between(0, 8e-5, 8);
  CHECK(micro.label(3e-5) == "30");
  CHECK(micro.unit_label("s") == " [10\u207b\u2076 s]");
  const Ticks large = Ticks::between(0, 240000, 6);
  CHECK(large.label(50000) == "50");
  CHECK(large.unit_label("") == " [10\u00b3]");
  CHECK(Ticks::between(0, 240, 6).unit_label("J") == " [J]");
  CHECK(Ticks::between(0, 240, 6).unit_label("") == "");
}

TEST_CASE("wrapped breaks between words only") {
  const auto lines = wrapped("one two three four", 10, text_width("one two", 10));
  CHECK(lines == std::vector<std::string>{"one two", "three", "four"});
  CHECK(wrapped("unbreakable", 10, 1) == std::vector<std::string>{"unbreakable"});
  CHECK(wrapped("", 10, 100).empty());
  CHECK(text_width("\u00b5m", 10) == Approx(text_width("mm", 10)));  // letters, not bytes
}
