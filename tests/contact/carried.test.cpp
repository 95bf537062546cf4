#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include <strike/contact/carried.hpp>
#include <strike/contact/contact.hpp>
#include <strike/contact/pairing.hpp>
#include <strike/contact/policies.hpp>
#include <strike/dynamics/explicit.hpp>
#include <strike/dynamics/stop_when.hpp>
#include <strike/element/hex8.hpp>
#include <strike/load/body_force.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/load/rigid_body.hpp>
#include <strike/load/support.hpp>
#include <strike/material/elastic.hpp>
#include <strike/mesh/box.hpp>
#include <strike/mesh/frame.hpp>
#include <strike/mesh/mixed_cells.hpp>
#include <strike/mesh/select.hpp>
#include <strike/mesh/surface.hpp>
#include <strike/mesh/transform.hpp>
#include <strike/motion/openmp.hpp>
#include <strike/output/checkpoint.hpp>

#include "output/scratch.hpp"
#include "support/catch.hpp"

using namespace strike;
using Eigen::Vector3d;

namespace {

const Eigen::Matrix3d tilted = Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
const std::vector<Vector3d> all_axes{unit(Axis::x), unit(Axis::y), unit(Axis::z)};

Inertia of_ball(double mass, const Vector3d& centre, double radius) {
  return {mass, centre, SymmetricTensor<double>::isotropic(0.4 * mass * radius * radius)};
}

/// A soft block of 0.1 x 0.1 x 0.06 at the origin, turned by Q and moved, and a ball above it.
struct BallOnBlock {
  Eigen::Matrix3d Q = Eigen::Matrix3d::Identity();
  Vector3d moved = Vector3d::Zero();
  Vector3d flight{0.5, 0.2, -5};      ///< of the ball relative to the block
  Vector3d drift = Vector3d::Zero();  ///< of both
  double step_factor = 0.9;

  static constexpr double radius = 0.02, mass = 0.1;

  std::vector<Vector3d> nodes() const {
    const Mesh block = box({.lower = {-0.05, -0.05, -0.06}, .size = {0.1, 0.1, 0.06}, .cells = {6, 6, 4}});
    std::vector<Vector3d> x;
    for (const Vector3d& X : block.nodes) x.push_back(Q * X + moved);
    return x;
  }
  template <class Law, class... Policies>
  auto run(const Law& law, const Policies&... policies) const {
    const Cells<8> cells = box({.lower = {0, 0, 0}, .size = {1, 1, 1}, .cells = {6, 6, 4}}).hexahedra;
    std::vector<Vector3d> x = nodes();
    std::vector<Index> block(x.size());
    for (Index i = 0; i < block.size(); ++i) block[i] = i;
    const Vector3d centre = Q * Vector3d(0.006, 0.004, radius + 1e-3) + moved;
    const Frame frame = add_frame(x, centre, 0.5 * radius);
    return Explicit{Scene{x, Part{Hex8{}, Elastic{1000, 1e7, 0.3}, cells}, InitialVelocity{Q * drift, block},
                          RigidBody{frame.nodes, of_ball(mass, centre, radius)}.moving(Q * (flight + drift)),
                          Contact{NodeToRigid{block, Carried{RigidSphere{centre, radius}, frame}}, law, Coulomb{0.3}}},
                    ExplicitOptions{.step_factor = step_factor}, policies...};
  }
};

template <class Run>
Vector3d momentum_about(const Run& run, const Vector3d& point) {
  Vector3d about = Vector3d::Zero();
  for (const RigidMotion& body : run.nodes().bodies())
    about += body.angular_momentum() + cross(Vector3d(body.centre() - point), body.momentum());
  // Velocities are half a step after the positions of which they are the change.
  for (std::size_t i = 0; i < run.nodes().size(); ++i)
    if (!run.nodes().is_rigid(i))
      about += cross(Vector3d(run.nodes().x(i) - point), Vector3d(run.nodes().mass(i) * run.nodes().v(i)));
  return about;
}

}  // namespace

