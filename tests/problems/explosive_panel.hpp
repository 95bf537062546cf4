#pragma once
// The explosively loaded panel of Balmer and Witmer (1964) as X3D computed it: half of a third of a cylinder, its
// straight sides clamped, its curved ends hinged, with an inward velocity on the middle of its crown.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <strike/dynamics/explicit.hpp>
#include <strike/element/plate4.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/load/support.hpp>
#include <strike/material/eos/linear.hpp>
#include <strike/material/plane_stress.hpp>
#include <strike/material/solid.hpp>
#include <strike/material/strength/von_mises.hpp>
#include <strike/mesh/select.hpp>
#include <strike/mesh/sheet.hpp>
#include <strike/section/layered.hpp>

#include "problems/plate_cells.hpp"

namespace strike::explosive_panel {

/// Data of the panel in consistent units; those of the references are inches, seconds and pounds of force.
struct Units {
  double length = 1, time = 1, stress = 1;  ///< of one inch, one second, one psi

  double radius() const { return 2.9375 * length; }
  double span() const { return 12.56 * length; }
  double thickness() const { return 0.125 * length; }
  double speed() const { return 5650 * length / time; }
  double end() const { return 1e-3 * time; }
  double density() const { return 2.49943e-4 * stress * time * time / (length * length); }
  double youngs_modulus() const { return 1.05e7 * stress; }
  double yield_stress() const { return 44000 * stress; }
};

inline double angle_of(const Eigen::Vector3d& x) { return std::atan2(x.x(), x.z()); }

/// The sheet of explosive lies on 60 degrees of the arc and 26/32 of the span; nodes on its edge get half.
struct Blast {
  Units units;

  Eigen::Vector3d operator()(const Eigen::Vector3d& x) const {
    const auto share = [](double distance, double edge) {
      return std::abs(distance - edge) < 1e-6 * edge ? 0.5 : distance < edge ? 1.0 : 0.0;
    };
    const double angle = angle_of(x), half = units.span() / 2;
    const double v =
        units.speed() * share(angle, std::numbers::pi / 6) * share(std::abs(x.y() - half), 26.0 / 32 * half);
    return {-v * std::sin(angle), 0, -v * std::cos(angle)};
  }
};

/// n elements along the half arc and 2 n along the span.
inline Mesh mesh(Index n, const Units& units = {}) {
  return panel(
      {.radius = units.radius(), .length = units.span(), .arc = {0, std::numbers::pi / 3}, .cells = {n, 2 * n}});
}

/// Elastic and perfectly plastic.
inline auto aluminium(const Units& units = {}) {
  const double E = units.youngs_modulus(), nu = 0.33;
  return PlaneStress{Solid{LinearEos{.density = units.density(), .bulk_modulus = E / (3 * (1 - 2 * nu))},
                           VonMises{.shear_modulus = E / (2 * (1 + nu)), .yield_stress = units.yield_stress()}}};
}
template <class Rule>
auto section(const Rule& rule, const Units& units = {}) {
  return Homogeneous{aluminium(units), units.thickness(), rule};
}

template <class Section, class Element = Plate4<>>
auto scene(const Mesh& panel, const Section& section, const Units& units = {}, const Element& element = {}) {
  const auto on = [&](Axis axis, double at) { return nodes_where(panel.nodes, on_plane(axis, at)); };
  const auto side =
      nodes_where(panel.nodes, [](const Eigen::Vector3d& x) { return angle_of(x) > std::numbers::pi / 3 - 1e-6; });
  return Scene{panel.nodes,
               Part{element, section, testing::plate_cells<Element>(panel)},
               InitialVelocityField{Blast{units}},
               Symmetry{Axis::x, on(Axis::x, 0)},
               Clamped{side},
               Pinned{on(Axis::y, 0)},
               Pinned{on(Axis::y, units.span())}};
}

/// How far a point of the crown goes in, and when.
struct Peak {
  double displacement = 0, time = 0;
};
struct Peaks {
  Peak middle, three_quarters;
  double balance = 0, hourglass = 0;
  std::size_t steps = 0;
};

template <class Run>
Peaks peaks(Run& run, const Mesh& panel, const Units& units = {}) {
  Peaks found;
  const auto watch = [&](Peak& peak, double y) {
    Index node = 0;
    const Eigen::Vector3d x(0, y, units.radius());
    for (Index i = 0; i < panel.nodes.size(); ++i)
      if ((panel.nodes[i] - x).norm() < (panel.nodes[node] - x).norm()) node = i;
    return [&peak, &run, &panel, node] {
      if (const double u = panel.nodes[node].z() - run.nodes().x(node).z(); u > peak.displacement)
        peak = {u, run.time()};
    };
  };
  const double initial = run.energy().kinetic;
  run.until(units.end(), watch(found.middle, units.span() / 2), watch(found.three_quarters, 0.75 * units.span()),
            [&] { found.balance = std::max(found.balance, std::abs(run.energy().error())); });
  found.hourglass = run.energy().hourglass / initial;
  found.steps = run.steps();
  return found;
}

}  // namespace strike::explosive_panel
