// Hexahedra that bend, until they are at rest: a tapered membrane, a slender beam, a thin plate and a shell of one
// layer; and a beam with a plastic hinge.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <strike/dynamics/dynamic_relaxation.hpp>
#include <strike/load/prescribed_motion.hpp>
#include <strike/load/support.hpp>
#include <strike/material/elastic.hpp>
#include <strike/material/solid.hpp>
#include <strike/material/strength/von_mises.hpp>
#include <strike/mesh/box.hpp>
#include <strike/mesh/select.hpp>

#include "policies.hpp"
#include "problems/shells.hpp"

namespace trade {

namespace {

constexpr double tiny = 1e-9;

/// A scene at rest: a mesh, its conditions and loads, and the deflection of one node over the reference.
struct Statics {
  Mesh mesh;
  Elastic law;
  shells::Supports supports = {};
  shells::Forces forces = {};

  template <class Where>
  void hold(Axis axis, const Where& where) {
    supports.supports.push_back({nodes_where(mesh.nodes, where), {unit(axis)}});
  }

  template <class E, class Numbers>
  Outcome outcome(const E& element, Numbers numbers, const Setting& setting, Index node, Axis axis,
                  double reference) const {
    Explicit run{Scene{mesh.nodes, Part{element, law, mesh.hexahedra}, forces, supports}, setting.options, numbers,
                 DynamicRelaxation{.tolerance = 1e-3}};
    const double seconds = cpu_seconds([&] { run.until(at_rest); });
    const double deflection = (run.positions()[node] - mesh.nodes[node]).dot(unit(axis));
    return {.error = std::abs(deflection / reference - 1),
            .seconds = seconds,
            .steps = run.steps(),
            .elements = mesh.hexahedra.size()};
  }
};

/// Cook's membrane (1974) in plane stress, 44 to 16 high, 48 long: nu = 1/3, shear force 1 on its end.
constexpr auto membrane = [](const auto& element, auto numbers, const Setting& setting) -> Outcome {
  const Index n = Index{4} << setting.mesh;
  Statics cook{box({.size = {1, 1, 1}, .cells = {n, n, 1}}), Elastic{1, 1, 1.0 / 3}};
  for (auto& x : cook.mesh.nodes) x = {48 * x.x(), 44 * x.x() + (44 - 28 * x.x()) * x.y(), x.z()};
  cook.hold(Axis::x, on_plane(Axis::x, 0)), cook.hold(Axis::y, on_plane(Axis::x, 0)),
      cook.hold(Axis::z, on_plane(Axis::z, 0));
  for (const Index i : nodes_where(cook.mesh.nodes, on_plane(Axis::x, 48))) {
    const double y = cook.mesh.nodes[i].y(), share = y < 44 + tiny || y > 60 - tiny ? 0.5 : 1;
    cook.forces.forces.emplace_back(i, Eigen::Vector3d(0, 1e-3 * 0.5 * share / static_cast<double>(n), 0));
  }
  return cook.outcome(element, numbers, setting, shells::node_at(cook.mesh, {48, 60, 0}), Axis::y, 1e-3 * 23.96);
};

/// MacNeal and Harder's slender beam, bent in its plane; the inner edges lean by 45 degrees, alike or to and fro.
enum class Edges { upright, leaning, zigzag };
template <Edges edges>
constexpr auto slender = [](const auto& element, auto numbers, const Setting& setting) -> Outcome {
  const Index n = Index{6} << setting.mesh;
  const double step = 6.0 / static_cast<double>(n), tilt = 0.1;
  Statics beam{box({.size = {6, 0.2, 0.1}, .cells = {n, Index{1} << setting.mesh, 1}}), Elastic{1, 1e7, 0.3}};
  for (auto& x : beam.mesh.nodes)
    if (edges != Edges::upright && x.x() > tiny && x.x() < 6 - tiny) {
      const double sign = edges == Edges::zigzag && std::lround(x.x() / step) % 2 == 0 ? -1 : 1;
      x.x() += sign * tilt * (10 * x.y() - 1) / static_cast<double>(Index{1} << setting.mesh);
    }
  for (const Axis axis : {Axis::x, Axis::y, Axis::z}) beam.hold(axis, on_plane(Axis::x, 0));
  const auto tip = nodes_where(beam.mesh.nodes, on_plane(Axis::x, 6));
  for (const Index i : tip)
    beam.forces.forces.emplace_back(i, Eigen::Vector3d(0, 1e-3 / static_cast<double>(tip.size()), 0));
  return beam.outcome(element, numbers, setting, tip.front(), Axis::y, 1e-3 * 0.1081);
};

/// A quarter of a clamped square plate of one layer under a pressure, a hundred times as wide as thick.
constexpr auto plate = [](const auto& element, auto numbers, const Setting& setting) -> Outcome {
  const Index n = Index{4} << setting.mesh;
  const double t = 0.01, q = 1e-9, D = t * t * t / 12 / (1 - 0.09);
  Statics quarter{box({.size = {0.5, 0.5, t}, .cells = {n, n, 1}}), Elastic{1, 1, 0.3}};
  const auto clamped = [](const Eigen::Vector3d& x) { return std::max(x.x(), x.y()) > 0.5 - tiny; };
  for (const Axis axis : {Axis::x, Axis::y, Axis::z})
    quarter.hold(axis,
                 [&](const Eigen::Vector3d& x) { return clamped(x) || (axis != Axis::z && x.dot(unit(axis)) < tiny); });
  for (Index i = 0; i < quarter.mesh.nodes.size(); ++i) {
    const Eigen::Vector3d& x = quarter.mesh.nodes[i];
    const double share = (x.x() < tiny ? 0.5 : 1) * (x.y() < tiny ? 0.5 : 1) / static_cast<double>(8 * n * n);
    if (!clamped(x)) quarter.forces.forces.emplace_back(i, Eigen::Vector3d(0, 0, q * share));
  }
  return quarter.outcome(element, numbers, setting, shells::node_at(quarter.mesh, {0, 0, 0}), Axis::z,
                         0.00126532 * q / D);
};

/// An octant of the pinched cylinder with diaphragms, one layer of hexahedra.
constexpr auto pinched = [](const auto& element, auto numbers, const Setting& setting) -> Outcome {
  const Index n = Index{8} << setting.mesh;
  const double R = 300, half = 300, t = 3;
  Statics octant{box({.lower = {0, 0, -0.5}, .size = {1, 1, 1}, .cells = {n, n, 1}}), Elastic{1, 3e6, 0.3}};
  for (auto& x : octant.mesh.nodes) {
    const double angle = x.x() * std::numbers::pi / 2, r = R + t * x.z();
    x = {r * std::sin(angle), half * x.y(), r * std::cos(angle)};
  }
  const auto diaphragm = [=](const Eigen::Vector3d& x) { return x.y() > half - 1e-6; };
  octant.hold(Axis::x, [&](const Eigen::Vector3d& x) { return diaphragm(x) || x.x() < 1e-6; });
  octant.hold(Axis::y, on_plane(Axis::y, 0));
  octant.hold(Axis::z, [&](const Eigen::Vector3d& x) { return diaphragm(x) || x.z() < 1e-6; });
  for (const double r : {R - t / 2, R + t / 2})
    octant.forces.forces.emplace_back(shells::node_at(octant.mesh, {0, 0, r}), Eigen::Vector3d(0, 0, -0.125));
  return octant.outcome(element, numbers, setting, shells::node_at(octant.mesh, {0, 0, R - t / 2}), Axis::z,
                        -1.8248e-5);
};

/// A cantilever in plane strain, perfectly plastic, whose tip is pushed on: the force against that of a hinge.
constexpr auto hinge = [](const auto& element, auto numbers, const Setting& setting) -> Outcome {
  const Index n = Index{1} << setting.mesh;
  const double length = 20, end = 400, speed = 2 / end, E = 1000, nu = 0.3;
  const Mesh mesh = box({.lower = {0, 0, -0.5}, .size = {length, 1, 1}, .cells = {20 * n, 1, n}});
  const auto lower = [&](double at) {
    return nodes_where(mesh.nodes, [=](const Eigen::Vector3d& x) { return x.x() == at && x.z() == -0.5; });
  };
  const Solid metal{LinearEos{.density = 1, .bulk_modulus = E / (3 * (1 - 2 * nu))},
                    VonMises{.shear_modulus = E / (2 * (1 + nu)), .yield_stress = 1}};
  Explicit run{Scene{mesh.nodes, Part{element, metal, mesh.hexahedra},
                     Symmetry{Axis::x, nodes_where(mesh.nodes, on_plane(Axis::x, 0))}, Symmetry{Axis::z, lower(0)},
                     Symmetry{Axis::y, nodes_where(mesh.nodes, [](const Eigen::Vector3d&) { return true; })},
                     PrescribedVelocity{Axis::z, lower(length), [=](double) { return speed; }}},
               setting.options, numbers};
  double force = 0;
  const double seconds = cpu_seconds([&] {
    run.until(0.7 * end);
    const double before = run.energy().external, start = run.time();
    run.until(end);
    force = (run.energy().external - before) / (speed * (run.time() - start));
  });
  return {.error = std::abs(force / (0.5 / std::numbers::sqrt3 / length) - 1),
          .seconds = seconds,
          .steps = run.steps(),
          .elements = mesh.hexahedra.size()};
};

/// The viscous control flows under loads that stay.
constexpr auto at_rest_elements = [](auto& cases) {
  cases.add("usual", Hex8{});
  cases.add("mixed", Hex8{}, in<Pack<float>, double>);
  cases.add("stiffness hourglass 0.005", Hex8{StiffnessHourglass{.coefficient = 0.005}});
  cases.add("stiffness hourglass 0.05", Hex8{StiffnessHourglass{.coefficient = 0.05}});
  cases.add("8 points", Hex8Full{});
};

constexpr auto viscous = [](auto& cases) { cases.add("viscous hourglass 0.1", Hex8{ViscousHourglass{}}); };

template <Edges edges>
Problem slender_beam(const char* name, const char* title) {
  return problem({.name = name,
                  .title = title,
                  .error = "deflection of the tip against 0.1081 (MacNeal and Harder 1985)",
                  .meshes = {"6 x 1", "12 x 2", "24 x 4"}},
                 slender<edges>, at_rest_elements);
}

}  // namespace

std::vector<Problem> bending() {
  return {problem({.name = "membrane",
                   .title = "Cook's membrane",
                   .error = "deflection of the upper corner against 23.96 (Cook 1974)",
                   .meshes = {"4 x 4", "8 x 8", "16 x 16"}},
                  membrane, at_rest_elements),
          slender_beam<Edges::upright>("bricks", "Slender beam of bricks"),
          slender_beam<Edges::leaning>("parallelograms", "Slender beam of parallelograms"),
          slender_beam<Edges::zigzag>("trapezoids", "Slender beam of trapezoids"),
          problem({.name = "plate",
                   .title = "Clamped plate of one layer",
                   .error = "deflection against Kirchhoff's 0.00126532 q a^4/D",
                   .meshes = {"4 x 4", "8 x 8", "16 x 16"}},
                  plate, at_rest_elements),
          problem({.name = "cylinder",
                   .title = "Pinched cylinder of one layer",
                   .error = "deflection under the force against 1.8248e-5 (MacNeal and Harder 1985)",
                   .meshes = {"8 x 8", "16 x 16", "32 x 32"}},
                  pinched, at_rest_elements),
          problem({.name = "hinge",
                   .title = "Plastic hinge of a cantilever",
                   .error = "force against that of the plastic moment at the foot",
                   .meshes = {"20 x 1", "40 x 2", "80 x 4"}},
                  hinge, at_rest_elements, viscous)};
}

}  // namespace trade
