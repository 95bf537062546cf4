#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include <strike/dynamics/explicit.hpp>
#include <strike/dynamics/global_step.hpp>
#include <strike/dynamics/stop_when.hpp>
#include <strike/element/hex8.hpp>
#include <strike/element/hex8_full.hpp>
#include <strike/element/mass_scaled.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/load/support.hpp>
#include <strike/material/eos/linear.hpp>
#include <strike/material/solid.hpp>
#include <strike/material/strength/von_mises.hpp>
#include <strike/mesh/box.hpp>
#include <strike/mesh/check.hpp>
#include <strike/mesh/measure.hpp>
#include <strike/motion/openmp.hpp>
#include <strike/output/checkpoint.hpp>

#include "dynamics/assembled.hpp"
#include "output/scratch.hpp"
#include "support/catch.hpp"
#include "support/cut_hexahedra.hpp"
#include "support/sanitized.hpp"

using namespace strike;
using Catch::Matchers::ContainsSubstring;

namespace {

const Elastic elastic{.density = 2, .youngs_modulus = 1, .poissons_ratio = 0.3};
const Solid metal{LinearEos{.density = 1, .bulk_modulus = 1},
                  VonMises{.shear_modulus = 0.4, .yield_stress = 0.02, .hardening_modulus = 0.01}};

/// A block of hexahedra, wedges and pyramids whose inner nodes were moved at random before some were cut.
Mesh distorted(const std::array<Index, 3>& cells, double distortion) {
  Mesh mesh = box({.size = {1.5, 1, 1}, .cells = cells});
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (auto& x : mesh.nodes) {
    const bool inside = x.x() > 0 && x.x() < 1.5 && x.y() > 0 && x.y() < 1 && x.z() > 0 && x.z() < 1;
    const Eigen::Vector3d shift(unit(random), unit(random), unit(random));
    if (inside) x += distortion * shift / cells[2];
  }
  return testing::cut_by_thirds(mesh);
}

/// Velocities L x.
struct Linear {
  Eigen::Matrix3d L;
  template <class N>
  void begin(N& nodes) const {
    for (std::size_t i = 0; i < nodes.size(); ++i) nodes.set_velocity(i, L * nodes.x(i).template cast<double>());
  }
};
struct Random {
  double speed;
  template <class N>
  void begin(N& nodes) const {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> unit(-speed, speed);
    for (std::size_t i = 0; i < nodes.size(); ++i) nodes.set_velocity(i, {unit(random), unit(random), unit(random)});
  }
};

/// The faster, the farther along x.
struct Tear {
  template <class N>
  void begin(N& nodes) const {
    for (std::size_t i = 0; i < nodes.size(); ++i)
      nodes.set_velocity(i, {0.6 * std::clamp(nodes.x(i).x() / 12, 0.0, 1.0), 0, 0});
  }
  template <class Archive>
  void serialize(Archive&) {}
};

template <class E, class... Policies>
auto vibrating(const E& element, const Mesh& mesh, double speed, const Policies&... policies) {
  return Explicit{Scene{mesh.nodes, Part{element, elastic, mesh.hexahedra}, Random{speed}},
                  ExplicitOptions{.step_factor = 1}, in<double>, policies...};
}

}  // namespace

TEST_CASE("wedges and pyramids in a run: nodes have their shares of the mass, a sixth, a quarter and 3/16") {
  Mesh mesh{.nodes = {{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, 0, 3}, {2, 0, 3}, {0, 1, 3}},
            // turned, so that the run numbers it anew
            .hexahedra = {detail::in_order(wedge_cell<Index>({0, 1, 2, 3, 4, 5}), {3, 2, 6, 7, 0, 1, 5, 4})}};
  const Explicit wedge{Scene{mesh.nodes, Part{Hex8{}, elastic, mesh.hexahedra}}};
  for (std::size_t i = 0; i < 6; ++i) CHECK(wedge.nodes().mass(i) == Approx(2 * 3 / 6.).epsilon(1e-14));
  mesh = {.nodes = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}, {1, 1, 3}},
          .hexahedra = {pyramid_cell<Index>({0, 1, 2, 3, 4})}};
  const Explicit pyramid{Scene{mesh.nodes, Part{Hex8{}, elastic, mesh.hexahedra}}};
  for (std::size_t i = 0; i < 5; ++i)
    CHECK(pyramid.nodes().mass(i) == Approx(2 * 2 * (i == 4 ? 0.25 : 3. / 16)).epsilon(1e-14));
  CHECK_THROWS_WITH(Explicit(Scene{mesh.nodes, Part{Hex8Full{}, elastic, mesh.hexahedra}}),
                    "strike: element 0 of part 0 at (1, 0.6, 0.6) is a pyramid, which its element does not take; use "
                    "Hex8, or split it by tetrahedralized(mesh).");
}

