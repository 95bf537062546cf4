// What each feature adds to the step of the whole driver: the usual scene and one that differs in one thing take turns,
// so that both meet the same moods of the machine. A new feature is a line in a file beside this one.
//
//   OMP_PROC_BIND=true build/bench/bench/prices          all, some four minutes; the threads on cores of their own
//   build/bench/bench/prices only=threads rounds=3       features or groups whose names contain a word, less to rely on
//
// Written into out/prices: prices.md and what the features of output write.
#include <cstdio>
#include <string>
#include <vector>

#include <strike/output/file.hpp>
#include <strike/text.hpp>

#include "../support/clock.hpp"
#include "../support/table.hpp"
#include "feature.hpp"
#include "support/options.hpp"

namespace {

using namespace prices;
using namespace bench;

struct Price {
  double bytes;
  double ratio;   ///< to the time of the usual, median
  double spread;  ///< half the range of the middle half of the ratios
};

/// In each round a feature and the usual begin anew, for where its memory lies makes a run quicker or slower, and take
/// turns of some steps. Turns of the usual are added to `usual_seconds` [s per step].
Price price(const Feature& feature, const Feature& usual, std::size_t rounds, std::vector<double>& usual_seconds) {
  std::vector<double> ratios;
  double bytes = 0;
  for (std::size_t round = 0; round < rounds; ++round) {
    const Trial with = feature.start(), without = usual.start();
    const auto turn = [&](const Trial& trial) {
      const auto steps = [&] {
        for (int i = 0; i < feature.steps; ++i) trial.step();
      };
      return (feature.timed_by == TimedBy::wall ? wall_seconds(steps) : cpu_seconds(steps)) / feature.steps;
    };
    for (int i = 0; i < 8; ++i) with.step(), without.step();  // until they yield
    const double first = turn(without), theirs = turn(with) + turn(with), last = turn(without);
    ratios.push_back(theirs / (first + last));
    usual_seconds.insert(usual_seconds.end(), {first, last});
    bytes = with.bytes;
  }
  return {bytes, median(ratios), 0.5 * (quantile(ratios, 0.75) - quantile(ratios, 0.25))};
}

constexpr const char* introduction = R"(# What does each feature cost?

    cmake --workflow --preset bench && OMP_PROC_BIND=true build/bench/bench/prices out=docs/prices.md

Each row differs from the usual in one feature. Both begin anew several times and take turns of some steps. Given are the
median of the ratios of their times, half the range of the middle half of these ratios, and what that is in time where
the usual takes its own median. Bytes are those that an element stores, with the numbers of its nodes.
)";

/// Groups that differ from the same usual, of so many elements.
struct Chapter {
  std::string introduction;
  Feature usual;
  std::size_t elements;
  std::vector<Group> groups;
};

