// Rigid bodies whose inertia is not that of their cells, and that carry more nodes than these have.
#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include <strike/dynamics/explicit.hpp>
#include <strike/element/hex8.hpp>
#include <strike/element/plate4.hpp>
#include <strike/load/body_force.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/load/nodal_force.hpp>
#include <strike/load/rigid_body.hpp>
#include <strike/material/elastic.hpp>
#include <strike/material/plane_stress.hpp>
#include <strike/mesh/box.hpp>
#include <strike/mesh/select.hpp>
#include <strike/mesh/sheet.hpp>
#include <strike/output/checkpoint.hpp>
#include <strike/section/layered.hpp>

#include "output/scratch.hpp"
#include "support/catch.hpp"

using namespace strike;
using Eigen::Vector3d;

namespace {

const Mesh brick = box({.lower = {-0.5, -0.3, -0.1}, .size = {1, 0.6, 0.2}, .cells = {1, 1, 1}});
const Eigen::Matrix3d tilted = Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
const ExplicitOptions steps{.largest_step = 1e-3};
/// Its centre of mass is far outside the brick.
const Inertia outside{2, {3, 1, -2}, {0.5, 0.7, 0.9, 0.05, -0.1, 0.02}};
const Vector3d g(0.3, -9, 2), v0(1, 2, 3), w0(0.7, -1.1, 0.4);

Inertia turned(const Inertia& own, const Eigen::Matrix3d& Q) {
  const auto& J = own.moment;
  Eigen::Matrix3d A;
  A << J.xx, J.xy, J.zx, J.xy, J.yy, J.yz, J.zx, J.yz, J.zz;
  const Eigen::Matrix3d B = Q * A * Q.transpose();
  return {own.mass, Q * own.centre, {B(0, 0), B(1, 1), B(2, 2), B(0, 1), B(1, 2), B(2, 0)}};
}
Mesh turned(Mesh mesh, const Eigen::Matrix3d& Q) {
  for (Vector3d& x : mesh.nodes) x = Q * x;
  return mesh;
}
/// A brick with that inertia under gravity.
auto thrown(const Eigen::Matrix3d& Q = Eigen::Matrix3d::Identity()) {
  return Explicit{Scene{turned(brick, Q).nodes, RigidBody{turned(brick, Q), turned(outside, Q)}.moving(Q * v0, Q * w0),
                        BodyForce{Q * g}},
                  steps};
}

}  // namespace

TEST_CASE("rigid body: one whose centre of mass lies outside its nodes is thrown along a parabola and spins freely") {
  auto run = thrown();
  const Vector3d L = run.nodes().bodies()[0].angular_momentum();
  double balance = 0;
  for (int step = 0; step < 2000; ++step) {
    run.step();
    balance = std::max(balance, std::abs(run.energy().error()));
  }
  const RigidMotion& body = run.nodes().bodies()[0];
  const double t = run.time();
  CHECK((body.centre() - (outside.centre + t * v0 + 0.5 * t * t * g)).norm() < 1e-11);  // exact by equal steps
  CHECK((body.angular_momentum() - L).norm() < 1e-12);  // gravity has no moment about the centre of mass
  CHECK(body.rotation().trace() < 2.5);                 // it has turned
  // Works of the weights of eight nodes and of what they lack, rounding of 20 m of fall.
  CHECK(balance < 1e-12);
  const Vector3d before = v0 + (t - run.dt()) * g;  // energies are known one step back
  CHECK(run.energy().external == Approx(before.squaredNorm() - v0.squaredNorm()).epsilon(1e-6));
  CHECK((run.momentum() - 2 * (v0 + (t - 0.5 * run.dt()) * g)).norm() < 1e-10);
}

TEST_CASE("rigid body: one with an inertia of its own turns with the scene") {
  auto here = thrown(), there = thrown(tilted);
  here.until(1), there.until(1);
  double apart = 0;
  for (std::size_t i = 0; i < brick.nodes.size(); ++i)
    apart = std::max(apart, (tilted * here.positions()[i] - there.positions()[i]).norm());
  CHECK(apart < 1e-11);
}

