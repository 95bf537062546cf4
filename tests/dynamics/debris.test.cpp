// Eroded elements that become particles: continuous where they do, and independent of how the scene is told, turned,
// cut, run or interrupted.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include <Eigen/Geometry>

#include <strike/contact/rigid_wall.hpp>
#include <strike/dynamics.hpp>
#include <strike/element/hex8.hpp>
#include <strike/element/hex8_full.hpp>
#include <strike/element/particle.hpp>
#include <strike/element/plate4.hpp>
#include <strike/element/tet4.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/load/support.hpp>
#include <strike/material.hpp>
#include <strike/mesh/box.hpp>
#include <strike/mesh/particles.hpp>
#include <strike/mesh/select.hpp>
#include <strike/mesh/tetrahedra.hpp>
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
const Particle bare{Smoothing{.hourglass = 0, .diffusion = 0}, Mirrors{}, HughesWinget{}, NoBulkViscosity{}};
const Hex8 bare_hexahedron{ViscousHourglass{0}, HughesWinget{}, NoBulkViscosity{}};

/// A block of hexahedra that erode strikes a wall aslant, spinning.
template <class M, class... Policies>
auto strike_wall(const M& material, const Mesh& mesh, const Frame& frame, const Policies&... policies) {
  Points x, v;
  for (const Eigen::Vector3d& X : mesh.nodes) {
    x.push_back(frame(X));
    v.push_back(frame.turn * Eigen::Vector3d(20 + 3 * X.z(), -10 * X.x(), -250 + 4 * X.y()));
  }
  return Explicit{Scene{x, Part{Hex8{}, material, mesh.hexahedra, Erosion{.strain = 0.5}},
                        Part{Particle{}, material, particles_at_nodes(x, mesh.hexahedra), Debris{.of = 0}},
                        Velocities{v}, RigidWall{frame({0, 0, 0}), frame.turn * Eigen::Vector3d(0, 0, 1)}},
                  policies...};
}
const Mesh brick = box({.size = {5, 4, 3}, .cells = {5, 4, 3}});

/// The angular momentum of all nodes about the origin.
template <class Run>
Eigen::Vector3d angular_momentum(const Run& run) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < run.nodes().size(); ++i)
    sum += run.nodes().mass(i) * run.positions()[i].cross(run.velocities()[i]);
  return sum;
}

}  // namespace

TEST_CASE("debris: a cube of particles has the forces of the hexahedron that it was", "[debris]") {
  // In a linear motion, which compresses and shears it: linear fields are exact in both, and by their planes of
  // symmetry both share them out alike.
  const Mesh cube = box({.size = {1, 1, 1}, .cells = {1, 1, 1}});
  Eigen::Matrix3d L;
  L << -40, 10, 5, 0, -30, 8, -7, 0, -50;
  Velocities linear;
  for (const Eigen::Vector3d& X : cube.nodes) linear.v.push_back(L * X);
  const ExplicitOptions options{.largest_step = 1e-7};
  const auto force = [&](const auto& material) {
    Explicit solid{Scene{cube.nodes, Part{bare_hexahedron, material, cube.hexahedra}, linear}, options};
    Explicit debris{
        Scene{cube.nodes, Part{bare_hexahedron, material, cube.hexahedra, Erosion{.volume = 1}},
              Part{bare, material, particles_at_nodes(cube.nodes, cube.hexahedra), Debris{.of = 0}}, linear},
        options};
    solid.step(), debris.step();
    CHECK(debris.template part<0>().deleted() == 1);
    double off = 0, largest = 0;
    for (std::size_t i = 0; i < 8; ++i) {
      off = std::max(off, (debris.nodes().f(i) - solid.nodes().f(i)).norm());
      largest = std::max(largest, solid.nodes().f(i).norm());
    }
    return off / largest;
  };
  CHECK(force(lead) < 1e-5);  // at the end of the step it is no cube any more, by a shear of 1e-6
  // Alone its particles have a moment whose harmonic mean is .0283, which a fluid lifts to .25/8: .82 of the forces.
  CHECK(force(water) == Approx(0.18).margin(0.01));
}

