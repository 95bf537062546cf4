// Plates: the explosively loaded panel, shells at rest, and a plate on supports as it swings far.
#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>

#include "problems/explosive_panel.hpp"
#include "problems/shells.hpp"
#include "problems/supported_plate.hpp"
#include "row.hpp"

using namespace strike;

namespace verification {

namespace {

constexpr PlateHourglass hourglass;
/// Belytschko, Lin and Tsay's own element.
constexpr Plate4 plain{hourglass, NoWarping{}, ConstantThickness{}, FreeDrilling{}};
constexpr Plate4 flat{hourglass, NoWarping{}};
constexpr Plate4 drilling_freely{hourglass, BelytschkoWongChiang{}, ConstantThickness{}, FreeDrilling{}};

constexpr auto drilled(double coefficient) {
  return Plate4{hourglass, BelytschkoWongChiang{}, ConstantThickness{}, DrillingStiffness{coefficient}};
}

std::string on_mesh(const std::string& name, Index n, Index m) {
  return name + " " + std::to_string(n) + "x" + std::to_string(m);
}

template <class Rule>
void panel(Index n, const char* rule_name, const Rule& rule, const Band& middle, const Band& three_quarters) {
  const std::string name = on_mesh("panel", n, 2 * n) + " " + rule_name;
  if (!is_wanted(name)) return;
  const Mesh mesh = explosive_panel::mesh(n);
  Explicit run{explosive_panel::scene(mesh, explosive_panel::section(rule))};
  const explosive_panel::Peaks found = explosive_panel::peaks(run, mesh);
  row(name.c_str(), "displacement at 6.28 in", middle, found.middle.displacement, "in");
  row(name.c_str(), "displacement at 9.42 in", three_quarters, found.three_quarters.displacement, "in");
  row(name.c_str(), "time of the first", {0.39, 0.015}, 1e3 * found.middle.time, "ms");
  row(name.c_str(), "error of the balance", {0, 0.2}, 100 * found.balance, "%");
  row(name.c_str(), "hourglass energy", {0, 1}, 100 * found.hourglass, "% of the first");
  std::printf("<!-- %s: %zu steps, at 9.42 in after %.3f ms -->\n", name.c_str(), found.steps,
              1e3 * found.three_quarters.time);
}

/// A shell that `settle()` lets come to rest.
template <class Settle>
void at_rest(const std::string& name, const Band& band, Settle settle) {
  if (!is_wanted(name)) return;
  const shells::Rest rest = settle();
  row(name.c_str(), "displacement", band, rest.displacement, "of the reference");
  std::printf("<!-- %s: %s after %zu steps, hourglass energy %.2g %% -->\n", name.c_str(),
              rest.settled ? "at rest" : "not at rest", rest.steps, 100 * rest.hourglass);
}
constexpr Band met{1, 0.02};
constexpr std::size_t most_steps = 20000000;

void shells_at_rest() {
  for (const Index n : {8u, 16u, 32u}) {
    at_rest(on_mesh("roof", n, n), n < 16 ? unknown : met, [&] { return shells::scordelis_lo(n, Plate4{}); });
    at_rest(on_mesh("cylinder", n, n), n < 32 ? unknown : met, [&] { return shells::pinched_cylinder(n, Plate4{}); });
    at_rest(on_mesh("hemisphere", n, n), n < 16 ? unknown : met,
            [&] { return shells::pinched_hemisphere(n, Plate4{}, most_steps); });
  }
}

void roof_by_drilling() {
  for (const Index n : {8u, 16u, 32u}) {
    at_rest(on_mesh("roof", n, n) + " free drilling", unknown,
            [&] { return shells::scordelis_lo(n, drilling_freely); });
    for (const auto& [text, r] : {std::pair{"1e-5", 1e-5}, {"1e-4", 1e-4}, {"1e-2", 1e-2}})
      at_rest(on_mesh("roof", n, n) + " drilling " + text, unknown,
              [n, r = r] { return shells::scordelis_lo(n, drilled(r)); });
  }
}

template <class Element>
void twisted_beam(const std::string& policies, const Band& fine, const Element& element,
                  const shells::Strip& strip = shells::thick_strip, const char* kind = "") {
  for (const Index n : {2u, 4u, 8u})
    for (const auto load : {shells::TipLoad::in_plane, shells::TipLoad::across})
      at_rest(on_mesh(std::string(kind) + "twisted beam", n, 6 * n) +
                  (load == shells::TipLoad::in_plane ? ", in plane" : ", across") + policies,
              n < 4 ? unknown : fine, [&] { return shells::twisted_beam(n, load, element, strip, most_steps); });
}

template <class Element>
void far_swing(const std::string& policies, const Element& element) {
  for (const Index n : {8u, 16u, 32u})
    for (const auto edges : {supported_plate::Edges::hard, supported_plate::Edges::soft}) {
      const std::string name =
          on_mesh("supported plate", n, n) + (edges == supported_plate::Edges::hard ? ", hard" : ", soft") + policies;
      if (!is_wanted(name)) continue;
      const supported_plate::Swing found = supported_plate::swing(n, 300, edges, element);
      row(name.c_str(), "largest displacement", unknown, found.largest, "in");
    }
}

}  // namespace

void plates() {
  panel(16, "Simpson 3", Simpson<3>{}, {1.319, 0.02 * 1.319}, {0.926, 0.02 * 0.926});
  panel(16, "Simpson 5", Simpson<5>{}, {1.238, 0.02 * 1.238}, {0.839, 0.02 * 0.839});
  panel(16, "Gauss 5", Gauss<5>{}, {1.251, 0.02 * 1.251}, {0.849, 0.02 * 0.849});
  panel(32, "Simpson 3", Simpson<3>{}, {1.382, 0.02 * 1.382}, {0.972, 0.02 * 0.972});
  panel(32, "Simpson 5", Simpson<5>{}, {1.301, 0.02 * 1.301}, {0.890, 0.02 * 0.890});
  panel(32, "Gauss 5", Gauss<5>{}, {1.310, 0.02 * 1.310}, {0.897, 0.02 * 0.897});
  panel(64, "Gauss 5", Gauss<5>{}, {1.32, 0.03}, {0.91, 0.03});
  shells_at_rest();
  roof_by_drilling();
  twisted_beam("", met, Plate4{});
  twisted_beam(", no warping", unknown, flat);
  twisted_beam(", no warping, free drilling", unknown, plain);
  twisted_beam("", unknown, Plate4{}, shells::thin_strip, "thin ");
  far_swing("", Plate4{});
  far_swing(", free drilling, no warping", plain);
}

}  // namespace verification
