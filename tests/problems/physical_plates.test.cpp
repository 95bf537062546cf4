// Plates whose hourglass modes are controlled by the stresses of their own section: at rest against their references,
// at their plastic moment, spinning, and in a scene that is told and run in several ways.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>

#include <strike/load/prescribed_motion.hpp>
#include <strike/material/solid.hpp>
#include <strike/material/strength/von_mises.hpp>
#include <strike/output/checkpoint.hpp>

#include "output/scratch.hpp"
#include "problems/shells.hpp"
#include "support/catch.hpp"
#include "support/frame.hpp"

using namespace strike;
using testing::difference;
using testing::Frame;
using testing::Points;
using testing::positions;
using namespace strike::shells;

namespace {

const Plate4 element{PhysicalHourglass{}};
const auto section = elastic(1e7, 0.3, 0.1);

/// Deflection of the tip of a cantilever of plates in its plane, over that of a beam; the inner nodes lean.
double cantilever(double length, double height, Index cells, double lean = 0) {
  Mesh beam = rectangle({.size = {length, height}, .cells = {cells, 1}});
  for (auto& x : beam.nodes)
    if (x.x() > 0 && x.x() < length * (1 - 1e-9)) x.x() += lean * (x.y() - height / 2);
  Forces forces;
  for (const Index i : on(beam, Axis::x, length)) forces.forces.emplace_back(i, Eigen::Vector3d(0, 5e-4, 0));
  const Rest rest = settle(beam, element, section, forces, {{Clamped{on(beam, Axis::x, 0)}}},
                           node_at(beam, {length, height, 0}), {0, 1, 0}, 2000000);
  const double E = 1e7, G = E / 2.6, I = 0.1 * height * height * height / 12;
  return rest.displacement / (1e-3 * (length * length * length / (3 * E * I) + length / (5. / 6 * G * 0.1 * height)));
}

const Solid metal{LinearEos{.density = 1, .bulk_modulus = 1000 / 1.2},
                  VonMises{.shear_modulus = 1000 / 2.6, .yield_stress = 1}};

}  // namespace

TEST_CASE("physical hourglass of plates: one layer bends in its plane as a beam, whatever its aspect") {
  for (const double aspect : {1.0, 4.0, 10.0}) CHECK(cantilever(10 * aspect, 1, 10) == Approx(1).margin(0.01));
  CHECK(cantilever(6, 0.2, 6) == Approx(1).margin(0.01));          // of MacNeal and Harder (1985)
  CHECK(cantilever(6, 0.2, 6, 1.0) == Approx(0.63).margin(0.01));  // as the hexahedron does: it passes the patch test
}

TEST_CASE("physical hourglass of plates: a clamped plate of 4 x 4 on a quarter sinks as Kirchhoff's, within 1 %") {
  const Mesh quarter = rectangle({.size = {0.5, 0.5}, .cells = {4, 4}});
  const double h = 0.01, E = 1e4, D = E * h * h * h / (12 * (1 - 0.3 * 0.3)), q = 1e-6 * D;
  const Supports supports{{Symmetry{Axis::x, on(quarter, Axis::x, 0)}, Symmetry{Axis::y, on(quarter, Axis::y, 0)},
                           Clamped{on(quarter, Axis::x, 0.5)}, Clamped{on(quarter, Axis::y, 0.5)}}};
  const Rest rest =
      settle(quarter, element, elastic(E, 0.3, h), spread(quarter, {0, 0, q}), supports, 0, {0, 0, 1}, 2000000);
  CHECK(rest.displacement / 1e-6 == Approx(0.00126532).epsilon(0.01));
}

TEST_CASE("physical hourglass of plates: a twisted beam bends as its reference") {
  CHECK(twisted_beam(2, TipLoad::in_plane, element).displacement == Approx(1).margin(0.02));
  CHECK(twisted_beam(2, TipLoad::across, element).displacement == Approx(1).margin(0.02));
}

TEST_CASE("physical hourglass of plates: a cantilever of one layer has its plastic moment at the foot") {
  const double length = 20, end = 400, speed = 2 / end;
  const Mesh beam = rectangle({.size = {length, 1}, .cells = {20, 1}});
  const auto lower = [&](double at) {
    return nodes_where(beam.nodes, [=](const Eigen::Vector3d& x) { return x.x() == at && x.y() == 0; });
  };
  Explicit run{Scene{beam.nodes, Part{element, Homogeneous{PlaneStress{metal}, 1, Gauss<2>{}}, beam.quadrilaterals},
                     Symmetry{Axis::x, on(beam, Axis::x, 0)}, Support{lower(0), {unit(Axis::y)}},
                     PrescribedVelocity{Axis::y, lower(length), [=](double) { return speed; }}}};
  run.until(0.7 * end);
  const double before = run.energy().external, start = run.time();
  run.until(end);
  const double force = (run.energy().external - before) / (speed * (run.time() - start));
  CHECK(force / (0.25 / length) == Approx(1).margin(0.04));
}

