// A bar whose hexahedra control their hourglass modes by the stresses of its own material bends, twists, yields,
// strikes a wall and loses elements; the answer must not depend on how the scene is told or run.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include <strike/contact/rigid_wall.hpp>
#include <strike/dynamics.hpp>
#include <strike/element.hpp>
#include <strike/load.hpp>
#include <strike/material.hpp>
#include <strike/mesh.hpp>
#include <strike/motion/openmp.hpp>
#include <strike/output/checkpoint.hpp>

#include "output/scratch.hpp"
#include "support/catch.hpp"
#include "support/frame.hpp"

using namespace strike;
using testing::difference;
using testing::Frame;
using testing::Points;
using testing::positions;

namespace {

/// 12 mm x 4 mm x 2 mm of copper, one layer of it thick.
const Mesh bar = box({.size = {12, 4, 2}, .cells = {6, 2, 1}});
const Solid copper{LinearEos{.density = 8.93e-6, .bulk_modulus = 130}, JohnsonCook{.shear_modulus = 43.3,
                                                                                   .A = 0.09,
                                                                                   .B = 0.292,
                                                                                   .n = 0.31,
                                                                                   .C = 0.025,
                                                                                   .reference_rate = 1e-3,
                                                                                   .m = 1.09,
                                                                                   .melting_temperature = 1356,
                                                                                   .heating = 263}};
constexpr double end = 0.02;

/// A motion with bending, twist and stretch.
struct Struck {
  Frame frame;
  template <class Archive>
  void serialize(Archive&) {}
  template <class N>
  void begin(N& nodes) const {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const Eigen::Vector3d x = frame.back(nodes.x(i));
      const double s = x.x() / 12, y = x.y() - 2, z = x.z() - 1;
      nodes.set_velocity(i, frame.turn * Eigen::Vector3d(-20 * s * z, -60 * s * z, 150 * s * s - 60 + 60 * s * y));
    }
  }
};

template <class... Policies>
auto struck(const Frame& frame, const Mesh& mesh, const Erosion& erosion, const Policies&... policies) {
  Mesh placed = mesh;
  for (auto& x : placed.nodes) x = frame(x);
  return Explicit{Scene{placed.nodes, Part{Hex8{PhysicalHourglass{}}, copper, placed.hexahedra, erosion}, Struck{frame},
                        RigidWall{frame({0, 0, -0.2}), frame.turn * Eigen::Vector3d::UnitZ()}},
                  ExplicitOptions{}, policies...};
}
template <class... Policies>
auto struck(const Policies&... policies) {
  return struck(Frame{}, bar, Erosion{.strain = 0.05}, policies...);
}

}  // namespace

TEST_CASE("physical hourglass: threads and interruptions change no bit of a bar that bends and loses elements") {
  const ScratchFolder folder("physical_hourglass");
  auto serial = struck();
  serial.until(end);
  CHECK(std::abs(serial.energy().error()) < 5e-3);
  CHECK(serial.energy().eroded > 0);
  CHECK(serial.energy().hourglass > 0.01 * serial.energy().initial);
  write_checkpoint(folder / "serial", serial);
  for (const int threads : {2, 3}) {
    auto parallel = struck(OpenMP{.threads = threads});
    parallel.until(end);
    CHECK(positions(parallel) == positions(serial));
  }
  for (const std::size_t at : {std::size_t{1}, serial.steps() / 2}) {
    auto first = struck();
    first.until(end, StopWhen{[&] { return first.steps() == at; }});
    write_checkpoint(folder / "first", first);
    auto second = struck();
    read_checkpoint(folder / "first", second);
    second.until(end);
    CHECK(positions(second) == positions(serial));
  }
}

TEST_CASE("physical hourglass: a scene that is turned, moved, mirrored or numbered anew gives the same bar") {
  const Erosion none{};
  auto plain = struck(Frame{}, bar, none, in<double>);
  plain.until(end);
  const Points x = positions(plain);
  const auto alike = [&](const Frame& frame, const Mesh& mesh) {
    auto run = struck(frame, mesh, none, in<double>);
    run.until(end);
    CHECK(difference(positions(run, frame), x) < 1e-9 * 12);
  };
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  alike({turn, {3, -5, 7}}, bar);
  alike({Eigen::Matrix3d::Identity(), {0, 0, 1e-12}}, bar);
  Mesh renumbered = bar;  // each cell by another rotation of its corners, and the cells backwards
  std::ranges::reverse(renumbered.hexahedra);
  for (std::size_t c = 0; c < renumbered.hexahedra.size(); ++c) {
    auto& h = renumbered.hexahedra[c];
    const auto old = h;
    constexpr int quarter[8] = {1, 2, 3, 0, 5, 6, 7, 4}, tip[8] = {0, 4, 5, 1, 3, 7, 6, 2};
    for (std::size_t k = 0; k < 8; ++k) h[k] = old[std::size_t(c % 2 ? quarter[k] : tip[k])];
  }
  alike({}, renumbered);
}

TEST_CASE("physical hourglass: a half of a bar on its plane of symmetry is that half of the whole") {
  const Solid metal{LinearEos{.density = 8.93e-6, .bulk_modulus = 130},
                    VonMises{.shear_modulus = 43.3, .yield_stress = 0.1, .hardening_modulus = 0.1}};
  const auto run_of = [&](Index cells, auto... conditions) {
    const Mesh mesh = box({.lower = {0, -2, 0}, .size = {12, 2.0 * cells, 2}, .cells = {6, cells, 1}});
    const auto foot = nodes_where(mesh.nodes, on_plane(Axis::x, 0)),
               tip = nodes_where(mesh.nodes, on_plane(Axis::x, 12));
    Explicit run{Scene{mesh.nodes, Part{Hex8{PhysicalHourglass{}}, metal, mesh.hexahedra}, Clamped{foot},
                       InitialVelocity{{0, 0, 100}, tip}, conditions(mesh)...},
                 ExplicitOptions{}, in<double>};
    run.until(end);
    return std::pair(mesh, positions(run));
  };
  const auto [whole, x] = run_of(2);
  const auto [half, y] = run_of(1, [](const Mesh& mesh) {
    return Symmetry{Axis::y, nodes_where(mesh.nodes, on_plane(Axis::y, 0))};
  });
  for (std::size_t i = 0; i < half.nodes.size(); ++i)
    for (std::size_t j = 0; j < whole.nodes.size(); ++j)
      if ((half.nodes[i] - whole.nodes[j]).norm() < 1e-9) CHECK((x[j] - y[i]).norm() < 1e-9 * 12);
}

TEST_CASE("physical hourglass: other numbers and steps give the bar to their accuracy, and keep the balance") {
  const Erosion none{};
  auto usual = struck(Frame{}, bar, none);
  usual.until(end);
  const Points x = positions(usual);
  const double moved = difference(x, bar.nodes);
  const auto near = [&](double share, const auto&... policies) {
    auto run = struck(Frame{}, bar, none, policies...);
    run.until(end);
    CHECK(difference(positions(run), x) < share * moved);
    CHECK(std::abs(run.energy().error()) < 5e-3);
  };
  near(1e-4, in<Pack<float>>), near(1e-4, in<Pack<float>, double>), near(1e-9, in<double>);
  near(0.01, Subcycling{}), near(0.01, GlobalStep{});
}
