// Two equal elastic bars meet: a wave runs through each and back, and they part with their velocities exchanged.
#include <algorithm>
#include <cmath>

#include <strike/contact.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/mesh/box.hpp>
#include <strike/mesh/surface.hpp>
#include <strike/mesh/transform.hpp>

#include "policies.hpp"

namespace trade {

namespace {

// Metres, seconds, kilograms. Without Poisson's effect the waves are plane.
constexpr double length = 1, width = 0.01, gap = 1e-6, speed = 10;
constexpr Elastic steel{.density = 7850, .youngs_modulus = 200e9, .poissons_ratio = 0};
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
  const Mesh bar = box({.size = {length, width, width}, .cells = {meshes[setting.mesh], 1, 1}});
  Mesh bars = bar;
  append(bars, translated(bar, {length + gap, 0, 0}));
  const auto end_at = [&](double x) {
    std::vector<Face> faces = surface(bars);
    std::erase_if(faces, [&](const Face& face) { return std::abs(centroid(bars.nodes, face).x() - x) > gap / 4; });
    return Surface{faces};
  };
  const auto approach = [](const Eigen::Vector3d& x) {
    return Eigen::Vector3d(x.x() < length + gap / 2 ? speed / 2 : -speed / 2, 0, 0);
  };
  Explicit run{Scene{bars.nodes, Part{Hex8{}, steel, bars.hexahedra}, InitialVelocityField{approach},
                     ways.contact(end_at(length), end_at(length + gap))},
               setting.options, numbers};

  // Contact lasts while the force is above half of that of plane waves.
  const double c = std::sqrt(steel.youngs_modulus / steel.density), duration = 2 * length / c;
  const double half = 0.5 * steel.density * c * speed / 2 * width * width;
  double begin = 0, last = 0;
  const double seconds = cpu_seconds([&] {
    run.until(1.5 * duration, [&] {
      if (run.template item<2>().force().norm() > half) (begin == 0 ? begin : last) = run.time();
    });
  });
  double momentum = 0, mass = 0;
  for (std::size_t i = 0; i < bar.nodes.size(); ++i)
    momentum += run.nodes().mass(i) * run.nodes().v(i).x(), mass += run.nodes().mass(i);
  return {.error = std::max(std::abs(momentum / mass / (-speed / 2) - 1), std::abs((last - begin) / duration - 1)),
          .seconds = seconds,
          .steps = run.steps(),
          .elements = bars.hexahedra.size()};
};

constexpr auto laws = [](auto& cases) {
  cases.add("Kinematic, two ways", BothWays<Kinematic>{});
  cases.add("Kinematic, one way", OneWay<Kinematic>{});
  for (const double fraction : {0.02, 0.1, 0.2, 0.5, 1.0})
    cases.add(detail::joined({"Penalty, fraction ", detail::text(fraction)}),
              BothWays<Penalty>{{.fraction = fraction}});
  cases.add("Penalty, fraction 0.2, one way", OneWay<Penalty>{{.fraction = 0.2}});
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