namespace {

/// Bends a sheet in its plane and out of it, stretches and twists it.
struct Struck {
  Frame frame;
  template <class Archive>
  void serialize(Archive&) {}
  template <class N>
  void begin(N& nodes) const {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const Eigen::Vector3d x = frame.back(nodes.x(i));
      const double s = x.x() / 6, y = x.y() - 1;
      nodes.set_velocity(i, frame.turn * Eigen::Vector3d(-1.5 * s * y, 2 * s * s, s * s + s * y));
      nodes.set_angular_velocity(i, frame.turn.determinant() * (frame.turn * Eigen::Vector3d(s, -s / 3, s)));
    }
  }
};
const Mesh sheet_of_six = [] {
  Mesh mesh = rectangle({.size = {6, 2}, .cells = {6, 2}});
  for (auto& x : mesh.nodes) x += Eigen::Vector3d(0.1 * std::sin(5 * x.x()), 0, 0.15 * std::sin(x.x() + 2 * x.y()));
  return mesh;
}();
constexpr double end = 1;

template <class... Policies>
auto struck(const Frame& frame, const Mesh& mesh, const Policies&... policies) {
  Mesh placed = mesh;
  for (auto& x : placed.nodes) x = frame(x);
  const Layer layer{PlaneStress{metal}, 0.1, Gauss<3>{}};
  return Explicit{
      Scene{placed.nodes, Part{element, Layered{layer, layer}, placed.quadrilaterals, Erosion{.strain = 0.12}},
            Struck{frame}},
      ExplicitOptions{}, policies...};
}

}  // namespace

TEST_CASE("physical hourglass of plates: a scene turned, moved, mirrored, flipped or numbered anew, in any numbers") {
  auto plain = struck(Frame{}, sheet_of_six, in<double>);
  plain.until(end);
  CHECK(std::abs(plain.energy().error()) < 5e-3);
  CHECK(plain.energy().hourglass > 2e-3 * plain.energy().initial);
  CHECK(plain.energy().eroded > 0);
  const Points x = positions(plain);
  const auto alike = [&](const Frame& frame, const Mesh& mesh) {
    auto run = struck(frame, mesh, in<double>);
    run.until(end);
    CHECK(difference(positions(run, frame), x) < 1e-9 * 6);
  };
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  alike({turn, {3, -5, 7}}, sheet_of_six);
  alike({Eigen::Vector3d(1, -1, 1).asDiagonal(), {0, 0, 0}}, sheet_of_six);
  Mesh renumbered = sheet_of_six;
  std::ranges::reverse(renumbered.quadrilaterals);
  for (std::size_t c = 0; c < renumbered.quadrilaterals.size(); ++c) {
    auto& q = renumbered.quadrilaterals[c];
    std::rotate(q.begin(), q.begin() + std::ptrdiff_t(c % 4), q.end());
  }
  alike({}, renumbered);
  for (auto& q : renumbered.quadrilaterals) std::swap(q[1], q[3]);
  alike({}, renumbered);

  const ScratchFolder folder("physical_plates");
  auto first = struck(Frame{}, sheet_of_six, in<double>), second = struck(Frame{}, sheet_of_six, in<double>);
  first.until(0.4 * end), write_checkpoint(folder / "first", first);
  read_checkpoint(folder / "first", second), first.until(end), second.until(end);
  CHECK(positions(second) == positions(first));

  auto mixed = struck(Frame{}, sheet_of_six, in<Pack<float>, double>);
  mixed.until(end);
  CHECK(difference(positions(mixed), x) < 1e-3 * 6);
}

namespace {

/// Spins about an axis, and every node is shaken by a share of that.
struct Spinning {
  double w, shaken;
  Eigen::Vector3d axis;
  template <class N>
  void begin(N& nodes) const {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const double a = 1 + static_cast<double>(i);
      const Eigen::Vector3d shake(std::sin(a * a), std::sin(1.7 * a * a), std::sin(2.3 * a * a)),
          turn(std::sin(1.3 * a * a), std::sin(0.7 * a * a), std::sin(2.9 * a * a));
      nodes.set_velocity(i, w * (axis.cross(nodes.x(i)) + shaken * shake));
      nodes.set_angular_velocity(i, w * (axis + shaken * turn));
    }
  }
};

}  // namespace

TEST_CASE("physical hourglass of plates: a sheet that is shaken spins a hundred times and keeps its energy") {
  const double w = 0.02;
  const Mesh sheet = rectangle({.lower = {-1.5, -1.5, 0}, .size = {3, 3}, .cells = {3, 3}});
  Explicit run{
      Scene{sheet.nodes, Part{element, elastic(1, 0.3, 0.2), sheet.quadrilaterals}, Spinning{w, 0.01, {0.6, 0, 0.8}}},
      ExplicitOptions{}};
  run.step();
  const auto total = [&] { return run.energy().kinetic + run.energy().internal + run.energy().hourglass; };
  const double before = total();
  run.until(2 * std::numbers::pi / w * 100);
  CHECK(std::abs(run.energy().error()) < 5e-3);
  CHECK(total() == Approx(before).epsilon(5e-3));
}