TEST_CASE("rigid body: a pendulum whose weight hangs outside its nodes has the period of the elliptic integral") {
  const double start = 2.0, weight = 9.81;  // rad
  const Inertia own{1.5, {1, 0, 0}, {0.2, 0.3, 0.4, 0, 0, 0}};
  const Vector3d pivot(-0.4, 0, 0), down(std::cos(start), std::sin(start), 0);
  Explicit run{Scene{brick.nodes, RigidBody{brick, own, PinnedBody{pivot}}, BodyForce{weight * down}}, steps};
  const double arm = 1.4, about = 0.4 + 1.5 * arm * arm;
  double before = 0, turned_back = 0, pull = 0, balance = 0;
  for (int returns = 0; returns < 2;) {
    run.step();
    pull = std::max(pull, -run.item<0>().force().dot(down));
    balance = std::max(balance, std::abs(run.energy().imbalance()));
    const double now = run.nodes().bodies()[0].angular_velocity().z();
    if (before * now < 0) turned_back = run.time() - run.dt() / 2 - run.dt() * now / (now - before), ++returns;
    before = now;
  }
  const double period = 4 * std::sqrt(about / (1.5 * weight * arm)) * std::comp_ellint_1(std::sin(start / 2));
  CHECK(turned_back == Approx(period).epsilon(1e-6));  // second order in w dt = 3e-3
  const double w2 = 2 * 1.5 * weight * arm * (1 - std::cos(start)) / about;
  CHECK(pull == Approx(1.5 * (weight + arm * w2)).epsilon(5e-3));  // half a step late, w dt/2 = 2e-3
  CHECK(balance < 1e-6 * 1.5 * weight * arm * (1 - std::cos(start)));
}

namespace {

/// A soft bar that a block at its end carries.
struct Carried {
  Mesh mesh = box({.size = {1, 0.2, 0.2}, .cells = {10, 2, 2}});
  Cells<8> bar, block;
  std::vector<Index> held, next;  // nodes of the block, and of the layer of the bar behind it

  Carried() {
    for (const auto& cell : mesh.hexahedra) (mesh.nodes[cell[0]].x() > 0.75 ? block : bar).push_back(cell);
    held = nodes_where(mesh.nodes, [](const Vector3d& x) { return x.x() > 0.75; });
    next = nodes_where(mesh.nodes, [](const Vector3d& x) { return x.x() > 0.65 && x.x() < 0.75; });
  }
  Mesh cells() const { return {mesh.nodes, block}; }
  template <class Body>
  auto run(const Body& body) const {
    return Explicit{Scene{mesh.nodes, Part{Hex8{}, Elastic{1000, 1e6, 0.3}, bar}, body, BodyForce{g},
                          InitialVelocity{v0, Spin{{3, 2, 5}, {0.4, 0.1, 0.1}}}}};
  }
};
double apart(const auto& one, const auto& other) {
  double most = 0;
  for (std::size_t i = 0; i < one.nodes().size(); ++i)
    most = std::max(most, (one.positions()[i] - other.positions()[i]).norm());
  return most;
}

}  // namespace

TEST_CASE("rigid body: the inertia of its cells, given in numbers, is that of their density") {
  const Carried all;
  auto by_density = all.run(RigidBody{all.cells(), 3000});
  auto by_numbers = all.run(RigidBody{all.cells(), inertia(all.cells(), 3000)});
  by_density.until(0.05), by_numbers.until(0.05);
  CHECK(apart(by_density, by_numbers) < 1e-12);
  CHECK(std::abs(by_numbers.energy().error()) < 1e-3);
}

TEST_CASE("rigid body: more nodes move with the cells, and what hangs on them counts in its inertia") {
  const Carried all;
  std::vector<Index> both = all.held;
  both.insert(both.end(), all.next.begin(), all.next.end());
  auto by_cells = all.run(RigidBody{all.cells(), 3000}.with_nodes(all.next).with_nodes({all.next[0], all.held[0]}));
  auto by_nodes = all.run(RigidBody{both, inertia(all.cells(), 3000)});
  CHECK(by_cells.nodes().bodies()[0].mass() == Approx(by_nodes.nodes().bodies()[0].mass()).epsilon(1e-13));
  by_cells.until(0.05), by_nodes.until(0.05);
  CHECK(apart(by_cells, by_nodes) < 1e-10);  // shares of the mass differ, which do not count
  CHECK(std::abs(by_cells.energy().error()) < 1e-3);
  for (const Index i : all.next) {
    const double now = (by_cells.positions()[i] - by_cells.positions()[all.held[0]]).norm();
    CHECK(now == Approx((all.mesh.nodes[i] - all.mesh.nodes[all.held[0]]).norm()).epsilon(1e-13));
  }
}

