// Flat plates that bend in their plane and out of it, until they are at rest.
#include <cmath>

#include "plates.hpp"
#include "problems/shells.hpp"

namespace trade {

namespace {

constexpr std::size_t most_steps = 2000000;

template <class Run>
Outcome at_rest(std::size_t elements, Run run) {
  shells::Rest rest;
  const double seconds = cpu_seconds([&] { rest = run(); });
  if (!rest.settled) throw Error("it does not come to rest");
  return {.error = std::abs(rest.displacement - 1), .seconds = seconds, .steps = rest.steps, .elements = elements};
}

/// The slender beam of MacNeal and Harder in its plane.
constexpr auto strip = [](const auto& plate, auto, const Setting& setting) -> Outcome {
  const Index n = Index{1} << setting.mesh;
  const double length = 6, height = 0.2, small = 1e-3;
  const Mesh beam = rectangle({.size = {length, height}, .cells = {6 * n, n}});
  shells::Forces forces;
  for (const auto& cell : beam.quadrilaterals)  // the edge 1-2 of the last elements
    for (const Index i : {cell[1], cell[2]})
      if (beam.nodes[cell[1]].x() > length * (1 - 1e-9))
        forces.forces.emplace_back(i, Eigen::Vector3d(0, 0.5 * small / n, 0));
  return at_rest(beam.quadrilaterals.size(), [&] {
    shells::Rest rest = shells::settle(beam, plate.element, shells::elastic(1e7, 0.3, 0.1), forces,
                                       {{Clamped{shells::on(beam, Axis::x, 0)}}},
                                       shells::node_at(beam, {length, height, 0}), {0, 1, 0}, most_steps);
    rest.displacement /= 0.1081 * small;
    return rest;
  });
};

/// A clamped square under a pressure, a quarter of it, of a hundredth of its edge in thickness.
constexpr auto slab = [](const auto& plate, auto, const Setting& setting) -> Outcome {
  const Index n = Index{2} << setting.mesh;
  const Mesh quarter = rectangle({.size = {0.5, 0.5}, .cells = {n, n}});
  const double h = 0.01, E = 1e4, D = E * h * h * h / (12 * (1 - 0.3 * 0.3)), small = 1e-6;
  const shells::Supports supports{
      {Symmetry{Axis::x, shells::on(quarter, Axis::x, 0)}, Symmetry{Axis::y, shells::on(quarter, Axis::y, 0)},
       Clamped{shells::on(quarter, Axis::x, 0.5)}, Clamped{shells::on(quarter, Axis::y, 0.5)}}};
  return at_rest(quarter.quadrilaterals.size(), [&] {
    shells::Rest rest = shells::settle(quarter, plate.element, shells::elastic(E, 0.3, h),
                                       shells::spread(quarter, {0, 0, small * D}), supports, 0, {0, 0, 1}, most_steps);
    rest.displacement /= 0.00126532 * small;
    return rest;
  });
};

}  // namespace

std::vector<Problem> plates_at_rest() {
  return {problem({.name = "strip",
                   .title = "Slender beam of plates in their plane",
                   .error = "deflection of the tip against 0.1081 (MacNeal and Harder 1985)",
                   .meshes = {"6 x 1", "12 x 2", "24 x 4"},
                   .elements = "plates"},
                  strip, usual_plate, physical_plate, plate_hourglass_controls),
          problem({.name = "slab",
                   .title = "Clamped plate of plates",
                   .error = "deflection against Kirchhoff's 0.00126532 q a^4/D",
                   .meshes = {"2 x 2", "4 x 4", "8 x 8"},
                   .elements = "plates"},
                  slab, usual_plate, physical_plate, plate_hourglass_controls)};
}

}  // namespace trade