TEST_CASE("a carried ball and the block that it strikes keep momentum, angular momentum and energy") {
  for (const bool springs : {false, true}) {
    BallOnBlock scene;
    scene.Q = tilted;
    const auto check = [&](auto run) {
      const Vector3d p = run.momentum(), about = momentum_about(run, Vector3d::Zero());
      run.until(2e-3);
      const RigidMotion& ball = run.nodes().bodies()[0];
      CHECK((run.momentum() - p).norm() < 1e-12);
      CHECK((momentum_about(run, Vector3d::Zero()) - about).norm() < 1e-12);
      CHECK(
          (BallOnBlock::mass * (ball.velocity() - tilted * scene.flight) + run.template contact<0>().impulse()).norm() <
          1e-12);
      CHECK(ball.angular_velocity().norm() > 5);
      CHECK((tilted.transpose() * ball.velocity()).z() > -2.5);
      CHECK(std::abs(run.energy().error()) < 3e-3);
    };
    if (springs)
      scene.step_factor = 0.45, check(scene.run(Penalty{.stiffness = 2e5}));
    else
      check(scene.run(Kinematic{}));
  }
}

TEST_CASE("a carried obstacle: turned, moved and flying scenes, threads and an interruption change nothing") {
  const BallOnBlock scene;
  auto run = scene.run(Kinematic{});
  run.until(1.5e-3);
  const std::vector<Vector3d> expected = run.positions();
  const auto apart = [&](const auto& other, const BallOnBlock& placed) {
    double most = 0;
    const std::vector<Vector3d> x = other.positions();
    for (std::size_t i = 0; i + 4 < x.size(); ++i)  // of the block: no scene turns the frame
      most = std::max(
          most, (placed.Q.transpose() * (x[i] - placed.moved) - placed.drift * other.time() - expected[i]).norm());
    return most;
  };
  BallOnBlock turned = scene, moved = scene, flying = scene;
  turned.Q = tilted, moved.moved = {3, -2, 7}, flying.drift = {40, -30, 20};
  for (const BallOnBlock& other : {turned, moved, flying}) {
    auto changed = other.run(Kinematic{});
    changed.until(1.5e-3);
    CHECK(apart(changed, other) < 1e-11);  // of a block of 0.1: rounding
  }
  auto threads = scene.run(Kinematic{}, OpenMP{3});
  threads.until(1.5e-3);
  CHECK(threads.positions() == expected);

  const ScratchFolder folder("carried");
  auto first = scene.run(Kinematic{});
  for (const double time : {0.2e-3, 0.7e-3, 1.1e-3}) {
    first.until(1.5e-3, StopWhen{[&] { return first.time() >= time; }});
    auto second = scene.run(Kinematic{});
    write_checkpoint(folder / "run", first), read_checkpoint(folder / "run", second);
    second.until(1.5e-3);
    CHECK(second.positions() == expected);
  }

  auto mixed = scene.run(Kinematic{}, in<Pack<float>, double>);
  mixed.until(1.5e-3);
  CHECK(apart(mixed, scene) < 1e-6);
}

TEST_CASE("a carried obstacle that is held is one at rest") {
  const Mesh block = box({.size = {1, 1, 1}, .cells = {3, 3, 3}});
  const auto run = [&](const auto& make, const auto& law) {
    std::vector<Vector3d> x;
    for (const Vector3d& X : block.nodes) x.push_back(tilted * X + Vector3d(0, 0, 0.6));
    std::vector<Index> nodes(x.size());
    for (Index i = 0; i < nodes.size(); ++i) nodes[i] = i;
    const Frame frame = add_frame(x, {0.1, 0.2, -5}, 0.3);
    Explicit made{Scene{x, Part{Hex8{}, Elastic{1, 100, 0.3}, block.hexahedra}, InitialVelocity{{0.1, 0, -1}, nodes},
                        RigidBody{frame.nodes, of_ball(3, {0.1, 0.2, -5}, 1), HeldBody{all_axes, all_axes}},
                        Contact{NodeToRigid{nodes, make(frame)}, law, Coulomb{0.2}}}};
    made.until(1.5);
    CHECK(made.energy().contact + made.energy().friction > 0.01);
    return made.positions();
  };
  const auto alike = [&](const auto& body, const auto& law) {
    const auto stands = run([&](const Frame&) { return body; }, law), carried = run(
                                                                          [&](const Frame& frame) {
                                                                            return Carried{body, frame};
                                                                          },
                                                                          law);
    double most = 0;
    for (std::size_t i = 0; i < stands.size(); ++i) most = std::max(most, (stands[i] - carried[i]).norm());
    CHECK(most < 1.5e-6);  // the laws miss at most 1e-6 of the approach, 1, for a time of 1.5
  };
  alike(RigidPlane{{0, 0, 0}, {0, 0, 1}}, Penalty{});
  alike(RigidSphere{{0.3, 0.3, -2}, 2}, Kinematic{});
  alike(RigidCylinder{{0.3, 0.3, -2}, {1, 0, 0}, 2, 0.8}, Kinematic{});
}

