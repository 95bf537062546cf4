// A strip twisted by a right angle bends under a force at its end, in its plane there, until it is at rest.
#include <cmath>

#include "plates.hpp"
#include "problems/shells.hpp"

namespace trade {

namespace {

constexpr auto bend = [](const auto& plate, auto, const Setting& setting) -> Outcome {
  const Index n = Index{2} << setting.mesh;
  const std::size_t most_steps = 200000 * n;
  shells::Rest rest;
  const double seconds = cpu_seconds([&] {
    rest = shells::twisted_beam(n, shells::TipLoad::in_plane, plate.element, shells::thick_strip, most_steps);
  });
  if (!rest.settled) throw Error("it does not come to rest");
  return {.error = std::abs(rest.displacement - 1), .seconds = seconds, .steps = rest.steps, .elements = 6 * n * n};
};

}  // namespace

Problem twist() {
  return problem({.name = "twist",
                  .title = "Twisted beam",
                  .error = "deflection at rest against 0.005424 (MacNeal and Harder 1985)",
                  .meshes = {"2 x 12", "4 x 24", "8 x 48"},
                  .elements = "plates"},
                 bend, usual_plate, warpings, drillings, physical_plate, plate_hourglass_controls);
}

}  // namespace trade
