// Birds and jets of particles on rigid plates: stagnation pressure, impulse and force.
#include <algorithm>
#include <cmath>
#include <vector>

#include "problems/particle_jet.hpp"
#include "support/catch.hpp"

using namespace strike;
using namespace strike::particle_jet;

TEST_CASE("particles: a bird on a rigid plate at four speeds", "[particles]") {
  for (const double v : {116.0, 180.0, 225.0, 300.0}) {
    const Jet jet{.across = 12, .speed = v};
    auto run = on_wall(jet, jet.mesh());
    Gauge gauge(jet, 0.2, 0.5);
    double drift = 0;
    run.until(1.6 * jet.length() / v, [&] {
      gauge.see(run);
      drift = std::max(drift, std::abs(run.energy().error()));
    });
    printf("v %g centre %.3f impulse %.4f drift %.4f steps %zu\n", v, gauge.centre(), 4*run.item<2>().impulse().z()/(jet.mass*v)-1, drift, run.steps());
    CHECK(gauge.centre() == Approx(1).epsilon(0.07));
    CHECK(4 * run.item<2>().impulse().z() == Approx(jet.mass * v).epsilon(0.012));
    CHECK(drift < 6e-3);
  }
}

TEST_CASE("particles: a long round-nosed jet gives rho A v^2, and its tail does not know", "[particles]") {
  const Jet jet{.across = 10, .aspect = 4, .has_round_nose = true};
  const Mesh mesh = jet.mesh();
  auto run = on_wall(jet, mesh);
  Gauge gauge(jet, 0.3, 0.7);
  double lag = 0;
  const double z = mesh.nodes.back().z(), T = jet.length() / jet.speed;
  run.until(0.7 * T, [&] {
    gauge.see(run);
    lag = std::max(lag, std::abs(run.nodes().x(mesh.nodes.size() - 1).z() - (z - jet.speed * run.time())));
  });
  printf("round force %.4f centre %.4f lag %.5f steps %zu n %zu drift %g\n", gauge.force(), gauge.centre(), lag/jet.length(), run.steps(), mesh.nodes.size(), run.energy().error());
  CHECK(gauge.force() == Approx(1).epsilon(0.03));
  CHECK(lag < 0.005 * jet.length());
}

TEST_CASE("particles: on an oblique plate the impulse is m v sin a along its normal", "[particles]") {
  for (const double degrees : {30.0, 45.0}) {
    const double a = degrees * std::numbers::pi / 180;
    const Jet jet{.across = 10, .is_quarter = false};
    Mesh mesh;
    for (const Mesh whole = jet.mesh(); const auto& x : whole.nodes)
      if (x.y() > 0) mesh.particles.cells.push_back({static_cast<Index>(mesh.nodes.size())}), mesh.nodes.push_back(x);
    mesh.particles.volumes.assign(mesh.nodes.size(), 0.5 * jet.volume() / static_cast<double>(mesh.nodes.size()));
    const Eigen::Vector3d normal(std::cos(a), 0, std::sin(a));
    double low = 0;
    for (const auto& x : mesh.nodes) low = std::min(low, normal.dot(x));
    Explicit run{Scene{mesh.nodes, Part{Particle{Smoothing{}, Mirrors{Mirror{{0, 1, 0}}}}, Fluid{water}, mesh.particles},
                       InitialVelocity{{0, 0, -jet.speed}}, RigidWall{low * normal, normal}}};
    const Eigen::Vector3d along(std::sin(a), 0, -std::cos(a));
    const double before = run.momentum().dot(along);
    double drift = 0;
    run.until(1.5 * (jet.length() + jet.width() / std::tan(a)) / jet.speed,
              [&] { drift = std::max(drift, std::abs(run.energy().error())); });
    const Eigen::Vector3d impulse = 2 * run.item<2>().impulse();
    printf("a %g impulse %.4f steps %zu n %zu drift %g along %g\n", degrees, impulse.dot(normal)/(jet.mass*jet.speed*std::sin(a))-1, run.steps(), mesh.nodes.size(), drift, run.momentum().dot(along)/before-1);
    CHECK(impulse.dot(normal) == Approx(jet.mass * jet.speed * std::sin(a)).epsilon(0.012));
    CHECK(run.momentum().dot(along) == Approx(before).epsilon(1e-12));
    CHECK(drift < 6e-3);
  }
}