TEST_CASE("debris: whatever of a body erodes, its virial is the stress times its volume", "[debris]") {
  const Mesh mesh = box({.size = {4, 4, 4}, .cells = {4, 4, 4}});
  std::mt19937 random(2);
  std::uniform_real_distribution<double> noise(-0.12, 0.12), size(0.9, 1.1);
  Points x = mesh.nodes;
  for (Eigen::Vector3d& X : x) X += Eigen::Vector3d(noise(random), noise(random), noise(random));
  const auto check = [&](const auto& element, const auto& cells) {
    Velocities squeeze;
    for (const Eigen::Vector3d& X : x) squeeze.v.push_back(-40 * (X - Eigen::Vector3d(2, 2, 2)));
    Explicit run{Scene{x, Part{element, water, cells, Erosion{.volume = 0.9999}},
                       Part{bare, water, particles_at_nodes(x, cells), Debris{.of = 0}}, squeeze},
                 ExplicitOptions{.largest_step = 1e-5}};
    run.step();
    CHECK(run.template part<0>().deleted() == cells.size());
    double volume = 0;
    for (const double V : particles_at_nodes(x, cells).volumes) volume += V;
    const double J = std::pow(1 - 40 * run.dt(), 3), mu = 1 / J - 1, p = 2.2 * mu + 6 * mu * mu + 10 * mu * mu * mu;
    Eigen::Matrix3d virial = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < x.size(); ++i) virial += run.nodes().f(i) * run.positions()[i].transpose();
    // By the duality of forces to rates, which are exact for linear fields on any arrangement.
    CHECK((virial - J * volume * p * Eigen::Matrix3d::Identity()).norm() < 1e-9 * volume * p);
  };
  check(bare_hexahedron, mesh.hexahedra);
  check(Tet4{ElementPressure{}, HughesWinget{}, NoBulkViscosity{}},
        tetrahedralized(Mesh{x, mesh.hexahedra}).tetrahedra);
}

TEMPLATE_TEST_CASE("debris: momentum, angular momentum and energy go over", "[debris]", double, int) {
  const auto& material = [] {
    if constexpr (std::is_same_v<TestType, double>)
      return lead;
    else
      return water;
  }();
  // A spinning block that a pull tears apart, with no wall to take anything.
  Velocities spin;
  for (const Eigen::Vector3d& X : brick.nodes) {
    const Eigen::Vector3d x = X - Eigen::Vector3d(2.5, 2, 1.5);
    spin.v.push_back(Eigen::Vector3d(0, 0, 60).cross(x) + 45 * Eigen::Vector3d(x.x(), -x.y(), -0.3 * x.z() * x.x()));
  }
  Explicit run{Scene{brick.nodes, Part{Hex8{}, material, brick.hexahedra, Erosion{.strain = 0.2}},
                     Part{Particle{}, material, particles_at_nodes(brick.nodes, brick.hexahedra), Debris{.of = 0}},
                     spin}};
  const Eigen::Vector3d p = run.momentum(), l = angular_momentum(run);
  run.until(0.02);
  CHECK(run.template part<0>().deleted() > 20);
  CHECK((run.momentum() - p).norm() < 1e-12 * l.norm());
  CHECK((angular_momentum(run) - l).norm() < 1e-2 * l.norm());
  CHECK(std::abs(run.energy().eroded) < 1e-14);
  CHECK(std::abs(run.energy().error()) < 2e-3);
}

TEST_CASE("debris: the scene turned, renumbered, on threads or in other lanes gives the same", "[debris]") {
  auto run = strike_wall(water, brick, {});
  run.until(0.007);
  CHECK(run.part<0>().deleted() > 10);
  CHECK(run.part<0>().deleted() < 60);
  const Points x = run.positions();

  const Frame frame = tilted(0.7, {1, 2, -0.5});
  auto turned = strike_wall(water, brick, frame);
  turned.until(0.007);
  CHECK(off(turned, x, frame) < 1e-8);

  Mesh shuffled = brick;
  std::reverse(shuffled.nodes.begin(), shuffled.nodes.end());
  std::reverse(shuffled.hexahedra.begin(), shuffled.hexahedra.end());
  for (auto& cell : shuffled.hexahedra)
    for (Index& i : cell) i = static_cast<Index>(shuffled.nodes.size() - 1 - i);
  auto renumbered = strike_wall(water, shuffled, {});
  renumbered.until(0.007);
  Points back = renumbered.positions();
  std::reverse(back.begin(), back.end());
  CHECK(off(run, back) < 1e-8);

  auto threads = strike_wall(water, brick, {}, OpenMP{2});
  threads.until(0.007);
  CHECK(off(threads, x) == 0);
  auto one_lane = strike_wall(water, brick, {}, in<double>);
  one_lane.until(0.007);
  CHECK(off(one_lane, x) < 1e-8);
  auto mixed = strike_wall(water, brick, {}, in<Pack<float>, double>);
  mixed.until(0.007);
  CHECK(off(mixed, x) < 2e-3);
  auto cycles = strike_wall(water, brick, {}, Subcycling{});
  cycles.until(0.007);
  CHECK(off(cycles, x) < 0.1);
}

