#include <cmath>
#include <random>

#include <strike/contact/rigid_wall.hpp>
#include <strike/dynamics/explicit.hpp>
#include <strike/element/hex8.hpp>
#include <strike/load/body_force.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/load/prescribed_motion.hpp>
#include <strike/load/pressure.hpp>
#include <strike/mesh/box.hpp>
#include <strike/mesh/transform.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {

constexpr Elastic rubber{.density = 1000, .youngs_modulus = 1e8, .poissons_ratio = 0.3};  // [kg/m3, Pa]

Mesh block() { return box({.size = {0.2, 0.3, 0.1}, .cells = {2, 3, 1}}); }
constexpr double block_mass = 0.2 * 0.3 * 0.1 * 1000;

using Random = std::mt19937;
Eigen::Vector3d random_vector(Random& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  const double x = uniform(random), y = uniform(random), z = uniform(random);
  return {x, y, z};
}

/// Each node at the start with a velocity of its own.
struct RandomVelocity {
  double size;
  unsigned seed = 1;
  template <class N>
  void begin(N& nodes) const {
    Random random(seed);
    for (std::size_t i = 0; i < nodes.size(); ++i) nodes.set_velocity(i, size * random_vector(random));
  }
};

}  // namespace

// From rest x = g t^2/2 at every step, of whatever length: the midpoint rule is exact for a velocity that is linear.
TEST_CASE("free fall is exact") {
  const Mesh mesh = block();
  const Eigen::Vector3d g(1, 2, -9.81);
  Explicit run{Scene{mesh.nodes, Part{Hex8{}, rubber, mesh.hexahedra}, BodyForce{g}}};
  double worst = 0, drift = 0;
  const auto compare = [&] {
    const double t = run.time();
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
      worst = std::max(worst, (run.nodes().x(i) - mesh.nodes[i] - 0.5 * t * t * g).norm());
  };
  while (run.steps() < 300) {  // in equal steps the balance is exact too, from the first on
    run.step();
    compare();
    drift = std::max(drift, std::abs(run.energy().error()));
  }
  CHECK(drift < 1e-12);
  run.until(0.1, compare);
  CHECK(worst < 1e-15);
  CHECK(run.energy().external ==
        Approx(block_mass * 0.5 * 0.01 * g.squaredNorm()).epsilon(0.01));  // one step of 600 ago
}

TEST_CASE("a body force with a history: the impulse is its trapezoidal sum") {
  const Mesh mesh = block();
  const double T = 0.01;
  const Curve triangle{{{0, 0}, {T / 2, 1}, {T, 0}}};
  Explicit run{Scene{mesh.nodes, Part{Hex8{}, rubber, mesh.hexahedra}, BodyForce{{0, 0, 100}, triangle}},
               ExplicitOptions{.largest_step = T / 200}};  // the corners of the curve are times of steps
  run.until(2 * T);
  CHECK(run.momentum().z() == Approx(block_mass * 100 * T / 2).epsilon(1e-12));
}

TEST_CASE("prescribed displacements are met exactly at every step, prescribed velocities in the middle of each") {
  const Mesh mesh = block();
  const std::vector<Index> left = nodes_where(mesh.nodes, on_plane(Axis::x, 0)),
                           right = nodes_where(mesh.nodes, on_plane(Axis::x, 0.2));
  const Eigen::Vector3d direction = Eigen::Vector3d(3, 0, 4) / 5;
  const auto u = [](double t) { return 1e-3 * std::sin(300 * t); };
  const auto v = [](double t) { return 2 * t; };
  Explicit run{Scene{mesh.nodes, Part{Hex8{}, rubber, mesh.hexahedra}, PrescribedDisplacement{direction, left, u},
                     PrescribedVelocity{Axis::y, right, v}}};
  double worst_u = 0, worst_v = 0;
  run.until(0.02, [&] {
    const double t = run.time();
    for (const Index i : left)
      worst_u = std::max(worst_u, std::abs((run.nodes().x(i) - mesh.nodes[i]).dot(direction) - u(t)));
    for (const Index i : right) worst_v = std::max(worst_v, std::abs(run.nodes().x(i).y() - mesh.nodes[i].y() - t * t));
  });
  CHECK(worst_u < 1e-15);
  CHECK(worst_v < 1e-15);  // linear in time, for which the midpoint rule is exact
}