TEST_CASE("a wall of a mass that strikes a bar is stopped as Saint-Venant has it: v = v0 exp(-rho c A t/M)") {
  // Love, Elasticity (1927), section 281: until the wave comes back, after 2 L/c. nu = 0: no radial motion.
  const double rho = 1000, E = 1e9, c = std::sqrt(E / rho), area = 0.01, length = 2, v0 = 1;
  const double mass = 2 * rho * area * length / 4;
  const Mesh bar = box({.size = {0.1, 0.1, length}, .cells = {1, 1, 100}});
  std::vector<Vector3d> x = bar.nodes;
  const std::vector<Index> all = nodes_where(x, [](const Vector3d&) { return true; });
  const double gap = 1e-6;
  const Vector3d centre(0.05, 0.05, length + gap);
  const Frame frame = add_frame(x, centre, 0.1);
  Explicit run{Scene{
      x, Part{Hex8{}, Elastic{rho, E, 0}, bar.hexahedra},
      RigidBody{frame.nodes, of_ball(mass, centre, 0.1), HeldBody{{unit(Axis::x), unit(Axis::y)}, all_axes}}.moving(
          {0, 0, -v0}),
      Contact{NodeToRigid{all, Carried{RigidPlane{{0, 0, length + gap}, {0, 0, -1}}, frame}}}}};
  const Vector3d momentum = run.momentum();
  for (const double periods : {0.25, 0.5, 0.9}) {
    const double t = 2 * periods * length / c;
    run.until(gap / v0 + t);
    CHECK(-run.nodes().bodies()[0].velocity().z() == Approx(v0 * std::exp(-rho * c * area * t / mass)).epsilon(0.01));
  }
  CHECK((run.momentum() - momentum).norm() < 1e-12 * momentum.norm());
  CHECK(std::abs(run.energy().error()) < 1e-3);
}

TEST_CASE("a wall that is driven pushes as one at rest pushes what flies into it") {
  const Mesh block = box({.size = {1, 1, 1}, .cells = {3, 3, 3}});
  std::vector<Vector3d> x = block.nodes;
  std::vector<Index> nodes(x.size());
  for (Index i = 0; i < nodes.size(); ++i) nodes[i] = i;
  const Frame frame = add_frame(x, {0.5, 0.5, -1}, 0.3);
  const auto run = [&](double wall, double body, double mass) {
    Explicit made{
        Scene{x, Part{Hex8{}, Elastic{1, 100, 0.3}, block.hexahedra}, InitialVelocity{{0, 0, body}, nodes},
              RigidBody{frame.nodes, of_ball(mass, {0.5, 0.5, -1}, 0.3),
                        HeldBody{{unit(Axis::x), unit(Axis::y)}, all_axes}, BodyVelocity{Axis::z, Constant{wall}}},
              Contact{NodeToRigid{nodes, Carried{RigidPlane{{0, 0, -0.1}, {0.1, 0, 1}}, frame}}}}};
    made.until(0.3);
    std::vector<Vector3d> at = made.positions();
    for (Vector3d& p : at) p.z() -= wall * made.time();
    CHECK(std::abs(made.energy().error()) < 1e-3);
    CHECK(made.template contact<0>().impulse().z() > 0.5);
    return at;
  };
  const auto stands = run(0, -1, 1);
  for (const double mass : {1e-9, 1.0, 1e6}) {  // none of a body that is driven counts
    const auto driven = run(1, 0, mass);
    double most = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i) most = std::max(most, (stands[i] - driven[i]).norm());
    CHECK(most < 3e-7);  // the law misses at most 1e-6 of the approach, 1, for a time of 0.3
  }
}

