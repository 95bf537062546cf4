// A laminated pane, glass on a soft interlayer on glass, swings between two supports in cylindrical bending.
#include <cmath>
#include <numbers>

#include <strike/load/support.hpp>
#include <strike/mesh/select.hpp>
#include <strike/mesh/sheet.hpp>
#include <strike/scalar/flush_denormals.hpp>

#include "plates.hpp"
#include "support/lay_ups.hpp"

namespace trade {

namespace {

const testing::Sandwich& pane_of = testing::glass;
constexpr double softness = 1e4, speed = 100;  // E of glass over that of the interlayer; [mm/s]

/// Begins in the undeformed shape with the velocities of Mindlin's half wave, K gamma = D p^2 psi.
struct Swing {
  double p, turn;  // psi over w

  template <class N>
  void begin(N& nodes) const {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const double x = nodes.x(i).x();
      nodes.set_velocity(i, {0, 0, speed * std::sin(p * x)});
      nodes.set_angular_velocity(i, {0, -turn * speed * std::cos(p * x), 0});
    }
  }
};

constexpr auto swing = [](const auto& plate, auto numbers, const Setting& setting) -> Outcome {
  const Index n = Index{4} << setting.mesh;
  const double half = pane_of.length / 2, p = pane_of.p();
  const auto section = pane_of.section(softness, plate.choice);
  const double K = section.shear_stiffness(), D = section.transverse_shear().bending;
  const Mesh pane = rectangle({.size = {half, half}, .cells = {n, n}});
  const auto at = [&](double x) { return nodes_where(pane.nodes, on_plane(Axis::x, x)); };
  Explicit run{Scene{pane.nodes,                                         //
                     Part{plate.element, section, pane.quadrilaterals},  //
                     Swing{p, p * K / (K + D * p * p)},                  //
                     Support{at(0), {unit(Axis::z)}},                    //
                     Symmetry{Axis::x, at(half)},                        //
                     Symmetry{Axis::y, all_nodes(pane.nodes)}},
               setting.options, numbers};

  const FlushDenormals flushed;  // nothing moves along y
  const double exact = pane_of.laminate(softness).angular_frequency(p);
  double before = 0, frequency = 0;  // of the first return through the undeformed shape
  const double seconds = cpu_seconds([&] {
    run.until(2 * std::numbers::pi / exact, [&, time_before = 0.0]() mutable {
      const double w = run.nodes().x(n).z();
      if (frequency == 0 && before > 0 && w <= 0)
        frequency = std::numbers::pi / (time_before + (run.time() - time_before) * before / (before - w));
      before = w, time_before = run.time();
    });
  });
  return {.error = std::abs(frequency / exact - 1),
          .seconds = seconds,
          .steps = run.steps(),
          .elements = pane.quadrilaterals.size()};
};

constexpr auto usual_pane = [](auto& cases) { cases.add("usual: EnergyShear", Plate{Plate4{}, EnergyShear{}}); };
constexpr auto shears = [](auto& cases) {
  cases.add("EffectiveShear", Plate{Plate4{}, EffectiveShear{.length = pane_of.length}});
  cases.add("FiveSixthsShear", Plate{Plate4{}, FiveSixthsShear{}});
  cases.add("InstantaneousShear", Plate{Plate4{}, InstantaneousShear{}});
};
constexpr auto effective_numbers = [](auto& cases) {
  const Plate plate{Plate4{}, EffectiveShear{.length = pane_of.length}};
  cases.add("EffectiveShear, float", plate, in<Pack<float>>);
  cases.add("EffectiveShear, mixed", plate, in<Pack<float>, double>);
  cases.add("EffectiveShear, double, one lane", plate, in<double>);
};

}  // namespace

Problem pane() {
  return problem({.name = "pane",
                  .title = "Laminated pane that swings",
                  .error = "lowest frequency against three-dimensional elasticity",
                  .meshes = {"span 8", "span 16", "span 32", "span 64"},
                  .elements = "plates"},
                 swing, usual_pane, shears, effective_numbers);
}

}  // namespace trade
