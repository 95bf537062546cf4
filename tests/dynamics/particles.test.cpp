// Particles in a run: what neighbours make of a linear motion, and that the answer does not depend on how the scene is
// told, turned, cut, run or interrupted.
#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include <strike/contact/rigid_wall.hpp>
#include <strike/dynamics.hpp>
#include <strike/element/hex8.hpp>
#include <strike/element/particle.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/material.hpp>
#include <strike/mesh/box.hpp>
#include <strike/motion/openmp.hpp>
#include <strike/output/checkpoint.hpp>

#include "output/scratch.hpp"
#include "support/catch.hpp"
#include "support/frame.hpp"
#include "support/velocities.hpp"

using namespace strike;
using testing::Frame;
using testing::off;
using testing::tilted;
using testing::Velocities;

namespace {

using Points = std::vector<Eigen::Vector3d>;

const Fluid water{CubicEos{.density = 1e-6, .C1 = 2.2, .C2 = 6, .C3 = 10, .pressure_cutoff = 0}};
const Solid lead{LinearEos{.density = 1e-6, .bulk_modulus = 2.2},
                 VonMises{.shear_modulus = 0.5, .yield_stress = 0.02, .hardening_modulus = 0.01}};

/// A block of particles of unit spacing whose corner is at the origin, each off its place by up to `noise`.
Mesh block(int nx, int ny, int nz, double noise = 0) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-noise, noise);
  Mesh mesh;
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) {
        mesh.particles.cells.push_back({static_cast<Index>(mesh.nodes.size())});
        mesh.particles.volumes.push_back(1);
        mesh.nodes.push_back(Eigen::Vector3d(i + 0.5, j + 0.5, k + 0.5) +
                             Eigen::Vector3d(unit(random), unit(random), unit(random)));
      }
  return mesh;
}

/// The block strikes a wall aslant, spinning.
template <class M, class... Policies>
auto strike_wall(const M& material, const Mesh& mesh, const Frame& frame, const Policies&... policies) {
  Points x, v;
  for (const Eigen::Vector3d& X : mesh.nodes) {
    x.push_back(frame(X));
    v.push_back(frame.turn * Eigen::Vector3d(20 + 3 * X.z(), -10 * X.x(), -150 + 4 * X.y()));
  }
  return Explicit{Scene{x, Part{Particle{}, material, mesh.particles}, Velocities{v},
                        RigidWall{frame({0, 0, 0}), frame.turn * Eigen::Vector3d(0, 0, 1)}},
                  policies...};
}

}  // namespace

TEST_CASE("particles: lists of neighbours hold as long as they say, wherever all go", "[particles]") {
  constexpr double reach = 2.6, skin = 0.5;
  Points x = block(8, 8, 8, 0.3).nodes;
  for (const Eigen::Vector3d& drop : block(4, 4, 4, 0.3).nodes) x.push_back(drop + Eigen::Vector3d(0, 0, 20));
  detail::Neighbours<4> neighbours;
  neighbours.find(x, x.size(), reach + skin, Serial{});
  const auto hold = [&](const auto& way) {
    Points ways;
    for (const Eigen::Vector3d& at : x) ways.push_back(way(at));
    const bool holds = neighbours.hold(ways, reach, skin, Serial{});
    bool are_there = true;
    for (std::size_t i = 0; i < x.size(); ++i)
      for (std::size_t j = 0; j < x.size(); ++j) {
        const auto& list = neighbours.of(i / 4);
        if ((x[i] + ways[i] - x[j] - ways[j]).norm() < reach && !std::binary_search(list.begin(), list.end(), j))
          are_there = false;
      }
    if (holds) CHECK(are_there);
    return holds;
  };
  using Vector = Eigen::Vector3d;
  CHECK(hold([](const Vector&) { return Vector(1e3, -2e3, 5); }));
  CHECK(hold([](const Vector& at) { return Vector(0.03 * at.z(), 0, 0); }));
  CHECK(hold([](const Vector& at) { return Vector(0, 0, at.z() > 10 ? -9 : 0); }));
  CHECK_FALSE(hold([](const Vector& at) { return Vector(0, 0, at.z() > 10 ? -12 : 0); }));  // they meet
  CHECK_FALSE(hold([](const Vector& at) { return Vector(-0.2 * at); }));
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  int held = 0;
  for (int n = 0; n < 200; ++n) {
    const double size = 0.02 * (n % 20 + 1);
    Eigen::Matrix3d gradient;
    for (double& a : gradient.reshaped()) a = 0.3 * size * normal(random);
    const Vector along(20 * normal(random), 20 * normal(random), 20 * normal(random));
    held += hold([&](const Vector& at) {
      return Vector(along + gradient * at + 0.3 * size * Vector(normal(random), normal(random), normal(random)));
    });
  }
  CHECK(held > 20);
  CHECK(held < 180);
}