TEST_CASE("debris: a half and a quarter, cut at mirrors through its nodes at any angle of the scene, are the whole",
          "[debris]") {
  const Frame frame = tilted(1.1, {1, 0.3, -0.5});
  const Mirror across{2 * frame.turn.col(0), frame({0, 5, 1})}, along{frame.turn.col(1), frame({1, 0, 2})};
  const auto struck = [&](bool half, bool quarter) {
    const Mesh mesh = box({.lower = {half ? 0. : -3, quarter ? 0. : -3, 0},
                           .size = {half ? 3. : 6, quarter ? 3. : 6, 4},
                           .cells = {half ? 3u : 6, quarter ? 3u : 6, 4}});
    Points x;
    for (const Eigen::Vector3d& X : mesh.nodes) x.push_back(frame(X));
    const auto in = [&](Eigen::Index c) {
      return nodes_where(mesh.nodes, [&, c](const auto& X) { return (c == 0 ? half : quarter) && X[c] == 0; });
    };
    const Mirrors mirrors = quarter ? Mirrors{across, along} : half ? Mirrors{across} : Mirrors{};
    Explicit run{Scene{x, Part{Hex8{}, water, mesh.hexahedra, Erosion{.strain = 0.5}},
                       Part{Particle{Smoothing{}, mirrors}, water, particles_at_nodes(x, mesh.hexahedra), Debris{}},
                       Symmetry{frame.turn.col(0), in(0)}, Symmetry{frame.turn.col(1), in(1)},
                       InitialVelocity{frame.turn * Eigen::Vector3d(0, 0, -250)},
                       RigidWall{frame({0, 0, 0}), frame.turn * Eigen::Vector3d(0, 0, 1)}}};
    run.until(0.01);
    CHECK(run.part<0>().deleted() > mesh.hexahedra.size() / 4);
    std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> at;  // of the nodes of the quarter
    const Points now = run.positions();
    for (std::size_t i = 0; i < x.size(); ++i)
      if (mesh.nodes[i].x() >= 0 && mesh.nodes[i].y() >= 0) at.push_back({mesh.nodes[i], now[i]});
    return at;
  };
  const auto whole = struck(false, false), half = struck(true, false), quarter = struck(true, true);
  REQUIRE(whole.size() == quarter.size());
  double most = 0;
  for (const auto& [X, x] : whole)
    for (const auto* cut : {&half, &quarter})
      for (const auto& [Y, y] : *cut)
        if ((X - Y).norm() < 1e-9) most = std::max(most, (x - y).norm());
  CHECK(most < 1e-8);
}

TEST_CASE("debris: a run goes on from a checkpoint of any step to the bit", "[debris]") {
  const ScratchFolder folder("debris");
  auto whole = strike_wall(water, brick, {});
  whole.until(0.01);
  std::size_t deleted = 0;
  for (const double share : {0.1, 0.4, 0.7}) {
    auto first = strike_wall(water, brick, {}), second = strike_wall(water, brick, {});
    const auto steps = static_cast<std::size_t>(share * static_cast<double>(whole.steps()));
    first.until(0.01, StopWhen{[&] { return first.steps() == steps; }});
    CHECK(first.part<0>().deleted() >= deleted);
    deleted = first.part<0>().deleted();
    write_checkpoint(folder / "half", first);
    read_checkpoint(folder / "half", second);
    second.until(0.01);
    CHECK(off(whole, second.positions()) == 0);
    CHECK(whole.energy().internal == second.energy().internal);
    CHECK(whole.energy().eroded == second.energy().eroded);
  }
  CHECK(deleted > 0);
}

