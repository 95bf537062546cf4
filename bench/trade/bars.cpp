// Two equal elastic bars meet: a wave runs through each and back, and they part with their velocities exchanged.
#include <algorithm>
#include <cmath>

#include <strike/contact.hpp>
#include <strike/load/initial_velocity.hpp>

#include "policies.hpp"
#include "support/two_bars.hpp"

namespace trade {

namespace {

using Bars = examples::TwoBars;
constexpr Index meshes[] = {50, 100, 200, 400};

/// One bar's end on the other's, or each on each.
template <class Law>
struct OneWay {
  Law law{};
  auto contact(const Surface& first, const Surface& second) const {
    return Contact{NodeToSurface{first.nodes(), second}, law};
  }
};
template <class Law>
struct BothWays {
  Law law{};
  auto contact(const Surface& first, const Surface& second) const { return Contact{TwoWay{first, second}, law}; }
};

constexpr auto meet = [](const auto& ways, auto numbers, const Setting& setting) -> Outcome {
  const Bars bars(meshes[setting.mesh], 1e-6);
  Explicit run{Scene{bars.mesh.nodes, Part{Hex8{}, Bars::steel, bars.mesh.hexahedra},
                     InitialVelocityField{bars.approach()}, ways.contact(bars.left_end(), bars.right_end())},
               setting.options, numbers};

  // Contact lasts while the force is above half of that of plane waves.
  const double half = Bars::stress / 2 * Bars::width * Bars::width;
  double begin = 0, last = 0;
  const double seconds = cpu_seconds([&] {
    run.until(1.5 * Bars::duration, [&] {
      if (run.template item<2>().force().norm() > half) (begin == 0 ? begin : last) = run.time();
    });
  });
  return {.error = std::max(std::abs(bars.left_velocity(run) / (-Bars::speed / 2) - 1),
                            std::abs((last - begin) / Bars::duration - 1)),
          .seconds = seconds,
          .steps = run.steps(),
          .elements = bars.mesh.hexahedra.size()};
};

constexpr auto laws = [](auto& cases) {
  cases.add("Kinematic, two ways", BothWays<Kinematic>{});
  cases.add("Kinematic, one way", OneWay<Kinematic>{});
  for (const double fraction : {0.02, 0.1, 0.2, 0.5, 1.0})
    cases.add(detail::joined({"Penalty ", detail::text(fraction)}), BothWays<Penalty>{{.fraction = fraction}});
  cases.add("Penalty 0.2, one way", OneWay<Penalty>{{.fraction = 0.2}});
};

}  // namespace

Problem bars() {
  return problem({.name = "bars",
                  .title = "Two equal bars",
                  .error = "velocities after the contact against those exchanged, or its duration against 2 L/c, "
                           "whichever is further off",
                  .meshes = {"50", "100", "200", "400"}},
                 meet, laws);
}

}  // namespace trade