TEST_CASE("particles: a linear motion of any arrangement changes all volumes by its determinant", "[particles]") {
  const Mesh mesh = block(7, 6, 5, 0.35);
  Eigen::Matrix3d L;
  L << 0.02, -0.3, 0.11, 0.25, 0.04, -0.2, 0.07, 0.17, -0.03;
  Velocities linear;
  for (const Eigen::Vector3d& x : mesh.nodes) linear.v.push_back(1e-3 * L * x);
  Explicit run{Scene{mesh.nodes, Part{Particle{Smoothing{.diffusion = 0}}, lead, mesh.particles}, linear},
               ExplicitOptions{.largest_step = 1e-3}};
  run.step();
  const double J = (Eigen::Matrix3d::Identity() + 1e-3 * run.dt() * L).determinant();
  const auto& part = run.part<0>();
  for (std::size_t b = 0; b < part.blocks().size(); ++b)
    for (std::size_t l = 0; l < part.count(b); ++l)  // rounding: of positions over the change, 1e-16 5/1e-8
      CHECK(lane(part.blocks()[b].state.relative_volume, l) - 1 == Approx(J - 1).epsilon(1e-6));
}

TEST_CASE("particles: a rigid motion gives no force, momentum is kept and the ledger balances", "[particles]") {
  const Mesh mesh = block(5, 5, 5, 0.3);
  const Eigen::AngleAxisd turn(0.05, Eigen::Vector3d(1, -2, 0.5).normalized());
  Velocities spin;
  for (const Eigen::Vector3d& x : mesh.nodes) spin.v.push_back((turn * x - x) / 1e-4);
  const Particle inviscid{Smoothing{}, Mirrors{}, HughesWinget{},
                          NoBulkViscosity{}};  // the first rate is measured ahead
  Explicit still{Scene{mesh.nodes, Part{inviscid, lead, mesh.particles}, spin}, ExplicitOptions{.largest_step = 1e-4}};
  still.step();
  CHECK(still.dt() == 1e-4);
  for (const auto& s : still.part<0>().field(StressTensor{}))
    CHECK(std::abs(s.xx) + std::abs(s.xy) < 1e-13 * 2.2);  // rounding of a few sums

  auto run = strike_wall(lead, mesh, {});
  const double before = run.momentum().z();
  run.until(0.02);
  CHECK(run.momentum().x() ==
        Approx(Explicit{Scene{mesh.nodes, Part{Particle{}, lead, mesh.particles}}}.momentum().x() +
               strike_wall(lead, mesh, {}).momentum().x())
            .epsilon(1e-12));
  CHECK(run.momentum().z() - before == Approx(run.item<2>().impulse().z()).epsilon(1e-12));
  CHECK(std::abs(run.energy().error()) < 5e-3);
}

TEMPLATE_TEST_CASE("particles: the scene turned, renumbered, on threads or in other lanes gives the same",
                   "[particles]", double, int) {
  const auto& material = [] {
    if constexpr (std::is_same_v<TestType, double>)
      return lead;
    else
      return water;
  }();
  const Mesh mesh = block(6, 5, 4, 0.1);
  auto run = strike_wall(material, mesh, {});
  run.until(0.01);
  const Points x = run.positions();

  const Frame frame = tilted(0.7, {1, 2, -0.5});
  auto turned = strike_wall(material, mesh, frame);
  turned.until(0.01);
  CHECK(off(turned, x, frame) < 1e-9);

  Mesh shuffled = mesh;
  std::reverse(shuffled.nodes.begin(), shuffled.nodes.end());
  auto renumbered = strike_wall(material, shuffled, {});
  renumbered.until(0.01);
  Points back = renumbered.positions();
  std::reverse(back.begin(), back.end());
  CHECK(off(run, back) < 1e-9);

  auto threads = strike_wall(material, mesh, {}, OpenMP{2});
  threads.until(0.01);
  CHECK(off(threads, x) == 0);
  auto one_lane = strike_wall(material, mesh, {}, in<double>);
  one_lane.until(0.01);
  CHECK(off(one_lane, x) < 1e-9);
  auto mixed = strike_wall(material, mesh, {}, in<Pack<float>, double>);
  mixed.until(0.01);
  CHECK(off(mixed, x) < 1e-3);  // of a path of 1.5
  Frame far;
  far.shift = {1e5, 0, 0};  // where floats are .008 apart
  auto mixed_far = strike_wall(material, mesh, far, in<Pack<float>, double>);
  mixed_far.until(0.01);
  CHECK(off(mixed_far, x, far) < 1e-3);
}

