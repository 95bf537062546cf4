#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include <strike/contact/contact.hpp>
#include <strike/contact/pairing.hpp>
#include <strike/contact/policies.hpp>
#include <strike/contact/rigid_wall.hpp>
#include <strike/dynamics/explicit.hpp>
#include <strike/element/hex8.hpp>
#include <strike/load/body_force.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/load/rigid_body.hpp>
#include <strike/load/support.hpp>
#include <strike/material/elastic.hpp>
#include <strike/mesh/box.hpp>
#include <strike/mesh/cylinder.hpp>
#include <strike/mesh/mixed_cells.hpp>
#include <strike/mesh/select.hpp>
#include <strike/mesh/sphere.hpp>
#include <strike/mesh/surface.hpp>
#include <strike/mesh/transform.hpp>
#include <strike/motion/openmp.hpp>

#include "support/catch.hpp"

using namespace strike;
using Eigen::Vector3d;

namespace {

const Eigen::Matrix3d tilted = Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).toRotationMatrix();

/// Two meshes of hexahedra with their nodes in one list.
struct Two {
  std::vector<Vector3d> nodes;
  Cells<8> first, second;

  Two(const Mesh& a, const Mesh& b) : nodes(a.nodes), first(a.hexahedra), second(b.hexahedra) {
    for (auto& cell : second)
      for (Index& i : cell) i += static_cast<Index>(nodes.size());
    nodes.insert(nodes.end(), b.nodes.begin(), b.nodes.end());
  }
  std::vector<Index> nodes_of(const Cells<8>& cells) const {
    std::vector<Index> all;
    for (const auto& cell : cells) all.insert(all.end(), cell.begin(), cell.end());
    return detail::ascending(std::move(all));
  }
};

template <class M>
Vector3d velocity_of(const M& run, std::size_t b) {
  return run.nodes().bodies()[b].velocity();
}

}  // namespace

TEST_CASE("rigid bodies that meet: one velocity after Kinematic contact, exchanged ones after Penalty") {
  // A cube of mass 1 at 2 m/s strikes one of mass 3, face to face, turned and shifted sideways by .1 of its width.
  const auto run = [](const auto& law, double sideways, const Eigen::Matrix3d& Q) {
    Two cubes{box({.size = {1, 1, 1}, .cells = {2, 2, 2}}),
              box({.lower = {sideways, -sideways / 2, 1.01}, .size = {1, 1, 1}, .cells = {3, 3, 3}})};
    for (auto& x : cubes.nodes) x = Q * x;
    const Surface below(hexahedron_surface(cubes.first)), above(hexahedron_surface(cubes.second));
    Explicit made{
        Scene{cubes.nodes, RigidBody{Mesh{cubes.nodes, cubes.first}, 3}, RigidBody{Mesh{cubes.nodes, cubes.second}, 1},
              InitialVelocity{Q * Vector3d(0, 0, -2), cubes.nodes_of(cubes.second)},
              Contact{TwoWay{below, above}, law}},
        ExplicitOptions{.largest_step = 1e-4}};
    made.until(0.02);
    return made;
  };
  for (const Eigen::Matrix3d& Q : {Eigen::Matrix3d::Identity().eval(), tilted}) {
    auto stuck = run(Kinematic{}, 0.0, Q);
    CHECK((velocity_of(stuck, 0) - Q * Vector3d(0, 0, -0.5)).norm() < 1e-6);
    CHECK((velocity_of(stuck, 1) - Q * Vector3d(0, 0, -0.5)).norm() < 1e-6);
    CHECK(stuck.energy().contact == Approx(0.5 * 0.75 * 4).epsilon(1e-6));  // m1 m2/(m1 + m2) v^2/2
    CHECK(std::abs(stuck.energy().error()) < 1e-9);
    auto back = run(Penalty{.stiffness = 1e5}, 0.0, Q);
    CHECK((velocity_of(back, 0) - Q * Vector3d(0, 0, -1)).norm() < 1e-3);
    CHECK((velocity_of(back, 1) - Q * Vector3d(0, 0, 1)).norm() < 1e-3);
    CHECK(std::abs(back.energy().error()) < 1e-3);
  }
  // Off centre: momentum and angular momentum about the origin are kept.
  auto aside = run(Penalty{.stiffness = 1e5}, 0.4, tilted);
  Vector3d momentum = Vector3d::Zero(), about = momentum;
  for (const RigidMotion& body : aside.nodes().bodies()) {
    momentum += body.momentum();
    about += body.angular_momentum() + cross(body.centre(), body.momentum());
  }
  CHECK((momentum - tilted * Vector3d(0, 0, -2)).norm() < 1e-12);
  CHECK((about - tilted * cross(Vector3d(0.9, 0.3, 1.51), Vector3d(0, 0, -2))).norm() < 1e-10);
  CHECK(aside.nodes().bodies()[1].angular_velocity().norm() > 0.1);
  CHECK(std::abs(aside.energy().error()) < 1e-3);
}