TEST_CASE("a body of cells that is driven pushes the same whatever its density") {
  std::vector<Vector3d> expected;
  for (const double density : {1.0, 1e-9}) {
    Mesh two = box({.size = {1, 1, 1}, .cells = {3, 3, 3}});
    const std::size_t own = two.nodes.size(), cells = two.hexahedra.size();
    append(two, box({.lower = {-0.5, -0.5, -1.1}, .size = {2, 2, 1}, .cells = {2, 2, 1}}));
    const Cells<8> block(two.hexahedra.begin(), two.hexahedra.begin() + static_cast<std::ptrdiff_t>(cells)),
        pusher(two.hexahedra.begin() + static_cast<std::ptrdiff_t>(cells), two.hexahedra.end());
    Explicit run{Scene{two.nodes, Part{Hex8{}, Elastic{1, 100, 0.3}, block},
                       RigidBody{Mesh{two.nodes, pusher}, density, HeldBody{{unit(Axis::x), unit(Axis::y)}, all_axes},
                                 BodyVelocity{Axis::z, Constant{1}}},
                       Contact{TwoWay{Surface{hexahedron_surface(block)}, Surface{hexahedron_surface(pusher)}},
                               Penalty{.stiffness = 500}}}};
    run.until(0.5);
    CHECK(run.steps() < 200);  // no body that is driven bounds the step
    std::vector<Vector3d> x = run.positions();
    x.resize(own);
    CHECK(run.template contact<0>().impulse().z() > 0.5);
    if (expected.empty()) expected = x;
    double most = 0;
    for (std::size_t i = 0; i < own; ++i) most = std::max(most, (x[i] - expected[i]).norm());
    CHECK(most < 1e-9);
  }
}

TEST_CASE("a roller that spins draws a block along by mu g until it has the roller's velocity") {
  const double mu = 0.2, g = 10, radius = 50, w = 0.02;  // w r = 1
  const Mesh block = translated(box({.size = {1, 1, 1}, .cells = {2, 2, 2}}), {-0.5, -0.5, 0});
  std::vector<Vector3d> x = block.nodes;
  std::vector<Index> nodes(x.size());
  for (Index i = 0; i < nodes.size(); ++i) nodes[i] = i;
  const Frame frame = add_frame(x, {0, 0, -radius}, radius);
  Explicit run{Scene{
      x, Part{Hex8{}, Elastic{1, 1e4, 0.3}, block.hexahedra}, BodyForce{{0, 0, -g}},
      RigidBody{frame.nodes, of_ball(1, {0, 0, -radius}, radius), HeldBody{all_axes, {unit(Axis::x), unit(Axis::z)}},
                BodySpin{Axis::y, Constant{w}}},
      Contact{NodeToRigid{nodes, Carried{RigidCylinder{{0, 0, -radius}, {0, 1, 0}, radius}, frame}}, Coulomb{mu}}}};
  const auto velocity = [&] {
    Vector3d p = Vector3d::Zero();
    double m = 0;
    for (const Index i : nodes) p += run.nodes().mass(i) * run.nodes().v(i), m += run.nodes().mass(i);
    return Vector3d(p / m);
  };
  run.until(0.25);
  CHECK(velocity().x() == Approx(mu * g * 0.25).epsilon(0.02));  // it settles by its own elasticity meanwhile
  run.until(0.8);
  CHECK(velocity().x() == Approx(w * radius).epsilon(0.01));
  CHECK(std::abs(run.energy().error()) < 5e-3);
}

TEST_CASE("a frame that carries nothing is refused") {
  const Mesh block = box({.size = {1, 1, 1}});
  std::vector<Vector3d> x = block.nodes;
  const Frame frame = add_frame(x, {0, 0, -1}, 0.3);
  const auto run = [&](const Frame& of, const std::vector<Index>& body) {
    Explicit{Scene{x, Part{Hex8{}, Elastic{1, 100, 0.3}, block.hexahedra}, RigidBody{body, of_ball(1, {0, 0, -1}, 0.3)},
                   RigidBody{std::vector<Index>{11}, of_ball(1, x[11], 1)},
                   Contact{NodeToRigid{std::vector<Index>{0, 1, 8}, Carried{RigidSphere{{0, 0, -1}, 0.3}, of}}}}};
  };
  CHECK_THROWS_WITH(run(frame, {8, 9, 10}),
                    "strike: node 11 of the frame of a Carried obstacle does not belong to the RigidBody of its first "
                    "node; give one RigidBody all four.");
  CHECK_THROWS_WITH(run({{8, 9, 10, 0}}, {8, 9, 10}),
                    "strike: node 0 of the frame of a Carried obstacle does not belong to the RigidBody of its first "
                    "node; give one RigidBody all four.");
  CHECK_THROWS_WITH(run({{8, 9, 10}}, {8, 9, 10}),
                    "strike: the frame of a Carried obstacle has 3 nodes; give it four, such as those of add_frame.");
  CHECK_THROWS_WITH(run({{8, 9, 10, 8}}, {8, 9, 10}),
                    "strike: the frame of a Carried obstacle, nodes 8 to 8, lies in a plane; take nodes that span a "
                    "body, such as those of add_frame.");
}
