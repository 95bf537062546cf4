#include <cmath>
#include <numbers>
#include <type_traits>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include <strike/dynamics/explicit.hpp>
#include <strike/dynamics/global_step.hpp>
#include <strike/dynamics/subcycling.hpp>
#include <strike/element/hex8.hpp>
#include <strike/load/body_force.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/load/rigid_body.hpp>
#include <strike/load/support.hpp>
#include <strike/material/elastic.hpp>
#include <strike/mesh/box.hpp>
#include <strike/mesh/select.hpp>
#include <strike/mesh/surface.hpp>
#include <strike/mesh/transform.hpp>
#include <strike/motion/openmp.hpp>
#include <strike/output/checkpoint.hpp>

#include "output/scratch.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"

using namespace strike;
using Eigen::Vector3d;

namespace {

const Mesh brick = box({.lower = {-0.5, -0.3, -0.1}, .size = {1, 0.6, 0.2}, .cells = {1, 1, 1}});
const Eigen::Matrix3d tilted = Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).toRotationMatrix();

/// The rotation of a body without moments, I1 < I2 < I3, that begins with no rotation about its middle axis (Landau and
/// Lifshitz, Mechanics, 37, where L^2 > 2 E I2).
struct FreeRotation {
  double I1, I2, I3, w1, w3;

  double energy() const { return 0.5 * (I1 * w1 * w1 + I3 * w3 * w3); }
  double squared_momentum() const { return I1 * I1 * w1 * w1 + I3 * I3 * w3 * w3; }
  double rate() const { return std::sqrt((I3 - I2) * (squared_momentum() - 2 * energy() * I1) / (I1 * I2 * I3)); }
  double modulus() const {
    return std::sqrt((I2 - I1) * (2 * energy() * I3 - squared_momentum()) /
                     ((I3 - I2) * (squared_momentum() - 2 * energy() * I1)));
  }
  /// Of the rotation about the middle axis, which turns back after half of it.
  double period() const { return 4 * std::comp_ellint_1(modulus()) / rate(); }
};

}  // namespace

static_assert(std::is_same_v<decltype(RigidBody{Mesh{}, 2, 1}), RigidBody<>>);  // a thickness, not a guide

TEST_CASE("rigid body: a free one of three inertias keeps L to the bit and its energy to 1e-10 over 1e4 turns") {
  const Inertia own = inertia(brick, 12);
  RigidMotion body({}, {}, own);
  body.set({1, 2, 3}, {0.7, -1.1, 0.4});
  const Vector3d L = body.angular_momentum();
  const double energy = body.kinetic_energy(), dt = 0.2,
               turns = body.angular_velocity().norm() * dt / (2 * std::numbers::pi);
  double worst = 0;
  for (int step = 0; step * turns < testing::repeated(10000); ++step) {
    body.move(dt);
    worst = std::max(worst, std::abs(body.kinetic_energy() / energy - 1));
  }
  CHECK(body.angular_momentum() == L);
  CHECK(worst < 1e-10);
  CHECK((body.rotation().transpose() * body.rotation() - Eigen::Matrix3d::Identity()).norm() < 1e-14);
}

TEST_CASE("rigid body: about its middle axis one flips at the period of the elliptic integral, whatever the step") {
  const Inertia own = inertia(brick, 12);
  // Nearly about the middle axis: so little of the others that each half period is long.
  const FreeRotation exact{own.moment.xx, own.moment.yy, own.moment.zz, 0.6, 0.6};
  REQUIRE(exact.squared_momentum() > 2 * exact.energy() * exact.I2);
  for (const double dt : {0.05, 0.02}) {
    RigidMotion body({}, {}, own);
    body.set({0, 0, 0}, {exact.w1, 0, exact.w3});
    std::vector<double> flips;
    double before = 0;
    for (int step = 1; flips.size() < 20; ++step) {
      body.move(dt);
      const double now = body.rotation().col(1).dot(body.angular_velocity());
      if (before * now < 0) flips.push_back(dt * (step - now / (now - before)));
      before = now;
    }
    // Straight between two steps: an error of (w dt)^3, of one flip and not of their sum.
    CHECK(flips.back() / 20 == Approx(exact.period() / 2).epsilon(1e-5));
  }
}

namespace {

/// A brick that spins freely in a run, without elements.
template <class Numbers = Method<>, class... Policies>
auto spun(const Eigen::Matrix3d& Q, const Vector3d& shift, Policies... policies) {
  const Mesh mesh = transformed(brick, [&](const Vector3d& x) -> Vector3d { return Q * x + shift; });
  Explicit run{Scene{mesh.nodes, RigidBody{mesh, 12},
                     InitialVelocity{Q * Vector3d(1, 2, 3), Spin{Q * Vector3d(0.7, -1.1, 0.4), shift}}},
               ExplicitOptions{.largest_step = 0.01}, policies...};
  return run;
}

}  // namespace