TEST_CASE("rigid body: nodes without elements ride along and weigh nothing") {
  std::vector<Vector3d> nodes = brick.nodes;
  nodes.push_back({7, 0, 0}), nodes.push_back({0, -4, 1});
  const Mesh mesh{nodes, brick.hexahedra};
  const Inertia own = inertia(mesh, 12);
  Explicit run{
      Scene{nodes, RigidBody{mesh, 12}.with_nodes({8, 9}), BodyForce{g}, InitialVelocity{v0, Spin{w0, own.centre}}},
      steps};
  CHECK(run.nodes().bodies()[0].mass() == Approx(own.mass).epsilon(1e-14));
  const Vector3d L = run.nodes().bodies()[0].angular_momentum();
  double balance = 0;
  for (int step = 0; step < 1000; ++step) {
    run.step();
    balance = std::max(balance, std::abs(run.energy().error()));
  }
  const double t = run.time();
  CHECK((run.nodes().bodies()[0].centre() - (t * v0 + 0.5 * t * t * g)).norm() < 1e-11);
  CHECK((run.nodes().bodies()[0].angular_momentum() - L).norm() < 1e-12);
  CHECK((run.positions()[8] - run.positions()[9]).norm() == Approx(std::sqrt(49 + 16 + 1)).epsilon(1e-13));
  CHECK(balance < 1e-12);
}

TEST_CASE("rigid body: one node carries a mass off it, whose spin is told") {
  const Inertia own{2, {0, 1, 0}, {0.1, 0.1, 0.1, 0, 0, 0}};
  Explicit run{
      Scene{std::vector<Vector3d>{{0, 0, 0}}, RigidBody{std::vector<Index>{0}, own}.moving({0, 0, 0}, {5, 0, 0})},
      steps};
  run.until(1);
  CHECK((run.positions()[0] - Vector3d(0, 1 - std::cos(5.0), -std::sin(5.0))).norm() < 1e-11);
}

TEST_CASE("rigid body: a checkpoint goes on to the bit where weights act beside its nodes") {
  const ScratchFolder folder("rigid_body_inertia");
  auto half = thrown(), other = thrown();
  half.until(0.5);
  write_checkpoint(folder / "half", half);
  read_checkpoint(folder / "half", other);
  other.until(1), half.until(1);
  CHECK(other.positions() == half.positions());
  CHECK(other.energy().external == half.energy().external);
}

namespace {

/// A brick of eight elements of the mass 0.12, all of whose nodes belong to a body of the whole mass 2.
const Mesh bricks = box({.lower = {-0.5, -0.3, -0.1}, .size = {1, 0.6, 0.2}, .cells = {2, 2, 2}});
const Part of_bricks{Hex8{}, Elastic{1, 1e3, 0.3}, bricks.hexahedra};
const TotalInertia whole{{2, {0.1, 0, 0}, {0.3, 0.4, 0.5, 0, 0, 0}}};
std::vector<Index> all_nodes(const Mesh& mesh) {
  return nodes_where(mesh.nodes, [](const Vector3d&) { return true; });
}
/// The inertia that nodes of a run have from elements.
Inertia from_elements(const auto& run, const std::vector<Index>& nodes) {
  Inertia sum;
  for (const Index i : nodes) {
    sum.add(run.nodes().mass(i), run.positions()[i]);
    if constexpr (std::remove_cvref_t<decltype(run.nodes())>::nodes_turn)
      sum.moment += SymmetricTensor<double>::isotropic(run.nodes().inertia(i));
  }
  return sum;
}

}  // namespace

// Braces are those of an Inertia.
static_assert(
    std::is_same_v<decltype(RigidBody{std::vector<Index>{0}, {}, HeldBody{{unit(Axis::x)}}}), RigidBody<HeldBody>>);
static_assert(std::is_same_v<decltype(RigidBody{std::vector<Index>{0}, {1, {0, 0, 0}, {}}}), RigidBody<>>);
static_assert(!std::is_convertible_v<Inertia, TotalInertia>);

