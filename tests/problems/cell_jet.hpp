#pragma once
// Birds and jets of hexahedra and tetrahedra on a rigid wall at z = 0, as particle_jet.hpp has them of particles. mm,
// ms, kg; so kN, GPa and J.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <strike/load/support.hpp>
#include <strike/mesh/measure.hpp>
#include <strike/mesh/select.hpp>
#include <strike/mesh/tetrahedra.hpp>

#include "problems/particle_jet.hpp"

namespace strike::cell_jet {

using particle_jet::Gauge, particle_jet::Jet, particle_jet::stagnation_pressure, particle_jet::water;

/// A quarter of a round jet in hexahedra, `cells` along each edge of a block and as long as wide: a cylinder, or one
/// with hemispherical ends. `across` has no say.
inline Mesh hexahedra(const Jet& jet, Index cells) {
  const double D = jet.width(), L = jet.length();
  BirdShape shape{.mass = jet.mass, .density = water.density, .cells = cells};
  shape.aspect = jet.aspect;
  shape.mass = water.density * std::numbers::pi * D * D * (L / 4 - (jet.has_round_nose ? D / 12 : 0));
  shape.layers = static_cast<Index>(std::lround(4 * cells * (L - (jet.has_round_nose ? D : 0)) / D));
  if (jet.has_round_nose) shape.form = BirdForm::hemispherical_ends;
  return bird(shape);
}

/// The cross-section of the straight part of a quarter, whose chords lie within the circle: its share of the volume
/// over its height.
inline double section(const Jet& jet, const Mesh& quarter) {
  Mesh straight{.nodes = quarter.nodes};
  const double D = jet.width();
  double low = jet.length(), high = 0;
  for (const auto& cell : quarter.hexahedra) {
    double bottom = jet.length(), top = 0;
    for (const Index i : cell)
      bottom = std::min(bottom, quarter.nodes[i].z()), top = std::max(top, quarter.nodes[i].z());
    if (bottom < 0.6 * D || top > jet.length() - 0.6 * D) continue;
    straight.hexahedra.push_back(cell);
    low = std::min(low, bottom), high = std::max(high, top);
  }
  return volume(straight) / (high - low);
}

/// The jet of `hexahedra` in tetrahedra.
inline Mesh tetrahedra(const Jet& jet, Index cells) { return tetrahedralized(hexahedra(jet, cells)); }

/// Elements below a tenth of their volume or a fiftieth of the step of a cell at rest are deleted.
inline Erosion erosion(const Jet& jet, Index cells) {
  return {.volume = 0.1, .step = 0.02 * jet.width() / (4 * cells) / std::sqrt(water.C1 / water.density)};
}

/// `bird` is the part.
template <class Part, class... Policies>
auto on_wall(const Jet& jet, const Mesh& quarter, const Part& bird, const Policies&... policies) {
  const auto on = [&](Axis axis) { return nodes_where(quarter.nodes, on_plane(axis, 0)); };
  return Explicit{Scene{quarter.nodes, bird, InitialVelocity{{0, 0, -jet.speed}}, Symmetry{Axis::x, on(Axis::x)},
                        Symmetry{Axis::y, on(Axis::y)}, RigidWall{{0, 0, 0}, {0, 0, 1}}},
                  policies...};
}

}  // namespace strike::cell_jet