TEST_CASE("rigid body: a run of one turns with the scene, keeps its shape, and its balance is exact") {
  auto here = spun(Eigen::Matrix3d::Identity(), Vector3d::Zero());
  auto there = spun(tilted, Vector3d(10, 20, -5));
  for (int step = 0; step < 2000; ++step) here.step(), there.step();
  double apart = 0, bent = 0;
  const auto x = here.positions(), y = there.positions();
  for (std::size_t i = 0; i < x.size(); ++i) {
    apart = std::max(apart, (tilted * x[i] + Vector3d(10, 20, -5) - y[i]).norm());
    bent = std::max(bent, std::abs((x[i] - x[0]).norm() - (brick.nodes[i] - brick.nodes[0]).norm()));
  }
  CHECK(apart < 1e-10);  // rounding at a distance of 80, over 2000 steps
  CHECK(bent < 1e-13);
  CHECK(std::abs(here.energy().error()) < 1e-12);
  CHECK((here.momentum() - 12 * 0.12 * Vector3d(1, 2, 3)).norm() < 1e-13);
  CHECK((here.nodes().bodies()[0].centre() - here.time() * Vector3d(1, 2, 3)).norm() < 1e-11);
}

TEST_CASE("rigid body: a pendulum that swings wide has the period of the elliptic integral") {
  const double g = 9.81, density = 12, start = 2.0;  // rad
  const Inertia own = inertia(brick, density);
  const Vector3d pivot(-0.4, 0, 0);  // from the centre of mass 0.4
  const double about = own.moment.zz + own.mass * 0.16;
  // Gravity along x turned by `start` in the plane of x and y.
  const Vector3d down(std::cos(start), std::sin(start), 0);
  Explicit run{Scene{brick.nodes, RigidBody{brick, density, PinnedBody{pivot}}, BodyForce{g * down}},
               ExplicitOptions{.largest_step = 1e-3}};
  double before = 0, turned_back = 0;
  double pull = 0;
  int returns = 0;
  while (returns < 2) {
    run.step();
    pull = std::max(pull, -run.item<0>().force().dot(down));
    const double now = run.nodes().bodies()[0].angular_velocity().z();
    if (before * now < 0) turned_back = run.time() - run.dt() / 2 - run.dt() * now / (now - before), ++returns;
    before = now;
    CHECK((run.nodes().bodies()[0].centre() - pivot).norm() == 0);
  }
  const double period = 4 * std::sqrt(about / (own.mass * g * 0.4)) * std::comp_ellint_1(std::sin(start / 2));
  // At the lowest point the pin carries the weight and turns the momentum: half a step late, w dt/2 = 2e-3.
  const double w2 = 2 * own.mass * g * 0.4 * (1 - std::cos(start)) / about;
  CHECK(pull == Approx(own.mass * (g + 0.4 * w2)).epsilon(5e-3));
  CHECK(turned_back == Approx(period).epsilon(1e-6));  // second order in w dt = 3e-3
  CHECK(std::abs(run.energy().error()) < 1e-6);
}

TEST_CASE("rigid body: what is told how to turn does so to the bit of its history, and its work is external") {
  const auto angle = [](double t) { return 0.5 * t * t; };
  Explicit run{
      Scene{brick.nodes, RigidBody{brick, 12, HeldBody{{}, {unit(Axis::x), unit(Axis::y)}}, BodyAngle{Axis::z, angle},
                                   BodyDisplacement{Vector3d(1, 1, 0), [](double t) { return t * t; }}}},
      ExplicitOptions{.largest_step = 1e-3}};
  run.until(2);
  const double c = std::cos(2.0), s = std::sin(2.0);
  double off = 0;
  const Vector3d shift = 4 * Vector3d(1, 1, 0).normalized();
  for (std::size_t i = 0; i < brick.nodes.size(); ++i) {
    const Vector3d X = brick.nodes[i];
    off = std::max(off,
                   (run.positions()[i] - shift - Vector3d(c * X.x() - s * X.y(), s * X.x() + c * X.y(), X.z())).norm());
  }
  CHECK(off < 1e-11);  // 2000 steps of rounding
  const Inertia own = inertia(brick, 12);
  // v = 4, w = 2 at the end
  CHECK(run.energy().external == Approx(0.5 * own.mass * 16 + 0.5 * own.moment.zz * 4).epsilon(2e-3));
  CHECK(std::abs(run.energy().error()) < 1e-9);
  CHECK(run.template item<0>().moment().z() == Approx(own.moment.zz).epsilon(1e-9));
}