TEST_CASE("a pressure with a history: its impulse, its work, and none of it on a closed surface") {
  const Mesh mesh = rotated(block(), {1, 2, 3}, 0.7);
  const std::vector<Face> all = surface(mesh);
  const double T = 0.01, p = 1000;  // a strain of p/E = 1e-5
  const Curve triangle{{{0, 0}, {T / 2, p}, {T, 0}}};
  std::vector<Face> top;
  Eigen::Vector3d area = Eigen::Vector3d::Zero();
  const Eigen::Vector3d normal = rotated(Mesh{.nodes = {{0, 0, 1}}}, {1, 2, 3}, 0.7).nodes[0];
  for (const Face& face : all)
    if (area_vector(mesh.nodes, face).normalized().dot(normal) > 0.99)
      top.push_back(face), area += area_vector(mesh.nodes, face);
  REQUIRE(top.size() == 6);
  const auto push = [&](const std::vector<Face>& faces) {
    return Explicit{Scene{mesh.nodes, Part{Hex8{}, rubber, mesh.hexahedra}, Pressure{faces, triangle}},
                    ExplicitOptions{.largest_step = T / 200}};
  };

  auto pushed = push(top);
  double drift = 0;
  pushed.until(2 * T, [&] { drift = std::max(drift, std::abs(pushed.energy().error())); });
  const Eigen::Vector3d impulse = -p * T / 2 * area;
  CHECK((pushed.momentum() - impulse).norm() < 1e-4 * impulse.norm());  // as the face stretches
  CHECK(pushed.energy().external >= impulse.squaredNorm() / (2 * block_mass) * (1 - 1e-4));
  CHECK(pushed.energy().external < 1.1 * impulse.squaredNorm() / (2 * block_mass));  // and a little vibration
  CHECK(drift < 1e-3);

  auto squeezed = push(all);
  squeezed.until(2 * T);
  CHECK(squeezed.momentum().norm() < 1e-12 * impulse.norm());
}

TEST_CASE("a free body keeps momentum and angular momentum to rounding") {
  Mesh mesh = box({.size = {1, 1, 1}, .cells = {4, 4, 4}});
  Random random(2);
  for (auto& x : mesh.nodes) x += 0.05 * random_vector(random);
  Explicit run{Scene{mesh.nodes, Part{Hex8{}, rubber, mesh.hexahedra}, RandomVelocity{20}},
               ExplicitOptions{.energy_tolerance = 1}};  // strains of 20 % in a few steps
  const auto angular_momentum = [&] {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
      const Eigen::Vector3d x = run.nodes().x(i), v = run.nodes().v(i);
      sum += run.nodes().mass(i) * x.cross(v);
    }
    return sum;
  };
  const Eigen::Vector3d p = run.momentum(), l = angular_momentum();
  while (run.steps() < 2000) run.step();
  const double scale = 1000 * 20;  // sum of m |v|, and of m |x| |v|
  CHECK((run.momentum() - p).norm() < 1e-12 * scale);
  CHECK((angular_momentum() - l).norm() < 1e-12 * scale);
}

TEST_CASE("a block slides on a wall with friction until v0/(mu g)") {
  const Mesh mesh = box({.size = {0.1, 0.1, 0.05}});
  const double g = 10, mu = 0.25, v0 = 0.5;
  Explicit run{Scene{mesh.nodes, Part{Hex8{}, rubber, mesh.hexahedra}, InitialVelocity{{v0, 0, 0}},
                     BodyForce{{0, 0, -g}}, RigidWall{{0, 0, 0}, {0, 0, 1}, mu}}};
  const double stop = v0 / (mu * g), distance = v0 * v0 / (2 * mu * g), m = 0.1 * 0.1 * 0.05 * 1000;
  const auto centre = [&] {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const auto& x : run.positions()) sum += x / 8;
    return sum;
  };
  double worst = 0, drift = 0;
  run.until(2 * stop, [&] {
    const double t = std::min(run.time(), stop), moved = centre().x() - 0.05;
    worst = std::max(worst, std::abs(moved - (v0 * t - 0.5 * mu * g * t * t)));
    drift = std::max(drift, std::abs(run.energy().error()));
  });
  CHECK(worst < 0.01 * distance);
  CHECK(run.energy().friction == Approx(0.5 * m * v0 * v0).epsilon(0.01));
  CHECK(run.item<3>().impulse().x() == Approx(-m * v0).epsilon(0.01));
  CHECK(run.item<3>().impulse().z() == Approx(m * g * 2 * stop).epsilon(0.01));
  CHECK(drift < 1e-3);
}

TEST_CASE("on an incline a block stays below the angle of friction and slides above it") {
  const Mesh mesh = box({.size = {0.1, 0.1, 0.05}});
  const double g = 10, slope = 0.3, end = 0.4;
  const Eigen::Vector3d down = g * Eigen::Vector3d(std::sin(slope), 0, -std::cos(slope));
  const Curve gently{{{0, 0}, {0.1, 1}}};  // so that the block does not rock: its slowest vibration takes 0.8 ms
  const auto moved = [&](double mu) {
    Explicit run{Scene{mesh.nodes, Part{Hex8{}, rubber, mesh.hexahedra}, BodyForce{down, gently},
                       RigidWall{{0, 0, 0}, {0, 0, 1}, mu}}};
    run.until(end);
    return run.nodes().x(0).x();
  };
  CHECK(moved(1.2 * std::tan(slope)) == 0);  // not 1, for the corners uphill carry the least
  const double mu = 0.5 * std::tan(slope), a = g * (std::sin(slope) - mu * std::cos(slope));
  const double v_ramp = a * 0.1 / 2, x_ramp = a * 0.01 / 6, rest = end - 0.1;
  CHECK(moved(mu) == Approx(x_ramp + v_ramp * rest + 0.5 * a * rest * rest).epsilon(1e-3));
}