std::vector<Chapter> all() {
  return {{R"(
## Hexahedra

The usual is a bar of 100 000 `Hex8{ViscousHourglass{}}` (one point, the rotation of Hughes and Winget at mid-step, bulk
viscosity; `Hex8{}` has its own row) of copper with `LinearEos` and `VonMises` with linear hardening, in `Pack<double>`, on one core,
squeezed so that every element yields.
)",
           hexahedra.itself("the usual"),
           hexahedra.cells.size(),
           {{"The usual", {hexahedra.itself("the usual against itself")}},
            strengths(),
            failures(),
            equations_of_state(),
            elements(),
            numbers(),
            conditions(),
            outputs(),
            ledger()}},
          {R"(
## Tetrahedra

The usual is the same bar of 101 400 `Tet4{}`, a blend of their own pressure and that of their nodes.
)",
           tetrahedra.itself("the usual"),
           tetrahedra.cells.size(),
           {{"The usual tetrahedron", {tetrahedra.itself("the usual tetrahedron against itself")}},
            tetrahedron_elements()}},
          {R"(
## Particles

The usual is a brick of 24 000 `Particle{}` of water with `CubicEos`, squeezed; the lists of their neighbours are made
anew as they move, and are not among the bytes.
)",
           cloud.itself("the usual particle"),
           cloud.cells.size(),
           {{"The usual particle", {cloud.itself("the usual particle against itself")}}, particle_choices()}},
          {R"(
## Plates

The usual is a sheet of 100 000 `Plate4{}` (hourglass control, the warping of Belytschko, Wong and Chiang, constant
thickness, drilling stiffness) of one layer with Simpson's five points, of the same copper in plane stress, in
`Pack<double>`, on one core, stretched and bent so that every point yields.
)",
           plates.itself("the usual"),
           plates.cells.size(),
           {{"The usual plate", {plates.itself("the usual plate against itself")}},
            plate_sections(),
            plate_shears(),
            plate_materials(),
            plate_laminates(),
            plate_elements(),
            plate_numbers()}},
          {R"(
## Triangles

The usual is such a sheet of 100 000 `Plate3{}`.
)",
           triangles.itself("the usual triangle"),
           triangles.cells.size(),
           {{"The usual triangle", {triangles.itself("the usual triangle against itself")}}, triangle_choices()}}};
}

/// What is left of all if the titles of groups or the names of features must have a word in them.
std::vector<Chapter> chosen(const std::string& word) {
  const auto lacks = [&](const std::string& name) { return name.find(word) == std::string::npos; };
  std::vector<Chapter> chapters = all();
  for (Chapter& chapter : chapters) {
    for (Group& group : chapter.groups)
      if (lacks(group.title)) std::erase_if(group.features, [&](const Feature& f) { return lacks(f.name); });
    std::erase_if(chapter.groups, [](const Group& group) { return group.features.empty(); });
  }
  std::erase_if(chapters, [](const Chapter& chapter) { return chapter.groups.empty(); });
  if (chapters.empty()) throw Error(strike::detail::joined({"No group or feature has '", word, "' in its name."}));
  return chapters;
}

/// A group where the usual takes so many nanoseconds.
std::string markdown(const Group& group, const std::vector<Price>& prices, double ns) {
  std::string text = head({group.title, "bytes", "ns per element and step", "more", "ratio", "+-"});
  for (std::size_t i = 0; i < prices.size(); ++i) {
    const auto& [bytes, ratio, spread] = prices[i];
    text += row({group.features[i].name, formatted("%.0f", bytes), formatted("%.1f", ratio * ns),
                 formatted("%+.1f", (ratio - 1) * ns), formatted("%.3f", ratio), formatted("%.3f", spread)});
  }
  return text;
}

}  // namespace

int main(int count, char** arguments) {
  return examples::run(count, arguments, [](examples::Options& options) {
    const std::string path = options.text("out", "out/prices/prices.md"), word = options.text("only", "");
    const std::size_t rounds = options.count("rounds", 7);
    options.check();

    std::string text = introduction;
    for (const Chapter& chapter : chosen(word)) {
      std::vector<std::vector<Price>> prices;
      std::vector<double> usual_seconds;
      for (const Group& group : chapter.groups) {
        prices.emplace_back();
        for (const Feature& feature : group.features) {
          const Price& p = prices.back().emplace_back(price(feature, chapter.usual, rounds, usual_seconds));
          std::printf("%-64s %5.0f B  %.3f +- %.3f\n", feature.name.c_str(), p.bytes, p.ratio, p.spread);
          std::fflush(stdout);
        }
      }
      const double ns = 1e9 * median(usual_seconds) / static_cast<double>(chapter.elements);
      text += chapter.introduction;
      for (std::size_t i = 0; i < prices.size(); ++i) text += "\n" + markdown(chapter.groups[i], prices[i], ns);
      std::printf("The usual: %.1f ns per element and step.\n\n", ns);
    }
    strike::detail::replace_file(path, text);
    std::printf("Written: %s\n", path.c_str());
  });
}