TEST_CASE("rigid body: a mass on the end of a bar slows as exp(-rho c A t/M)") {
  // No lateral strain: nu = 0, c = sqrt(E/rho).
  const double E = 1e6, rho = 1000, c = std::sqrt(E / rho), v0 = 0.1, M_over_A = 2000;
  const Mesh mesh = box({.size = {0.1, 0.1, 10}, .cells = {1, 1, 200}});
  Cells<8> bar, block;
  for (const auto& cell : mesh.hexahedra) (mesh.nodes[cell[0]].z() > 9.5 - 1e-9 ? block : bar).push_back(cell);
  const std::vector<Index> ends = nodes_where(mesh.nodes, [](const Vector3d& x) { return x.z() > 9.5 - 1e-9; });
  Explicit run{Scene{mesh.nodes, Part{Hex8{}, Elastic{rho, E, 0}, bar},
                     RigidBody{Mesh{mesh.nodes, block}, M_over_A / 0.5}, InitialVelocity{{0, 0, -v0}, ends}}};
  const double until = 0.8 * 9.5 / c;  // before the wave is back
  run.until(until);
  // The end moves with the velocity of the wave; the mass of half a cell moves with the body.
  const double rate = rho * c / (M_over_A + 0.5 * 0.05 * rho);
  CHECK(run.nodes().bodies()[0].velocity().z() == Approx(-v0 * std::exp(-rate * until)).margin(1e-3 * v0));
  CHECK(std::abs(run.energy().error()) < 5e-4);
  CHECK((run.momentum() - Vector3d(0, 0, -v0 * (M_over_A + 0.5 * 0.05 * rho) * 0.01)).norm() < 1e-12);
}

TEST_CASE("rigid body: a block that carries an elastic one moves and turns as the block in stiff elements") {
  const Mesh mesh = box({.size = {1, 0.4, 0.3}, .cells = {8, 3, 3}});
  Cells<8> soft, stiff;
  for (const auto& cell : mesh.hexahedra) (mesh.nodes[cell[0]].x() > 0.5 - 1e-9 ? stiff : soft).push_back(cell);
  const auto spin = InitialVelocity{{0, 0, 0}, Spin{{3, 2, 5}, {0.4, 0.2, 0.1}}};
  const Part bar{Hex8{}, Elastic{1000, 1e6, 0.3}, soft};
  Explicit rigid{Scene{mesh.nodes, bar, RigidBody{Mesh{mesh.nodes, stiff}, 1000}, spin}};
  Explicit elastic{Scene{mesh.nodes, bar, Part{Hex8{}, Elastic{1000, 1e8, 0.3}, stiff}, spin}};
  rigid.until(0.1), elastic.until(0.1);
  double apart = 0, moved = 0;
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    apart = std::max(apart, (rigid.positions()[i] - elastic.positions()[i]).norm());
    moved = std::max(moved, (rigid.positions()[i] - mesh.nodes[i]).norm());
  }
  CHECK(apart < 0.02 * moved);  // lumped masses of the stiff block: its inertia is larger by the square of its cells
  CHECK(std::abs(rigid.energy().error()) < 1e-3);
}

namespace {

/// A soft bar between two blocks that spins and stretches.
template <class... Policies>
auto dumbbell(Policies... policies) {
  const Mesh mesh = box({.size = {1, 0.2, 0.2}, .cells = {10, 2, 2}});
  Cells<8> bar, left, right;
  for (const auto& cell : mesh.hexahedra) {
    const double x = mesh.nodes[cell[0]].x();
    (x < 0.25 ? left : x > 0.65 ? right : bar).push_back(cell);
  }
  return Explicit{Scene{mesh.nodes, Part{Hex8{}, Elastic{1000, 1e6, 0.3}, bar}, RigidBody{Mesh{mesh.nodes, left}, 2000},
                        RigidBody{Mesh{mesh.nodes, right}, 3000, HeldBody{{unit(Axis::z)}, {unit(Axis::x)}}},
                        InitialVelocity{{0, 0, 0}, Spin{{0, 0, 6}, {0.5, 0.1, 0.1}}}},
                  ExplicitOptions{}, policies...};
}
template <class Run>
double apart(const Run& one, const auto& other) {
  double most = 0;
  for (std::size_t i = 0; i < one.nodes().size(); ++i)
    most = std::max(most, (one.positions()[i] - other.positions()[i]).norm());
  return most;
}

}  // namespace

