#include <cmath>
#include <cstdlib>
#include <limits>

#include <strike/draw/chart.hpp>

#include "drawing.hpp"
#include "output/scratch.hpp"
#include "support/catch.hpp"

using namespace strike;

namespace {
/// Numbers in the first path that strokes a curve, in order.
std::vector<double> numbers_of_curve(const std::string& svg) {
  const std::size_t curve = svg.find("<path", svg.find("clip-path="));
  const std::size_t begin = svg.find(" d=\"", curve) + 4;
  std::string path = svg.substr(begin, svg.find('"', begin) - begin);
  std::vector<double> numbers;
  for (char& c : path)
    if (c == 'M' || c == 'L') c = ' ';
  const char* at = path.c_str();
  for (char* end = nullptr;; at = end) {
    const double number = std::strtod(at, &end);
    if (end == at) return numbers;
    numbers.push_back(number);
  }
}
}  // namespace

TEST_CASE("chart: a straight line is straight, on linear and on logarithmic axes") {
  const std::vector<double> x{1, 10, 100, 1000}, power{2, 20, 200, 2000}, line{3, 21, 201, 2001};
  Chart loglog{{.x = {.scale = Scale::logarithmic}, .y = {.scale = Scale::logarithmic}}}, linear{{}};
  loglog.curve("y = 2 x", x, power);
  linear.curve("y = 1 + 2 x", x, line);
  for (const Chart* chart : {&loglog, &linear}) {
    const auto p = numbers_of_curve(chart->svg());
    REQUIRE(p.size() == 8);
    const double slope = (p[7] - p[1]) / (p[6] - p[0]);
    CHECK(slope < 0);  // y grows upward
    for (std::size_t i = 2; i < 8; i += 2)
      CHECK(p[i + 1] - p[1] == Approx(slope * (p[i] - p[0])).margin(0.03));  // two decimals, thrice
  }
  const auto p = numbers_of_curve(loglog.svg());
  CHECK(p[2] - p[0] == Approx(p[4] - p[2]).margin(0.03));  // decades are equally long
}

TEST_CASE("chart: axes end at round numbers, with labels and units") {
  Chart chart{
      {.title = "T", .caption = "C", .x = {.label = "Time", .unit = "us"}, .y = {.label = "Length", .unit = "mm"}}};
  chart.curve("L", std::vector<double>{0, 79.9}, std::vector<double>{21.6, 32.4});
  const std::string svg = chart.svg();
  CHECK(well_formed(svg));
  for (const char* text : {">T<", ">C<", ">L<", ">Time [us]<", ">Length [mm]<", ">0<", ">80<", ">20<", ">34<"}) {
    CAPTURE(text);
    CHECK(svg.find(text) != std::string::npos);
  }
  CHECK(svg.find(">90<") == std::string::npos);
}

TEST_CASE("chart: logarithmic marks are plain over few decades, powers of ten over many") {
  Chart few{{.y = {.scale = Scale::logarithmic}}}, many{{.y = {.scale = Scale::logarithmic}}};
  few.curve("", std::vector<double>{0, 1}, std::vector<double>{0.06, 3});
  many.curve("", std::vector<double>{0, 1}, std::vector<double>{1e-9, 3});
  for (const char* mark : {">0.05<", ">0.1<", ">0.2<", ">5<"}) CHECK(few.svg().find(mark) != std::string::npos);
  CHECK(many.svg().find(">10\u207b\u2079<") != std::string::npos);
  CHECK(many.svg().find(">10\u2070<") != std::string::npos);
}

TEST_CASE("chart: a value that is no number is a gap, a constant and a single point have room") {
  Chart chart{{}};
  chart.curve("gap", std::vector<double>{0, 1, 2, 3},
              std::vector<double>{1, std::numeric_limits<double>::quiet_NaN(), 1, 1});
  const std::string svg = chart.svg();
  CHECK(well_formed(svg));
  const std::string path = svg.substr(svg.find(" d=\"", svg.find("clip-path=")));
  CHECK(count_of(path.substr(0, path.find("/>")), "M") == 2);
  Chart single{{}};
  single.points("point", {2}, {0});
  CHECK(well_formed(single.svg()));
}

TEST_CASE("chart: references and points are drawn and named, a long history stays small") {
  const ScratchFolder folder("chart");
  std::vector<double> t, y;
  for (int i = 0; i < 100'000; ++i) {
    t.push_back(i);
    y.push_back(std::sin(1e-4 * i));
  }
  Chart chart{{.x = {.label = "t"}, .y = {.label = "y"}}};
  chart.curve("history", t, y);
  chart.points("others", {1e4, 5e4}, {0.5, 0.9});
  chart.reference(0.7, "known");
  chart.write(folder / "chart.svg");
  const std::string svg = content_of(folder / "chart.svg");
  CHECK(well_formed(svg));
  CHECK(svg.find(">known<") != std::string::npos);
  CHECK(svg.find(">others<") != std::string::npos);
  CHECK(svg.size() < 100 * 1024);
}

TEST_CASE("chart: x and y of different length, values off a logarithmic axis, and nothing to draw are errors") {
  Chart chart{{.title = "empty", .y = {.scale = Scale::logarithmic}}};
  CHECK_THROWS_WITH(chart.svg(), "strike: the Chart 'empty' has no curve: add one first.");
  CHECK_THROWS_WITH(chart.curve("a", std::vector<double>{1, 2}, std::vector<double>{1}),
                    "strike: the curve 'a' has 2 x and 1 y: give as many of both.");
  CHECK_THROWS_WITH(
      chart.points("b", {1, 2}, {1, -0.5}),
      "strike: point 1 of the curve 'b' at (2, -0.5) is not on a logarithmic axis: give positive values.");
}