TEST_CASE("wedges and pyramids in a run: the patch test, beside hexahedra, in any shape") {
  const Mesh mesh = distorted({6, 3, 3}, 0.25);
  check(mesh);
  Eigen::Matrix3d L;
  L << 0.6, 0.3, -0.2, 0.1, 0.4, 0.5, -0.3, 0.2, 0.7;
  Explicit run{Scene{mesh.nodes, Part{Hex8{}, elastic, mesh.hexahedra}, Linear{1e-3 * L}},
               ExplicitOptions{.largest_step = 1e-3}, in<Pack<double>>};
  run.step();
  const auto before = run.velocities();
  const auto stress = run.part<0>().field([](const auto& s) { return s.stress; });
  for (const auto& s : stress) CHECK((s.matrix() - stress[0].matrix()).norm() <= 1e-9 * stress[0].matrix().norm());
  run.step();  // by the forces of the first
  double inside = 0, outside = 0;
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    const auto& x = mesh.nodes[i];
    const bool inner =
        x.x() > 1e-9 && x.x() < 1.5 - 1e-9 && x.y() > 1e-9 && x.y() < 1 - 1e-9 && x.z() > 1e-9 && x.z() < 1 - 1e-9;
    const double kick = run.nodes().mass(i) * (run.velocities()[i] - before[i]).norm();
    (inner ? inside : outside) = std::max(inner ? inside : outside, kick);
  }
  CHECK(outside > 0);
  CHECK(inside <= 1e-9 * outside);  // velocities of 1e-3 change by 1e-6 of them: rounding 1e-16 of 1e-6
  double mass = 0;
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) mass += run.nodes().mass(i);
  CHECK(mass == Approx(2 * volume(mesh)).epsilon(1e-13));
}

TEST_CASE(
    "wedges and pyramids in a run: the step is below the exact limit of the mesh, and near it by the estimate of the "
    "whole") {
  for (const Mesh& mesh :
       {testing::cut_into_wedges(box({.size = {1, 1, 1}, .cells = {2, 2, 2}})),
        testing::cut_into_pyramids(box({.size = {1, 1, 1}, .cells = {2, 1, 1}})), distorted({3, 2, 2}, 0.3)}) {
    auto run = vibrating(Hex8{}, mesh, 1e-3);
    const auto look = [&] { return testing::eigenvalue(testing::vibration(run), run.stable_step().dt); };
    CHECK(look() <= 1);
    for (int i = 0; i < 30; ++i) run.step();
    CHECK(look() <= 1);
    auto global = vibrating(Hex8{}, mesh, 1e-3, GlobalStep{});
    const double eigenvalue = testing::eigenvalue(testing::vibration(global), global.stable_step().dt);
    CHECK(eigenvalue <= 1);
    CHECK(eigenvalue >= 0.6);
    CHECK(global.stable_step().dt >= run.stable_step().dt);
  }
  const Mesh mesh = distorted({3, 2, 2}, 0.3);
  const double dt = vibrating(Hex8{}, mesh, 0).stable_step().dt;
  auto scaled = vibrating(MassScaled{Hex8{}, 1.2 * dt}, mesh, 0);
  CHECK(scaled.stable_step().dt >= 1.2 * dt * (1 - 1e-12));
  CHECK(testing::eigenvalue(testing::vibration(scaled), scaled.stable_step().dt) <= 1);
}

TEST_CASE("wedges and pyramids in a run: at the full step, vibrations at random keep their energy") {
  const Mesh mesh = distorted({6, 3, 3}, 0.3);
  Explicit run{Scene{mesh.nodes, Part{Hex8{}, elastic, mesh.hexahedra}, Random{1e-6}},
               ExplicitOptions{.step_factor = 1, .energy_tolerance = 1e-2}, in<Pack<double>>};
  while (run.steps() < static_cast<std::size_t>(testing::repeated(3000))) run.step();
  const double kinetic = run.energy().kinetic;
  CHECK(kinetic < run.energy().initial);
  CHECK(std::abs(run.energy().error()) < 1e-2);
}

TEST_CASE("wedges and pyramids torn by erosion: the same for threads and after a checkpoint, and the balance holds") {
  const Mesh bar = testing::cut_by_thirds(box({.size = {12, 2, 2}, .cells = {12, 2, 2}}));
  const auto make = [&](int threads) {
    return Explicit{Scene{bar.nodes, Part{Hex8{}, metal, bar.hexahedra, Erosion{.strain = 0.3}}, Tear{},
                          Symmetry{Axis::x, nodes_where(bar.nodes, on_plane(Axis::x, 0))}},
                    ExplicitOptions{.step_factor = 0.5}, in<Pack<double>>, OpenMP{.threads = threads}};
  };
  const ScratchFolder folder("degenerate");
  const auto bytes = [&](auto& run) {
    write_checkpoint(folder / "state", run);
    return content_of(folder / "state");
  };
  constexpr double end = 12;
  auto whole = make(1), threads = make(2), first = make(1), second = make(1);
  whole.until(end), threads.until(end);
  CHECK(bytes(whole) == bytes(threads));
  first.until(end, StopWhen{[&] { return first.steps() == whole.steps() / 2; }});
  write_checkpoint(folder / "half", first);
  read_checkpoint(folder / "half", second);
  second.until(end);
  CHECK(bytes(second) == bytes(whole));

  const auto alive = whole.part<0>().alive();
  std::array<int, 3> gone{};
  for (std::size_t e = 0; e < alive.size(); ++e)
    if (!alive[e]) {
      const std::size_t corners = detail::count_different(bar.hexahedra[e]);
      ++gone[corners == 8 ? 0 : corners == 6 ? 1 : 2];
    }
  CAPTURE(gone[0], gone[1], gone[2]);
  CHECK(whole.part<0>().deleted() > 0);
  CHECK(std::abs(whole.energy().error()) < 2e-3);
}