TEST_CASE("particles: a half and a quarter, cut at mirrors at any angle of the scene, are the whole", "[particles]") {
  const Mesh quarter = block(4, 3, 5, 0.1);
  const Frame frame = tilted(1.1, {1, 0.3, -0.5});
  const auto struck = [&](int quarters, const Mirrors& mirrors) {
    Mesh mesh;
    for (int q = 0; q < quarters; ++q)
      for (const Eigen::Vector3d& X : quarter.nodes) {
        mesh.particles.cells.push_back({static_cast<Index>(mesh.nodes.size())});
        mesh.nodes.push_back(frame({q % 2 == 0 ? X.x() : -X.x(), q < 2 ? X.y() : -X.y(), X.z()}));
      }
    mesh.particles.volumes.assign(mesh.nodes.size(), 1);
    Explicit run{Scene{mesh.nodes, Part{Particle{Smoothing{}, mirrors}, water, mesh.particles},
                       InitialVelocity{frame.turn * Eigen::Vector3d(0, 0, -200)},
                       RigidWall{frame({0, 0, 0}), frame.turn * Eigen::Vector3d(0, 0, 1)}}};
    run.until(0.02);
    CHECK(std::abs(run.energy().error()) < 1e-2);
    Points x = run.positions();
    x.resize(quarter.nodes.size());
    return x;
  };
  const Mirror across{2 * frame.turn.col(0), frame({0, 5, 1})}, along{frame.turn.col(1), frame({1, 0, 2})};
  const Points whole = struck(4, {}), half = struck(2, Mirrors{along}), cut = struck(1, Mirrors{across, along}),
               other = struck(1, Mirrors{along, across});
  double most = 0, path = 0;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    for (const Points* x : {&half, &cut, &other}) most = std::max(most, ((*x)[i] - whole[i]).norm());
    path = std::max(path, (whole[i] - frame(quarter.nodes[i])).norm());
  }
  CHECK(path > 2);
  CHECK(most < 1e-10);
}

TEST_CASE("particles: a slice between parallel mirrors is the same as a slice and its image", "[particles]") {
  const Mesh slice = block(4, 3, 5, 0.1);
  const auto strike = [&](bool with_image) {
    Mesh mesh = slice;
    for (std::size_t i = 0; with_image && i < slice.nodes.size(); ++i) {
      const Eigen::Vector3d& x = slice.nodes[i];
      mesh.particles.cells.push_back({static_cast<Index>(mesh.nodes.size())}), mesh.particles.volumes.push_back(1);
      mesh.nodes.push_back({8 - x.x(), x.y(), x.z()});
    }
    const Mirrors mirrors{Mirror{{1, 0, 0}}, Mirror{{0, 1, 0}}, Mirror{{-2, 0, 0}, {with_image ? 8.0 : 4.0, 7, 1}}};
    Explicit run{Scene{mesh.nodes, Part{Particle{Smoothing{}, mirrors}, water, mesh.particles},
                       InitialVelocity{{0, 0, -200}}, RigidWall{{0, 0, 0}, {0, 0, 1}}}};
    run.until(0.02);
    Points x = run.positions();
    x.resize(slice.nodes.size());
    return x;
  };
  const Points one = strike(false), two = strike(true);
  double most = 0;
  for (std::size_t i = 0; i < one.size(); ++i) most = std::max(most, (one[i] - two[i]).norm());
  CHECK(most < 1e-10);
}

TEST_CASE("particles: a run goes on from a checkpoint of any step to the bit, in double and mixed precision",
          "[particles]") {
  const ScratchFolder folder("particles");
  const Mesh mesh = block(5, 5, 4, 0.1);
  const auto goes_on = [&](const auto& numbers, std::size_t steps) {
    const auto begin = [&] { return strike_wall(water, mesh, {}, numbers); };
    auto whole = begin(), first = begin(), second = begin();
    whole.until(0.012);
    first.until(0.012, StopWhen{[&] { return first.steps() == steps; }});
    write_checkpoint(folder / "half", first);
    read_checkpoint(folder / "half", second);
    CHECK(second.steps() == steps);
    second.until(0.012);
    CHECK(off(whole, second.positions()) == 0);
    CHECK(whole.energy().internal == second.energy().internal);
    CHECK(whole.energy().hourglass == second.energy().hourglass);
  };
  for (const std::size_t steps : {1u, 4u, 7u}) goes_on(in<Pack<double>>, steps);
  goes_on(in<Pack<float>, double>, 6);
}

TEST_CASE("particles: what is eroded acts on nobody, keeps its mass and takes its energy along", "[particles]") {
  const Mesh mesh = block(6, 5, 5, 0.1);
  Velocities v;
  for (const Eigen::Vector3d& x : mesh.nodes) v.v.push_back({0, 2 * x.x(), -400 + x.y()});
  Explicit run{Scene{mesh.nodes, Part{Particle{}, lead, mesh.particles, Erosion{.strain = 0.3}}, v,
                     RigidWall{{0, 0, 0}, {0, 0, 1}}}};
  const double before = run.momentum().z();
  run.until(0.03);
  CHECK(run.part<0>().deleted() > 5);
  CHECK(run.part<0>().deleted() < mesh.nodes.size());
  CHECK(run.energy().eroded > 0);
  // The rates of its neighbours jump when one goes, at the end of a step that it has begun: .4 to .6 % by rounding.
  CHECK(std::abs(run.energy().error()) < 1e-2);
  CHECK(run.momentum().z() - before == Approx(run.item<2>().impulse().z()).epsilon(1e-12));
}