TEST_CASE("a rigid brick that lands flat on a wall stays flat, whatever the scene's angle, and rests with its weight") {
  for (const Eigen::Matrix3d& Q : {Eigen::Matrix3d::Identity().eval(), tilted}) {
    const Mesh brick = transformed(box({.lower = {-1, -0.5, 0.001}, .size = {2, 1, 0.5}, .cells = {4, 2, 1}}),
                                   [&](const Vector3d& x) -> Vector3d { return Q * x; });
    Explicit run{Scene{brick.nodes, RigidBody{brick, 1000}, InitialVelocity{Q * Vector3d(0, 0, -1)},
                       BodyForce{Q * Vector3d(0, 0, -10)}, RigidWall{Vector3d::Zero(), Q * Vector3d(0, 0, 1), 0.3}},
                 ExplicitOptions{.largest_step = 1e-4}};
    run.until(0.1);
    const RigidMotion& body = run.nodes().bodies()[0];
    CHECK(body.angular_velocity().norm() < 1e-9);
    CHECK(body.velocity().norm() < 1e-9);
    CHECK((body.centre() - Q * Vector3d(0, 0, 0.25)).norm() < 1e-9);
    CHECK((run.template contact<0>().force() - Q * Vector3d(0, 0, 1e4)).norm() < 1e-3);
    CHECK(std::abs(run.energy().error()) < 1e-9);
  }
}

TEST_CASE("a rigid roller that slides begins to roll at 2/3 of its velocity, after v/(3 mu g)") {
  // A cylinder of 96 sides, J = m r^2/2: rolls when w r = v, v = 2 v0/3.
  const double g = 10, mu = 0.2, v0 = 1.5, r = 1;
  Mesh roller = cylinder({.radius = r, .length = 0.5, .cells = 12, .layers = 1, .sector = Sector::full});
  roller = transformed(roller, [&](const Vector3d& x) -> Vector3d { return {x.x(), x.z(), x.y() + r}; });
  for (auto& cell : roller.hexahedra)
    for (std::size_t k = 0; k < 4; ++k) std::swap(cell[k], cell[k + 4]);
  const Inertia own = inertia(roller, 10);
  Explicit run{Scene{roller.nodes, RigidBody{roller, 10}, InitialVelocity{{v0, 0, 0}}, BodyForce{{0, 0, -g}},
                     RigidWall{{0, 0, own.centre.z() - r}, {0, 0, 1}, mu}},
               ExplicitOptions{.largest_step = 2e-4}};
  run.until(v0 / (3 * mu * g) * 1.2);
  const RigidMotion& body = run.nodes().bodies()[0];
  CHECK(body.velocity().x() == Approx(2 * v0 / 3).epsilon(0.02));  // 48 corners, over each of which it tips
  CHECK(body.angular_velocity().y() * r == Approx(body.velocity().x()).epsilon(0.02));
  CHECK(std::abs(body.velocity().y()) < 1e-9);
  CHECK(std::abs(run.energy().error()) < 1e-3);
}

namespace {

/// A block that is clamped below, and a ball above it.
struct BallOnBlock {
  Two scene{box({.lower = {-0.05, -0.05, -0.04}, .size = {0.1, 0.1, 0.04}, .cells = {8, 8, 3}}),
            translated(sphere({.radius = 0.02, .cells = 4}), {0.001, 0.002, 0.0205})};
  std::vector<Index> ball = scene.nodes_of(scene.second);
  Surface top{hexahedron_surface(scene.first)}, skin{hexahedron_surface(scene.second)};
  Clamped clamped{nodes_where(scene.nodes, [](const Vector3d& x) { return x.z() < -0.0399; })};
  Part<Hex8<>, Elastic, 8> block{Hex8{}, Elastic{1000, 1e7, 0.3}, scene.first};
  InitialVelocity flight{{0.5, 0, -5}, ball};
  Mesh body{scene.nodes, scene.second};

  template <class Law, class... Policies>
  auto rigid(const Law& law, double step_factor, const Policies&... policies) const {
    return Explicit{Scene{scene.nodes, block, clamped, RigidBody{body, 2000}, flight,
                          Contact{TwoWay{top, skin}, law, Coulomb{0.2}}},
                    ExplicitOptions{.step_factor = step_factor}, policies...};
  }
};

}  // namespace