TEST_CASE("debris: what a solid becomes as a fluid has its mass and its pressure", "[debris]") {
  // A brick under uniform compression, eroded at once: of glass, with half its density again as a fluid.
  const Mesh mesh = box({.size = {3, 3, 3}, .cells = {3, 3, 3}});
  const double K = 40, J = 0.99;
  Velocities squeeze;
  for (const Eigen::Vector3d& X : mesh.nodes) squeeze.v.push_back((std::cbrt(J) - 1) / 1e-6 * X);
  const Elastic glass{2e-6, K, 0.2};
  for (const double density : {2e-6, 1e-6}) {
    const Fluid dust{LinearEos{.density = density, .bulk_modulus = 3.0}};
    Explicit run{Scene{mesh.nodes, Part{bare_hexahedron, glass, mesh.hexahedra, Erosion{.volume = 0.995}},
                       Part{bare, dust, particles_at_nodes(mesh.nodes, mesh.hexahedra), Debris{.of = 0}}, squeeze},
                 ExplicitOptions{.largest_step = 1e-6}};
    run.step();
    CHECK(run.part<0>().deleted() == 27);
    double volume = 0;
    const auto& part = run.part<1>();
    for (std::size_t b = 0; b < part.blocks().size(); ++b)
      for (std::size_t l = 0; l < part.count(b); ++l) {
        volume += lane(part.blocks()[b].state.reference_volume, l);
        CHECK(lane(part.blocks()[b].state.relative_volume, l) == Approx(J * density / 2e-6).epsilon(1e-6));
      }
    CHECK(density * volume == Approx(27 * 2e-6).epsilon(1e-12));
  }
}

TEST_CASE("debris: particles that erode in their turn are born again where the next element goes", "[debris]") {
  // The wall bends what leaves it; what has spread to thrice its volume is deleted, with its energy.
  Velocities v;
  for (const Eigen::Vector3d& X : brick.nodes) v.v.push_back({0, 2 * X.x(), -400 + X.y()});
  Explicit run{Scene{brick.nodes, Part{Hex8{}, lead, brick.hexahedra, Erosion{.strain = 0.3}},
                     Part{Particle{}, lead, particles_at_nodes(brick.nodes, brick.hexahedra),
                          Debris{.of = 0, .erosion = {.strain = 0.6}}},
                     v, RigidWall{{0, 0, 0}, {0, 0, 1}}}};
  run.until(0.03);
  CHECK(run.part<0>().deleted() > 20);
  CHECK(run.part<1>().deleted() > 5);
  CHECK(run.energy().eroded > 0);
  CHECK(std::abs(run.energy().error()) < 1e-2);  // as of particles that erode
}

TEST_CASE("debris: what is missing or wrong is said", "[debris]") {
  const Mesh mesh = box({.size = {2, 1, 1}, .cells = {2, 1, 1}});
  const Particles all = particles_at_nodes(mesh.nodes, mesh.hexahedra),
                  some = particles_at_nodes(mesh.nodes, Cells<8>{mesh.hexahedra[0]});
  CHECK(all.size() == 12);
  const Part solid{Hex8{}, water, mesh.hexahedra, Erosion{}};
  CHECK_THROWS_WITH(
      (Explicit{Scene{mesh.nodes, Part{Hex8{}, water, mesh.hexahedra}, Part{Particle{}, water, all, Debris{.of = 0}}}}),
      "strike: part 1 is Debris of part 0, whose elements are never deleted; give that part an Erosion.");
  CHECK_THROWS_WITH((Explicit{Scene{mesh.nodes, solid, Part{Particle{}, water, all, Debris{.of = 1}}}}),
                    "strike: part 1 is Debris of part 1, which is not before it in the scene; put it there.");
  CHECK_THROWS_WITH((Explicit{Scene{mesh.nodes, solid, Part{Particle{}, water, all, Debris{}},
                                    Part{Particle{}, water, all, Debris{}}}}),
                    "strike: part 2 is Debris of part 0, which has debris already; give a part one debris.");
  CHECK_THROWS_WITH((Explicit{Scene{mesh.nodes, solid, Part{Particle{}, water, some, Debris{}}}}),
                    Catch::Matchers::Contains("of part 0 is no particle of part 1, its Debris; make these by "
                                              "particles_at_nodes of the same cells."));
  CHECK_THROWS_WITH(
      (Explicit{Scene{mesh.nodes, solid, Part{Particle{}, water, all, Debris{.erosion = {.strain = 1}}}}}),
      Catch::Matchers::Contains("no plastic strain by which Erosion{.strain = 1}"));
}