TEST_CASE("particles: one far away changes nothing", "[particles]") {
  const Mesh mesh = block(6, 5, 4, 0.1);
  auto run = strike_wall(water, mesh, {});
  run.until(0.01);
  Mesh more = mesh;
  more.particles.cells.push_back({static_cast<Index>(more.nodes.size())}), more.particles.volumes.push_back(1);
  more.nodes.push_back({0, 0, 1e6});
  auto with = strike_wall(water, more, {});
  with.until(0.01);
  Points x = with.positions();
  x.pop_back();
  CHECK(off(run, x) < 1e-9);  // other blocks, so other rounding
}

TEST_CASE("particles: beside hexahedra, which may take longer steps, on shared nodes", "[particles]") {
  Mesh mesh = block(4, 4, 4);
  const Mesh plate = box({.size = {12, 12, 3}, .cells = {3, 3, 1}});
  const auto first = static_cast<Index>(mesh.nodes.size());
  for (const Eigen::Vector3d& x : plate.nodes) mesh.nodes.push_back(x - Eigen::Vector3d(4, 4, 3));
  Cells<8> hexahedra = plate.hexahedra;
  for (auto& cell : hexahedra)
    for (Index& i : cell) i += first;
  Index shared = 0;  // a particle that holds to the plate
  for (Index i = first; i < mesh.nodes.size(); ++i)
    if ((mesh.nodes[i] - Eigen::Vector3d(0, 0, 0)).norm() < 1e-9) shared = i;
  REQUIRE(shared > 0);
  mesh.particles.cells.push_back({shared}), mesh.particles.volumes.push_back(1);
  Velocities v;
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) v.v.push_back({0, 0, i < first ? -20.0 : 0.0});
  const auto run_with = [&](const auto&... policies) {
    Explicit run{
        Scene{mesh.nodes, Part{Particle{}, lead, mesh.particles}, Part{Hex8{ViscousHourglass{}}, lead, hexahedra}, v},
        policies...};
    const Eigen::Vector3d before = run.momentum();
    run.until(0.03);
    CHECK((run.momentum() - before).norm() < 1e-12 * before.norm());
    CHECK(std::abs(run.energy().error()) < 1e-2);
    return run;
  };
  const auto every = run_with();
  CHECK(off(run_with(OpenMP{2}), every.positions()) == 0);
  const auto cycles = run_with(Subcycling{});
  CHECK(cycles.cycle().multiple() > 1);
  CHECK(off(cycles, every.positions()) < 0.02);  // of a path of .6
  CHECK((every.positions()[shared] - mesh.nodes[shared]).norm() > 0.01);
}

TEST_CASE("particles: what is missing or wrong is said", "[particles]") {
  Mesh mesh = block(2, 2, 2);
  const auto start = [&] { return Explicit{Scene{mesh.nodes, Part{Particle{}, water, mesh.particles}}}; };
  mesh.particles.volumes.pop_back();
  CHECK_THROWS_WITH(start(), "strike: part 0 has 8 particles, but 7 volumes; give one for each.");
  mesh.particles.volumes.push_back(-1);
  CHECK_THROWS_WITH(start(), "strike: particle 7 of part 0 has the volume -1; it must be positive and finite.");
  mesh.particles.volumes.back() = 1;
  CHECK_THROWS_WITH((Explicit{Scene{mesh.nodes, Part{Particle{}, water, mesh.particles, Erosion{.strain = 2}}}}),
                    "strike: the particles of part 0 have no plastic strain by which Erosion{.strain = 2} could delete "
                    "them; limit them by .volume or .step.");
  const Mirrors narrow{Mirror{{1, 0, 0}}, Mirror{{-1, 0, 0}, {2, 0, 0}}};
  CHECK_THROWS_WITH((Explicit{Scene{mesh.nodes, Part{Particle{Smoothing{}, narrow}, water, mesh.particles}}}),
                    "strike: the parallel mirrors 1 and 0 of part 0 are 2 apart, and its particles see as far as 3.1; "
                    "put them farther apart.");
  CHECK_THROWS_WITH(
      (Mirrors{Mirror{{1, 0, 0}}, Mirror{{1, 1, 0}}}),
      Catch::Matchers::Contains("between mirrors 0 and 1") && Catch::Matchers::Contains("put them at right angles"));
}
