#pragma once
// Taylor's bar of wedges: a quarter in rings about its axis, of which the innermost are wedges; or of wedges alone.
#include <cmath>
#include <numbers>
#include <vector>

#include <strike/mesh/mesh.hpp>
#include <strike/mesh/transform.hpp>

namespace strike::taylor {

/// A quarter of a round bar in `rings` rings of `sectors` sectors about the axis.
inline Mesh bar_of_rings(double radius, double length, Index rings, Index sectors, Index layers) {
  Mesh plan{.nodes = {{0, 0, 0}}};
  for (Index ring = 1; ring <= rings; ++ring)
    for (Index k = 0; k <= sectors; ++k) {
      const double r = radius * ring / rings, angle = std::numbers::pi / 2 * k / sectors;
      plan.nodes.emplace_back(k == sectors ? 0 : r * std::cos(angle), k == 0 ? 0 : r * std::sin(angle), 0);
    }
  const auto node = [&](Index ring, Index k) { return ring == 0 ? 0 : 1 + (ring - 1) * (sectors + 1) + k; };
  for (Index ring = 0; ring < rings; ++ring)
    for (Index k = 0; k < sectors; ++k) {
      const Index a = node(ring, k), b = node(ring + 1, k), c = node(ring + 1, k + 1), d = node(ring, k + 1);
      plan.quadrilaterals.push_back(ring == 0 ? std::array{a, b, c, c} : std::array{a, b, c, d});
    }
  std::vector<double> levels;
  for (Index layer = 0; layer <= layers; ++layer) levels.push_back(length * layer / layers);
  return extruded(plan, levels);
}

}  // namespace strike::taylor
