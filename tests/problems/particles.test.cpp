// Particles against closed forms: a plane shock, what turns freely, and an elastic ring.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <strike/contact/rigid_wall.hpp>
#include <strike/dynamics.hpp>
#include <strike/element/particle.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/load/support.hpp>
#include <strike/material/elastic.hpp>

#include "problems/particle_jet.hpp"
#include "problems/plane_shock.hpp"
#include "support/catch.hpp"
#include "support/velocities.hpp"

using namespace strike;
using particle_jet::filled;
using particle_jet::water;
using testing::Velocities;

namespace {

using Points = std::vector<Eigen::Vector3d>;

/// Angular momentum about the origin.
template <class Run>
Eigen::Vector3d turning(const Run& run) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < run.nodes().size(); ++i)
    sum += run.nodes().mass(i) * run.nodes().x(i).cross(run.nodes().v(i));
  return sum;
}

}  // namespace

// The layers that the front has passed, less those that it smears and a few at the wall, where the pressure of
// particles is low: they see nothing behind it, and its force acts on the first alone.
TEST_CASE("particles: a plane shock has the pressure and the speed of the jump conditions", "[particles]") {
  constexpr int layers = 40;
  const Mesh mesh = filled({0, 0, 0}, {4, 4, layers}, 1, 16.0 * layers, [](const auto&) { return true; });
  const Mirrors sides{Mirror{{1, 0, 0}}, Mirror{{0, 1, 0}}, Mirror{{1, 0, 0}, {4, 0, 0}}, Mirror{{0, 1, 0}, {0, 4, 0}}};
  for (const double v : {100.0, 180.0, 300.0}) {
    Explicit run{Scene{mesh.nodes, Part{Particle{Smoothing{}, sides}, Fluid{water}, mesh.particles},
                       InitialVelocity{{0, 0, -v}}, RigidWall{{0, 0, 0.5}, {0, 0, 1}}}};
    const plane_shock::Found found =
        plane_shock::found(run, plane_shock::Layers(mesh.nodes, mesh.particles.cells, layers), v);
    CHECK(found.speed == Approx(1).epsilon(0.015));
    CHECK(found.pressure == Approx(1).epsilon(0.015));
    CHECK(std::abs(run.energy().error()) < 6e-3);
  }
}

TEST_CASE("particles: a drop and a block of solid that turn freely keep their angular momentum", "[particles]") {
  const auto check = [](const Mesh& mesh, const auto& material, const Eigen::Vector3d& spin, double end) {
    Velocities v;
    for (const auto& x : mesh.nodes) v.v.push_back(spin.cross(x) + Eigen::Vector3d(0, 0.1 * spin.x() * x.z(), 0));
    Explicit run{Scene{mesh.nodes, Part{Particle{}, material, mesh.particles}, v}};
    const Eigen::Vector3d before = turning(run);
    run.until(end);
    CHECK((turning(run) - before).norm() < 1e-10 * before.norm());
    CHECK(std::abs(run.energy().error()) < 6e-3);
  };
  const CubicEos with_tension{.density = 1, .C1 = 1};
  const Mesh drop = filled({-5, -5, -5}, {5, 5, 5}, 1, 4 * std::numbers::pi / 3 * 91.125,
                           [](const Eigen::Vector3d& x) { return x.norm() < 4.5; });
  check(drop, Fluid{with_tension}, {0.01, 0.02, 0.03}, 60);
  const Mesh block = filled({-4, -3, -2}, {4, 3, 2}, 1, 8 * 6 * 4, [](const auto&) { return true; });
  check(block, Elastic{1, 1, 0.3}, {0.01, 0.02, 0.03}, 60);
}

// A thin ring breathes at sqrt(E/rho)/R; its squared frequency is the larger by ln(b/a) R/(b - a) = 1 + (b -
// a)^2/12R^2.
TEST_CASE("particles: an elastic ring breathes at its frequency", "[particles]") {
  constexpr double R = 20, E = 1, rho = 1, speed = 1e-3;
  constexpr int around = 32;  // in a quarter
  const double angle = std::numbers::pi / 2 / around;
  Mesh mesh;
  Velocities v;
  for (int k = 0; k < around; ++k)
    for (int i = -1; i < 2; ++i)
      for (int j = -1; j < 2; ++j) {
        const Eigen::Vector3d out(std::cos((k + 0.5) * angle), std::sin((k + 0.5) * angle), 0);
        mesh.particles.cells.push_back({static_cast<Index>(mesh.nodes.size())});
        mesh.particles.volumes.push_back((R + i) * angle);
        mesh.nodes.push_back((R + i) * out + Eigen::Vector3d(0, 0, j));
        v.v.push_back(speed * out);
      }
  for (const double nu : {0.0, 0.3}) {
    Explicit run{Scene{
        mesh.nodes,
        Part{Particle{Smoothing{}, Mirrors{Mirror{{1, 0, 0}}, Mirror{{0, 1, 0}}}}, Elastic{rho, E, nu}, mesh.particles},
        v}};
    std::vector<double> zeros;
    double before = 0, before_time = 0;
    run.until(2.2 * std::numbers::pi * R * std::sqrt(rho / E), [&] {
      double mean = 0;
      for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
        mean += (run.nodes().x(i).head<2>().norm() - mesh.nodes[i].head<2>().norm()) /
                static_cast<double>(mesh.nodes.size());
      if (before != 0 && before * mean < 0)
        zeros.push_back(before_time + (run.time() - before_time) * before / (before - mean));
      before = mean, before_time = run.time();
    });
    const double period = 2 * std::numbers::pi * R * std::sqrt(rho / E);
    CHECK(zeros.size() == 2);
    CHECK(zeros.back() == Approx(period).epsilon(0.004));  // .1 % is the thickness, the rest half a step and nine rows
  }
}