TEST_CASE("rigid body: a total inertia has the masses of its elements in it, a = F/m") {
  const Vector3d force(3, -1, 2);
  Explicit run{Scene{bricks.nodes, of_bricks,
                     RigidBody{all_nodes(bricks), whole, HeldBody{{}, {unit(Axis::x), unit(Axis::y), unit(Axis::z)}}},
                     NodalForce{force, {4}}},
               steps};
  REQUIRE(run.nodes().bodies()[0].mass() == 2);
  run.until(1);
  const double t = run.time();
  CHECK((run.nodes().bodies()[0].centre() - (whole.centre + 0.25 * t * t * force)).norm() < 1e-12);
  CHECK(std::abs(run.energy().error()) < 1e-12);

  Explicit falls{Scene{bricks.nodes, of_bricks, RigidBody{all_nodes(bricks), whole}.moving(v0, w0), BodyForce{g}},
                 steps};
  const Vector3d L = falls.nodes().bodies()[0].angular_momentum();
  falls.until(1);
  CHECK((falls.nodes().bodies()[0].centre() - (whole.centre + t * v0 + 0.5 * t * t * g)).norm() < 1e-11);
  CHECK((falls.nodes().bodies()[0].angular_momentum() - L).norm() < 1e-12);
  CHECK(std::abs(falls.energy().error()) < 1e-12);
}

TEST_CASE("rigid body: a total inertia spins steadily about its principal axis") {
  for (const auto& body : {RigidBody{all_nodes(bricks), whole}, RigidBody{bricks, whole}}) {
    Explicit run{Scene{bricks.nodes, of_bricks, body.moving({0, 0, 0}, {0, 0, 3})}, steps};
    run.until(1);
    CHECK(run.nodes().bodies()[0].kinetic_energy() == Approx(0.5 * 0.5 * 9).epsilon(1e-13));
    const double angle = 3 * run.time();
    const Vector3d from = bricks.nodes[0] - whole.centre;
    const Vector3d turned{std::cos(angle) * from.x() - std::sin(angle) * from.y(),
                          std::sin(angle) * from.x() + std::cos(angle) * from.y(), from.z()};
    CHECK((run.positions()[0] - whole.centre - turned).norm() < 1e-11);
  }
}

TEST_CASE("rigid body: a total inertia is that beside its nodes and that of these") {
  const Carried all;
  const Inertia beside{0.4, {0.9, 0.1, 0.2}, {0.01, 0.02, 0.015, 0, 0, 0}};
  auto one = all.run(RigidBody{all.held, beside});
  TotalInertia sum{beside};
  const std::vector<Index> beyond = nodes_where(all.mesh.nodes, [](const Vector3d& x) { return x.x() > 0.85; });
  const std::vector<Index> at_bar =
      nodes_where(all.mesh.nodes, [](const Vector3d& x) { return x.x() > 0.75 && x.x() < 0.85; });
  sum.add(from_elements(all.run(RigidBody{beyond, beside}), at_bar));
  auto other = all.run(RigidBody{all.held, sum});
  CHECK(other.nodes().bodies()[0].mass() == Approx(one.nodes().bodies()[0].mass()).epsilon(1e-14));
  one.until(0.05), other.until(0.05);
  CHECK(apart(one, other) < 1e-10);  // shares of the mass differ, which do not count
  CHECK(other.energy().external == Approx(one.energy().external).epsilon(1e-10));

  const Mesh sheet = rectangle({.size = {1, 1}, .cells = {4, 4}});
  const std::vector<Index> edge = nodes_where(sheet.nodes, [](const Vector3d& x) { return x.x() < 0.1; });
  const auto flies = [&](const auto& body) {
    return Explicit{Scene{sheet.nodes,
                          Part{Plate4{}, Homogeneous{PlaneStress{Elastic{1000, 1e6, 0.3}}, 0.05}, sheet.quadrilaterals},
                          body, BodyForce{g}, InitialVelocity{v0, Spin{{3, 2, 5}, {0.4, 0.1, 0.1}}}}};
  };
  const Inertia heavy{30, {0, 0.5, 0.2}, {2, 1, 1.5, 0, 0, 0}};
  TotalInertia with_turns{heavy};
  with_turns.add(from_elements(flies(RigidBody{std::vector<Index>{24}, Inertia{}}), edge));
  auto plate = flies(RigidBody{edge, heavy}), same = flies(RigidBody{edge, with_turns});
  plate.until(0.05), same.until(0.05);
  CHECK(apart(plate, same) < 1e-10);
}

