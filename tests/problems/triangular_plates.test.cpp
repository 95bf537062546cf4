// Triangular plates against closed forms, at rest and as they swing. The shears along the edges are as many as the
// motions of the nodes, three of each to a node, so thin meshes that are held at their edges are too stiff until they
// are fine: the known stiffness of this element.
#include <cmath>

#include <strike/element/plate3.hpp>
#include <strike/load/prescribed_motion.hpp>
#include <strike/mesh/disc.hpp>

#include "problems/explosive_panel.hpp"
#include "problems/shells.hpp"
#include "problems/supported_plate.hpp"
#include "support/catch.hpp"

using namespace strike;
using namespace strike::shells;

namespace {

const Plate3 element{};

/// A clamped square of unit edge under a uniform pressure, over Kirchhoff's 0.00126532 q L^4/D (Timoshenko), a quarter.
double clamped_square(Index n, double h) {
  const Mesh quarter = triangulated(rectangle({.size = {0.5, 0.5}, .cells = {n, n}}));
  const double E = 1e4, D = E * h * h * h / (12 * (1 - 0.3 * 0.3)), q = 1e-6 * D;
  const Supports supports{{Symmetry{Axis::x, on(quarter, Axis::x, 0)}, Symmetry{Axis::y, on(quarter, Axis::y, 0)},
                           Clamped{on(quarter, Axis::x, 0.5)}, Clamped{on(quarter, Axis::y, 0.5)}}};
  return settle(quarter, element, elastic(E, 0.3, h), spread(quarter, {0, 0, q}), supports, 0, {0, 0, 1}, 2000000)
             .displacement /
         (1e-6 * 0.00126532);
}

/// The tip of a strip of 10 x 1 under a force across, over P L^3/(3 E I) + P L/(5/6 G h b), of nu = 0.
double strip(Index n) {
  const double L = 10, E = 1e4, h = 0.1;
  const Mesh beam = triangulated(rectangle({.size = {L, 1}, .cells = {10 * n, n}}));
  Forces forces;
  const auto tip = on(beam, Axis::x, L);
  for (const Index i : tip) {
    const double y = beam.nodes[i].y(), share = y < 1e-9 || y > 1 - 1e-9 ? 0.5 / n : 1.0 / n;
    forces.forces.emplace_back(i, Eigen::Vector3d(0, 0, 1e-6 * share));
  }
  const Rest rest = settle(beam, element, elastic(E, 0, h), forces, {{Clamped{on(beam, Axis::x, 0)}}},
                           node_at(beam, {L, 0, 0}), {0, 0, 1}, 2000000);
  return rest.displacement / (1e-6 * (4 * L * L * L / (E * h * h * h) + L / (5. / 6 * E / 2 * h)));
}

/// The middle of a clamped disc of radius 1 under a pressure, over q/(64 D) + q/(4 K) (Mindlin).
double clamped_disc(Index n) {
  const double E = 1e4, h = 0.05, D = E * h * h * h / (12 * (1 - 0.3 * 0.3)), K = 5. / 6 * E / 2.6 * h, q = 1e-6 * D;
  const Mesh plate = triangulated(disc({.radius = 1, .cells = n}));
  const auto rim = nodes_where(plate.nodes, on_cylinder({0, 0, 0}, {0, 0, 1}, 1));
  const Rest rest = settle(plate, element, elastic(E, 0.3, h), spread(plate, {0, 0, q}), {{Clamped{rim}}},
                           node_at(plate, {0, 0, 0}), {0, 0, 1}, 2000000);
  return rest.displacement / (q / (64 * D) + q / (4 * K));
}

}  // namespace

TEST_CASE("triangular plates: a cantilever strip bends as a beam") {
  CHECK(strip(1) == Approx(1).margin(0.02));
  CHECK(strip(2) == Approx(1).margin(0.01));
}

TEST_CASE("triangular plates: a clamped square sinks as Kirchhoff's, from the stiff side") {
  const double coarse = clamped_square(8, 0.01), fine = clamped_square(16, 0.01);
  CHECK(fine == Approx(1.002).margin(0.005));  // with its shear, to which quadrilaterals tend
  CHECK(coarse < fine);
  CHECK(1.002 - fine < 0.25 * (1.002 - coarse));  // at least as the square of the mesh
}

TEST_CASE("triangular plates: a clamped disc sinks as Mindlin's") {
  const double coarse = clamped_disc(3), fine = clamped_disc(6);
  CHECK(fine == Approx(1).margin(0.02));
  CHECK(std::abs(fine - 1) < 0.25 * std::abs(coarse - 1));
}

TEST_CASE("triangular plates: a simply supported one swings under a step of pressure as the sum of Mindlin's modes") {
  const supported_plate::Swing fine = supported_plate::swing(16, 1, supported_plate::Edges::hard, element);
  CHECK(fine.largest == Approx(7.2110e-4).epsilon(0.01));
  CHECK(fine.time == Approx(5.138e-4).epsilon(0.01));
}

TEST_CASE("triangular plates: Scordelis and Lo's roof, and a twisted beam") {
  const double coarse = scordelis_lo(8, element).displacement, fine = scordelis_lo(16, element).displacement;
  CHECK(fine == Approx(1).margin(0.05));
  CHECK(std::abs(fine - 1) < 0.5 * std::abs(coarse - 1));
  // Its triangles meet at angles: the stiffness against the drilling that quadrilaterals have is too small.
  const Plate3 loose{ConstantThickness{}, DrillingStiffness{1e-3}};
  CHECK(twisted_beam(4, TipLoad::in_plane, element).displacement == Approx(1).margin(0.02));
  CHECK(twisted_beam(4, TipLoad::in_plane, loose).displacement > 1.05);
}

TEST_CASE("triangular plates: the explosively loaded panel, between those of quadrilaterals and their limit") {
  const Mesh panel = triangulated(explosive_panel::mesh(16));
  Explicit run{explosive_panel::scene(panel, explosive_panel::section(Gauss<5>{}), {}, element)};
  const explosive_panel::Peaks found = explosive_panel::peaks(run, panel);
  CHECK(found.middle.displacement == Approx(1.251).epsilon(0.02));  // quadrilaterals on the same nodes
  CHECK(found.three_quarters.displacement == Approx(0.849).epsilon(0.02));
  CHECK(found.middle.time == Approx(0.38e-3).margin(0.015e-3));
  CHECK(found.balance < 2e-3);
}
