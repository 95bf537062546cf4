// The explosively loaded panel of Balmer and Witmer (1964).
#include <cmath>

#include "plates.hpp"
#include "problems/explosive_panel.hpp"

namespace trade {

namespace {

constexpr double limit = 1.32, uncertainty = 0.03;  // [in], of fine meshes (docs/verification.md)

template <class Rule>
auto section(const Rule& rule) {
  return explosive_panel::section(rule);
}
auto section(TwoLayers) {
  const Layer half{explosive_panel::aluminium(), explosive_panel::Units{}.thickness() / 2, Gauss<5>{}};
  return Layered{half, half};
}

constexpr auto blow = [](const auto& plate, auto numbers, const Setting& setting) -> Outcome {
  const Mesh panel = explosive_panel::mesh(Index{8} << setting.mesh);
  Explicit run{explosive_panel::scene(panel, section(plate.choice), {}, plate.element), setting.options, numbers};
  explosive_panel::Peaks found;
  const double seconds = cpu_seconds([&] { found = explosive_panel::peaks(run, panel); });
  return {.error = std::abs(found.middle.displacement / limit - 1),
          .seconds = seconds,
          .steps = run.steps(),
          .elements = panel.quadrilaterals.size()};
};

}  // namespace

Problem panel() {
  return problem({.name = "panel",
                  .title = "Explosively loaded panel",
                  .error = "largest displacement of the middle of the crown against 1.32 in, known to 0.03",
                  .uncertainty = uncertainty / limit,
                  .meshes = {"8 x 16", "16 x 32", "32 x 64", "64 x 128"},
                  .elements = "plates"},
                 blow, usual_plate, rules, layers, warpings, thickness_changes, drillings, physical_plate,
                 plate_hourglass_controls, plate_numbers);
}

}  // namespace trade
