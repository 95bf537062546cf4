#pragma once
// Shells under loads that stand still, by dynamic relaxation, each a fraction of its reference: REFERENCES of the field
// (MacNeal and Harder 1985; Belytschko, Stolarski, Liu, Carpenter and Ong 1985). `n` elements along a side of the mesh.
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include <strike/dynamics/explicit.hpp>
#include <strike/element/plate4.hpp>
#include <strike/load/support.hpp>
#include <strike/material/elastic.hpp>
#include <strike/material/plane_stress.hpp>
#include <strike/mesh/measure.hpp>
#include <strike/mesh/select.hpp>
#include <strike/mesh/sheet.hpp>
#include <strike/section/layered.hpp>

#include "problems/plate_cells.hpp"

namespace strike::shells {

/// A plate of one elastic material, of the density 1.
inline auto elastic(double E, double nu, double h) {
  return Homogeneous{PlaneStress{Elastic{.density = 1, .youngs_modulus = E, .poissons_ratio = nu}}, h};
}

/// Forces on nodes that do not change.
struct Forces {
  std::vector<std::pair<Index, Eigen::Vector3d>> forces;

  template <class N>
  void apply_loads(N& nodes, double) const {
    for (const auto& [i, f] : forces) nodes.add_force(i, f);
  }
  template <class N>
  double power(const N& nodes) const {
    double sum = 0;
    for (const auto& [i, f] : forces) sum += f.dot(nodes.v(i));
    return sum;
  }
};

/// As many supports as there are.
struct Supports {
  std::vector<Support> supports;