TEST_CASE("a rigid ball on an elastic block moves as the same ball in stiff elements") {
  const BallOnBlock all;
  auto rigid = all.rigid(Kinematic{}, 0.9);
  Explicit elastic{Scene{all.scene.nodes, all.block, all.clamped,
                         Part{Hex8{}, Elastic{2000, 1e9, 0.3}, all.scene.second}, all.flight,
                         Contact{TwoWay{all.top, all.skin}, Kinematic{}, Coulomb{0.2}}}};
  const double mass = rigid.nodes().bodies()[0].mass();
  for (const double time : {0.7e-3, 1.3e-3, 1.7e-3}) {
    rigid.until(time), elastic.until(time);
    Vector3d momentum = Vector3d::Zero();
    for (const Index i : all.ball) momentum += elastic.nodes().mass(i) * elastic.nodes().v(i);
    CHECK((velocity_of(rigid, 0) - momentum / mass).norm() < 0.03 * 5);  // E 100 times that of the block, and its waves
  }
  CHECK(velocity_of(rigid, 0).z() > 3);
  CHECK(std::abs(rigid.energy().error()) < 2e-3);
  // The impulse on the block is what the ball has lost.
  CHECK((mass * (velocity_of(rigid, 0) - Vector3d(0.5, 0, -5)) + rigid.contact<0>().impulse()).norm() < 1e-12);

  auto springs = all.rigid(Penalty{.stiffness = 2e5}, 0.45);
  springs.until(1.7e-3);
  CHECK(velocity_of(springs, 0).z() > 3);
  CHECK(std::abs(springs.energy().error()) < 1e-3);  // -2.9e-3 with twice the step, near the limit of the springs
  CHECK((mass * (velocity_of(springs, 0) - Vector3d(0.5, 0, -5)) + springs.contact<0>().impulse()).norm() < 1e-12);
}

TEST_CASE("Everything finds rigid bodies too: the same pairs as by their surfaces") {
  const BallOnBlock all;
  auto pairs = all.rigid(Kinematic{}, 0.9);
  Explicit everything{Scene{all.scene.nodes, all.block, all.clamped, RigidBody{all.body, 2000}, all.flight,
                            Contact{Everything{}, Kinematic{}, Coulomb{0.2}}}};
  pairs.until(1e-3), everything.until(1e-3);
  CHECK(velocity_of(everything, 0).z() == Approx(velocity_of(pairs, 0).z()).epsilon(0.02));  // edges on edges too
  CHECK(std::abs(everything.energy().error()) < 2e-3);
}

TEST_CASE("contact of rigid bodies: threads change no bit") {
  const BallOnBlock all;
  auto one = all.rigid(Kinematic{}, 0.9);
  auto spring = all.rigid(Penalty{}, 0.9);
  auto threads = all.rigid(Kinematic{}, 0.9, OpenMP{3});
  auto springs = all.rigid(Penalty{}, 0.9, OpenMP{3});
  one.until(1e-3), threads.until(1e-3), spring.until(1e-3), springs.until(1e-3);
  CHECK(one.positions() == threads.positions());
  CHECK(spring.positions() == springs.positions());
}

TEST_CASE("a rigid punch that is driven into a block exerts what its guide does, and its work is external") {
  const BallOnBlock all;
  const auto down = [](double t) { return -4.0 * t; };
  Explicit run{Scene{
      all.scene.nodes, all.block, all.clamped,
      RigidBody{all.body, 2000, HeldBody{{unit(Axis::x), unit(Axis::y)}, {unit(Axis::x), unit(Axis::y), unit(Axis::z)}},
                BodyDisplacement{Axis::z, down}},
      Contact{TwoWay{all.top, all.skin}, Kinematic{}}}};
  run.until(1e-3);
  const RigidMotion& body = run.nodes().bodies()[0];
  CHECK(body.centre().z() == Approx(inertia(all.body, 2000).centre.z() - 4e-3).epsilon(1e-12));
  CHECK(body.angular_velocity().norm() < 1e-12);
  CHECK(body.velocity().z() == Approx(-4).epsilon(1e-12));
  // It moves uniformly: contact and guide hold the balance.
  CHECK((run.item<2>().force() - run.contact<0>().force()).norm() < 1e-6 * run.contact<0>().force().norm());
  CHECK(run.contact<0>().force().z() < -100);
  CHECK(run.energy().external > 0.1);
  CHECK(std::abs(run.energy().error()) < 2e-3);
}