TEST_CASE("rigid body: with every policy of a run the same motion, and the bits of one thread") {
  auto plain = dumbbell();
  plain.until(0.05);
  CHECK(std::abs(plain.energy().error()) < 1e-3);
  auto threads = dumbbell(OpenMP{3});
  threads.until(0.05);
  CHECK(threads.positions() == plain.positions());
  auto bound = dumbbell(GlobalStep{});
  bound.until(0.05);
  CHECK(apart(bound, plain) < 1e-3);  // longer steps
  CHECK(bound.steps() < plain.steps());
  auto subcycled = dumbbell(Subcycling{});
  subcycled.until(0.05);
  CHECK(apart(subcycled, plain) < 1e-3);
  auto mixed = dumbbell(in<Pack<float>, double>);
  mixed.until(0.05);
  CHECK(apart(mixed, plain) < 1e-5);  // numbers of seven digits
  auto single = dumbbell(in<Pack<float>>);
  single.until(0.05);
  CHECK(apart(single, plain) < 1e-3);
  CHECK(single.nodes().bodies()[1].angular_momentum().allFinite());

  const ScratchFolder folder("rigid_body");
  auto half = dumbbell(), other = dumbbell();
  half.until(0.02);
  write_checkpoint(folder / "half", half);
  read_checkpoint(folder / "half", other);
  other.until(0.05), half.until(0.05);
  CHECK(other.positions() == half.positions());
  CHECK(other.nodes().bodies()[0].angular_momentum() == half.nodes().bodies()[0].angular_momentum());
}

TEST_CASE("rigid body: the balance of several does not know their order in the scene") {
  const Mesh mesh = box({.size = {1, 0.2, 0.2}, .cells = {10, 2, 2}});
  Cells<8> bar, left, right;
  for (const auto& cell : mesh.hexahedra) {
    const double x = mesh.nodes[cell[0]].x();
    (x < 0.25 ? left : x > 0.65 ? right : bar).push_back(cell);
  }
  const Part soft{Hex8{}, Elastic{1000, 1e6, 0.3}, bar};
  const RigidBody one{Mesh{mesh.nodes, left}, 2000}, other{Mesh{mesh.nodes, right}, 3000};
  const InitialVelocity flight{{0, 0, 0}, Spin{{0, 0, 6}, {0.5, 0.1, 0.1}}};
  Explicit here{Scene{mesh.nodes, soft, one, other, flight}}, there{Scene{mesh.nodes, soft, other, one, flight}};
  for (int step = 0; step < 50; ++step) {
    here.step(), there.step();
    CHECK(here.energy().kinetic == Approx(there.energy().kinetic).epsilon(1e-12));
  }
}

TEST_CASE("rigid body: what it cannot be is refused in a sentence") {
  const auto refusal = [](auto&&... items) -> std::string {
    try {
      Explicit run{Scene{brick.nodes, items...}, ExplicitOptions{.largest_step = 1e-3}};
      run.step();
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  const RigidBody body{brick, 12};
  using Catch::Matchers::ContainsSubstring;
  CHECK_THAT(refusal(body, Pinned{{3}}),
             ContainsSubstring("node 3 of the rigid body 0") && ContainsSubstring("RigidBody"));
  CHECK_THAT(refusal(body, RigidBody{std::vector<Index>{3, 4}}),
             ContainsSubstring("node 3 belongs to the rigid bodies 0 and 1"));
  CHECK_THAT(refusal(body, InitialVelocity{{1, 0, 0}, {3}}),
             ContainsSubstring("give all its nodes one InitialVelocity"));
  CHECK_THAT(refusal(RigidBody{std::vector<Index>{}}), ContainsSubstring("has no nodes"));
  CHECK_THAT(refusal(RigidBody{std::vector<Index>{99}}), ContainsSubstring("99"));
  CHECK_THAT(refusal(RigidBody{brick, 12, HeldBody{{unit(Axis::x)}}, BodyVelocity{Axis::x, Constant{}}}),
             ContainsSubstring("is told twice how to move along"));
  CHECK_THAT(refusal(RigidBody{std::vector<Index>{0, 1, 2, 3}}), ContainsSubstring("has no mass"));
  CHECK_THROWS_WITH((RigidBody{brick, -1.0}), ContainsSubstring("the density of a rigid body is -1"));
  CHECK_THROWS_WITH((RigidBody{Mesh{brick.nodes}, 1.0}), ContainsSubstring("give it cells"));
}