  template <class N>
  void begin(N& nodes) {
    for (Support& support : supports) support.begin(nodes);
  }
  template <class N, class Ledger>
  void constrain(N& nodes, const Step& step, Ledger& ledger) const {
    for (const Support& support : supports) support.constrain(nodes, step, ledger);
  }
};

using testing::for_element, testing::plate_cells;

/// The force per area f, lumped: a quarter of that on an element to each of its corners, of a triangle a third.
inline Forces spread(const Mesh& mesh, const Eigen::Vector3d& f) {
  Forces load;
  for (const auto& cell : mesh.quadrilaterals)
    for (const Index i : cell) load.forces.emplace_back(i, 0.25 * quadrilateral_area(mesh.nodes, cell) * f);
  for (const auto& cell : mesh.triangles)
    for (const Index i : cell) load.forces.emplace_back(i, triangle_area(mesh.nodes, cell) / 3 * f);
  return load;
}

struct Rest {
  double displacement;  ///< of the node asked for, along the direction asked for
  double hourglass;     ///< energy over the internal one
  std::size_t steps;
  double balance;
  bool settled;  ///< or given up
};

/// Lets the mesh come to rest, or gives up after as many steps.
template <class Element, class Section>
Rest settle(const Mesh& mesh, const Element& element, const Section& section, Forces load, Supports supports,
            Index node, const Eigen::Vector3d& direction, std::size_t most_steps = 200000) {
  Explicit run{
      Scene{mesh.nodes, Part{element, section, plate_cells<Element>(mesh)}, std::move(load), std::move(supports)},
      {},
      DynamicRelaxation{}};
  struct Patience {
    std::size_t most_steps, steps = 0;
    bool stops() const { return steps > most_steps; }
    void operator()() { ++steps; }  // before the first step too
  };
  run.until(at_rest, Patience{most_steps});
  const Energy& e = run.energy();
  return {(run.nodes().x(node) - mesh.nodes[node]).dot(direction), e.hourglass / e.internal, run.steps(), e.error(),
          run.steps() < most_steps};
}

inline std::vector<Index> on(const Mesh& mesh, Axis axis, double at) {
  return nodes_where(mesh.nodes, on_plane(axis, at));
}
inline Index node_at(const Mesh& mesh, const Eigen::Vector3d& x) {
  Index nearest = 0;
  for (Index i = 0; i < mesh.nodes.size(); ++i)
    if ((mesh.nodes[i] - x).norm() < (mesh.nodes[nearest] - x).norm()) nearest = i;
  return nearest;
}
inline Support diaphragm(std::vector<Index> nodes) { return {std::move(nodes), {unit(Axis::x), unit(Axis::z)}}; }

/// A roof of two straight free edges on diaphragms under its weight (Scordelis and Lo 1964), a quarter of it: the
/// middle of the free edge sinks by 0.3024.
template <class Element>
Rest scordelis_lo(Index n, const Element& element) {
  constexpr double R = 25, half = 25, angle = 40 * std::numbers::pi / 180, small = 1e-3;
  const Mesh roof = for_element<Element>(panel({.radius = R, .length = half, .arc = {0, angle}, .cells = {n, n}}));
  Rest rest = settle(roof, element, elastic(4.32e8, 0, 0.25), spread(roof, {0, 0, -90 * small}),
                     {{diaphragm(on(roof, Axis::y, 0)), Symmetry{Axis::y, on(roof, Axis::y, half)},
                       Symmetry{Axis::x, on(roof, Axis::x, 0)}}},
                     node_at(roof, {R * std::sin(angle), half, R * std::cos(angle)}), {0, 0, -1});
  rest.displacement /= 0.3024 * small;
  return rest;
}

/// A cylinder on diaphragms, pinched by two forces of 1, an eighth of it: under them 1.8248e-5.
template <class Element>
Rest pinched_cylinder(Index n, const Element& element) {
  constexpr double R = 300, half = 300;
  const Mesh cylinder =
      for_element<Element>(panel({.radius = R, .length = half, .arc = {0, std::numbers::pi / 2}, .cells = {n, n}}));
  const Index top = node_at(cylinder, {0, half, R});
  Rest rest = settle(cylinder, element, elastic(3e6, 0.3, 3), {{{top, {0, 0, -0.25}}}},
                     {{diaphragm(on(cylinder, Axis::y, 0)), Symmetry{Axis::y, on(cylinder, Axis::y, half)},
                       Symmetry{Axis::x, on(cylinder, Axis::x, 0)}, Symmetry{Axis::z, on(cylinder, Axis::z, 0)}}},
                     top, {0, 0, -1});
  rest.displacement /= 1.8248e-5;
  return rest;
}

/// A hemisphere with a hole of 18 degrees, pulled and pushed at its edge by forces of 2, a quarter of it: 0.0940 under
/// them.
template <class Element>
Rest pinched_hemisphere(Index n, const Element& element, std::size_t most_steps = 200000) {
  constexpr double R = 10, right = std::numbers::pi / 2, small = 1e-3;
  const Mesh dome = for_element<Element>(sheet({n, n}, [&](double s, double t) {
    const double a = s * right, b = t * 0.8 * right;
    return Eigen::Vector3d(R * std::cos(b) * std::cos(a), R * std::cos(b) * std::sin(a), R * std::sin(b));
  }));
  const Index pulled = 0, pushed = n;
  Rest rest = settle(dome, element, elastic(6.825e7, 0.3, 0.04), {{{pulled, {small, 0, 0}}, {pushed, {0, -small, 0}}}},
                     {{Symmetry{Axis::x, on(dome, Axis::x, 0)}, Symmetry{Axis::y, on(dome, Axis::y, 0)},
                       Support{{pulled}, {unit(Axis::z)}}}},
                     pulled, {1, 0, 0}, most_steps);
  rest.displacement /= 0.0940 * small;
  return rest;
}

/// A strip twisted by a right angle, clamped at one end, loaded at the other in its plane there or across it: n
/// elements over the width, 6 n along.
enum class TipLoad { in_plane, across };
struct Strip {
  double thickness, force;
  double in_plane, across;  ///< references
};
inline constexpr Strip thick_strip{0.32, 1, 0.005424, 0.001754}, thin_strip{0.0032, 1e-6, 0.005256, 0.001294};
template <class Element>
Rest twisted_beam(Index n, TipLoad load, const Element& element, const Strip& strip = thick_strip,
                  std::size_t most_steps = 200000) {
  constexpr double length = 12, width = 1.1;
  const Mesh whole = sheet({6 * n, n}, [&](double s, double t) {
    const double angle = s * std::numbers::pi / 2, y = (t - 0.5) * width;
    return Eigen::Vector3d(s * length, y * std::cos(angle), y * std::sin(angle));
  });
  const Eigen::Vector3d direction = load == TipLoad::in_plane ? unit(Axis::z) : unit(Axis::y);
  Forces forces;
  for (const auto& cell : whole.quadrilaterals)  // the edge 1-2 of the last elements
    for (const Index i : {cell[1], cell[2]})
      if (whole.nodes[cell[1]].x() > length * (1 - 1e-9))
        forces.forces.emplace_back(i, 0.5 * strip.force / n * direction);
  const Mesh beam = for_element<Element>(whole);
  Rest rest = settle(beam, element, elastic(29e6, 0.22, strip.thickness), forces, {{Clamped{on(beam, Axis::x, 0)}}},
                     node_at(beam, {length, 0, 0}), direction, most_steps);
  rest.displacement /= load == TipLoad::in_plane ? strip.in_plane : strip.across;
  return rest;
}

}  // namespace strike::shells