TEST_CASE("rigid body: a total inertia of nodes without elements is an inertia, and a checkpoint goes on to the bit") {
  const auto thrown_by = [](const auto& mesh, const auto& own) {
    return Explicit{Scene{mesh.nodes, RigidBody{all_nodes(mesh), own}.moving(v0, w0), BodyForce{g}}, steps};
  };
  auto one = thrown_by(brick, outside), other = thrown_by(brick, TotalInertia{outside});
  one.until(0.5), other.until(0.5);
  CHECK(one.positions() == other.positions());

  const ScratchFolder folder("total_inertia");
  const auto start = [] {
    return Explicit{Scene{bricks.nodes, of_bricks, RigidBody{all_nodes(bricks), whole}.moving(v0, w0), BodyForce{g}},
                    steps};
  };
  auto half = start(), rest = start();
  half.until(0.5);
  write_checkpoint(folder / "half", half);
  read_checkpoint(folder / "half", rest);
  rest.until(1), half.until(1);
  CHECK(rest.positions() == half.positions());
  CHECK(rest.energy().external == half.energy().external);
}

TEST_CASE("rigid body: a total inertia below that of its elements is refused in a sentence") {
  const auto refusal = [](const TotalInertia& own) -> std::string {
    try {
      Explicit run{Scene{bricks.nodes, of_bricks, RigidBody{all_nodes(bricks), own}}, steps};
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  using Catch::Matchers::ContainsSubstring;
  const Explicit run{Scene{bricks.nodes, of_bricks}, steps};
  const TotalInertia just{from_elements(run, all_nodes(bricks))};
  CHECK(refusal(just).empty());
  TotalInertia light = just, off = just, small = just;
  light.mass *= 0.999, off.centre.x() += 1e-2, small.moment.xx *= 0.99;
  CHECK_THAT(refusal(light),
             ContainsSubstring("its total mass is 0.11988, and its nodes alone have 0.12 from elements"));
  CHECK_THAT(refusal(off), ContainsSubstring("its total moment of inertia is below"));
  CHECK_THAT(refusal(small), ContainsSubstring("its total moment of inertia is below"));
  CHECK_THAT(refusal(TotalInertia{{}}), ContainsSubstring("the rigid body 0: its mass is 0"));
}

TEST_CASE("rigid body: an inertia that no body has is refused in a sentence") {
  const auto refusal = [](const auto& body) -> std::string {
    try {
      Explicit run{Scene{brick.nodes, body}, steps};
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  using Catch::Matchers::ContainsSubstring;
  const auto of = [](double mass, const SymmetricTensor<double>& J) {
    return RigidBody{brick, Inertia{mass, Vector3d::Zero(), J}};
  };
  CHECK(refusal(of(1, {1, 1, 1, 0, 0, 0})).empty());
  CHECK(refusal(of(1, {1, 1, 2, 0, 0, 0})).empty());                       // a plate: just as large as the sum
  CHECK(refusal(of(1, {0.123457, 0.234568, 0.358024, 0, 0, 0})).empty());  // the same in six digits
  CHECK_THAT(refusal(of(0, {1, 1, 1, 0, 0, 0})), ContainsSubstring("the rigid body 0: its mass is 0"));
  CHECK_THAT(refusal(of(1, {})), ContainsSubstring("is not positive"));
  CHECK_THAT(refusal(of(1, {1, 1, 0, 0, 0, 0})), ContainsSubstring("is not positive"));
  CHECK_THAT(refusal(of(1, {1, 1, 1, 2, 0, 0})), ContainsSubstring("is not positive"));
  CHECK_THAT(refusal(of(1, {1, 1, 2.1, 0, 0, 0})), ContainsSubstring("larger than the sum of the others"));
  // Principal moments 0.5, 1.5 and 0.9.
  CHECK_THAT(refusal(of(1, {1, 1, 0.9, 0.5, 0, 0})), ContainsSubstring("larger than the sum of the others"));
  CHECK_THAT(refusal(RigidBody{std::vector<Index>{0, 1, 2}, Inertia{1, Vector3d::Zero(), {}}}),
             ContainsSubstring("its nodes lie apart and it has no moment of inertia"));
  CHECK_THAT(refusal(RigidBody{std::vector<Index>{0, 1, 2}, Inertia{1, Vector3d::Zero(), {1, 1, 0, 0, 0, 0}}}),
             ContainsSubstring("its nodes lie apart and it has no moment of inertia"));
  CHECK_THAT(refusal(of(1, {1, 1, 1, 0, 0, 0}).with_nodes({99})), ContainsSubstring("99"));
}
