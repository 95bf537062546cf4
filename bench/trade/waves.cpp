// A column of steel in uniaxial strain strikes a wall at 50 m/s: an elastic precursor and a plastic wave behind it.
#include <algorithm>
#include <cmath>

#include <strike/load/initial_velocity.hpp>
#include <strike/load/support.hpp>
#include <strike/material/eos/linear.hpp>
#include <strike/material/solid.hpp>
#include <strike/material/strength/von_mises.hpp>
#include <strike/mesh/box.hpp>
#include <strike/mesh/select.hpp>

#include "policies.hpp"

namespace trade {

namespace {

// Metres, seconds, kilograms.
constexpr double K = 200e9 / 1.2, G = 200e9 / 2.6, Y = 400e6, density = 7850, speed = 50, length = 0.1;

/// Axial stress in compression at the relative volume J: p = K (1/J - 1), and a deviator of 2 G (-ln J) up to yield.
double stress_at(double J) { return K * (1 / J - 1) + 2.0 / 3 * std::min(-2 * G * std::log(J), Y); }

/// What a shock leaves behind it.
struct Shock {
  double J = 1, stress = 0, v = 0, speed = 0;  // speed per reference length

  /// The shock to J that follows this one: mass and momentum are kept across it.
  Shock to(double J_behind) const {
    const double s = stress_at(J_behind), dv = std::sqrt((s - stress) * (J - J_behind) / density);
    return {J_behind, s, v + dv, dv / (J - J_behind)};
  }
};

/// The two shocks of the impact, both exact: the elastic limit, then what brings the material to rest.
struct Exact {
  Shock elastic = Shock{}.to(std::exp(-Y / (2 * G))), plastic;

  Exact() {
    double strong = 0.5, weak = elastic.J;
    for (int i = 0; i < 100; ++i) {
      plastic = elastic.to(0.5 * (strong + weak));
      (plastic.v > speed ? strong : weak) = plastic.J;
    }
  }
  double stress(double X, double t) const {
    return X < plastic.speed * t ? plastic.stress : X < elastic.speed * t ? elastic.stress : 0;
  }
};

constexpr auto strike_wall = [](const auto& element, auto numbers, const Setting& setting) -> Outcome {
  const Exact exact;
  const double end = 0.8 * length / exact.elastic.speed;
  const Index n = Index{50} << setting.mesh;
  const double width = 4 * length / n;
  const Mesh column = box({.size = {length, width, width}, .cells = {n, 4, 4}});
  const std::vector<Index> all = all_nodes(column.nodes);
  const Solid steel{LinearEos{.density = density, .bulk_modulus = K}, VonMises{.shear_modulus = G, .yield_stress = Y}};
  Explicit run{Scene{column.nodes,                            //
                     Part{element, steel, column.hexahedra},  //
                     InitialVelocity{{-speed, 0, 0}},         //
                     Symmetry{Axis::y, all},                  //
                     Symmetry{Axis::z, all},                  //
                     Symmetry{Axis::x, nodes_where(column.nodes, on_plane(Axis::x, 0))}},
               setting.options, numbers};
  const double seconds = cpu_seconds([&] { run.until(end); });

  const auto& part = run.template part<0>();
  const std::vector<double> stress = part.field([](const auto& state) { return -state.stress.xx; });
  double deviation = 0, whole = 0;
  for (std::size_t e = 0; e < stress.size(); ++e) {
    const double expected = exact.stress(centroid<8>(column.nodes, column.hexahedra[e]).x(), end);
    deviation += std::abs(stress[e] - expected), whole += expected;
  }
  return {.error = deviation / whole, .seconds = seconds, .steps = run.steps(), .elements = column.hexahedra.size()};
};

}  // namespace

Problem waves() {
  return problem({.name = "waves",
                  .title = "Elastic-plastic waves",
                  .error = "profile of the axial stress against the exact two shocks, mean of the absolute difference",
                  .meshes = {"50 cells", "100 cells", "200 cells", "400 cells"}},
                 strike_wall, usual, elements, numbers, step_factors, bulk_viscosities);
}

}  // namespace trade
