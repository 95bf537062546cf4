// Birds of water without tension on a rigid wall, in hexahedra, tetrahedra and particles: the pressure about the axis.
#include <cmath>
#include <span>

#include <strike/element/tet4.hpp>
#include <strike/material/solid.hpp>
#include <strike/material/strength/von_mises.hpp>

#include "policies.hpp"
#include "problems/cell_jet.hpp"

namespace trade {

namespace {

using particle_jet::Gauge, particle_jet::Jet, particle_jet::water;

/// Elements to the width: of hexahedra four to the edge of a block of the pattern.
constexpr Index across[] = {8, 12, 16, 24};

/// Water with next to no strength, for without any the hexahedra would have no physical hourglass control.
const Solid flesh{water, VonMises{.shear_modulus = 2.07e-3, .yield_stress = 2e-5}};

/// Jets of the same form at several speeds, and the time in which their pressure counts [L/v].
struct Jets {
  Jet form;
  std::span<const double> speeds;
  double from, to;
};
constexpr double bird_speeds[] = {180, 225, 300}, jet_speeds[] = {180};
constexpr Jets cylinders{{.across = 0}, bird_speeds, 0.2, 0.5};
constexpr Jets round_nosed{{.across = 0, .aspect = 4, .has_round_nose = true}, jet_speeds, 0.5, 0.8};

/// The sums over several runs of jets.
struct Sum {
  Outcome outcome{.error = 0, .seconds = 0, .steps = 0, .elements = 0};
  std::size_t jets = 0;

  /// Time without that of the gauge.
  template <class Run>
  void add(Run&& run, const Jet& jet, double from, double to, std::size_t elements) {
    Gauge gauge(jet, from, to);
    double seconds = 0;
    const auto see = [&] { seconds += cpu_seconds([&] { gauge.see(run); }); };
    outcome.seconds += cpu_seconds([&] { run.until((to + 0.01) * jet.length() / jet.speed, see); }) - seconds;
    outcome.error += (gauge.centre() - 1) * (gauge.centre() - 1);
    outcome.steps += run.steps(), outcome.elements = elements;
    ++jets;
  }
  /// With the root of the mean square.
  Outcome mean() const {
    Outcome mean = outcome;
    mean.error = std::sqrt(outcome.error / static_cast<double>(jets));
    return mean;
  }
};

template <class E, class Numbers>
Outcome strike_wall(const Jets& jets, const E& element, Numbers numbers, const Setting& setting) {
  Sum sum;
  for (const double speed : jets.speeds) {
    const Index n = across[setting.mesh], cells = n / 4;
    Jet jet = jets.form;
    jet.across = n, jet.speed = speed;
    const auto add = [&](auto&& run, std::size_t elements) { sum.add(run, jet, jets.from, jets.to, elements); };
    const auto add_cells = [&](const Mesh& mesh, const auto& connectivity) {
      const Part bird{element, flesh, connectivity, cell_jet::erosion(jet, cells)};
      add(cell_jet::on_wall(jet, mesh, bird, setting.options, numbers), connectivity.size());
    };
    if constexpr (E::nodes == 1) {
      const Mesh mesh = jet.mesh();
      add(particle_jet::on_wall(jet, mesh, setting.options, numbers), mesh.particles.cells.size());
    } else if constexpr (E::nodes == 4) {
      const Mesh mesh = cell_jet::tetrahedra(jet, cells);
      add_cells(mesh, mesh.tetrahedra);
    } else {
      const Mesh mesh = cell_jet::hexahedra(jet, cells);
      add_cells(mesh, mesh.hexahedra);
    }
  }
  return sum.mean();
}

constexpr auto strike_with = [](const Jets& jets) {
  return [&jets](const auto& element, auto numbers, const Setting& setting) {
    return strike_wall(jets, element, numbers, setting);
  };
};

constexpr auto kinds = [](auto& cases) {
  cases.add("Hex8", Hex8{});
  cases.add("Hex8, viscous hourglass 0.1", Hex8{ViscousHourglass{}});
  cases.add("Tet4, half of it the nodes'", Tet4{NodalPressure{0.5}});
  cases.add("Particle", Particle{});
  cases.add("Particle, mixed", Particle{}, in<Pack<float>, double>);
};

const std::string counts = "tetrahedra; of hexahedra a sixth, of particles up to a seventh more than of hexahedra";

}  // namespace

std::vector<Problem> soft_birds() {
  return {
      problem({.name = "bird_pressure",
               .title = "Pressure of a bird",
               .error = "mean pressure about the axis from 0.2 to 0.5 L/v against the stagnation pressure, root mean "
                        "square over 180, 225 and 300 m/s, in the time of all three",
               .uncertainty = 0.015,
               .meshes = {"8 across", "12 across", "16 across", "24 across"},
               .elements = counts},
              strike_with(cylinders), kinds),
      problem({.name = "jet_pressure",
               .title = "Pressure of a steady jet",
               .error = "mean pressure about the axis from 2 to 3.2 diameters after the impact, at 180 m/s, against "
                        "the stagnation pressure",
               .uncertainty = 0.015,
               .meshes = {"8 across", "12 across", "16 across"},
               .elements = counts},
              strike_with(round_nosed), kinds)};
}

}  // namespace trade
