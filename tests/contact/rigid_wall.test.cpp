#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <strike/contact/contact.hpp>
#include <strike/contact/rigid_wall.hpp>
#include <strike/dynamics/explicit.hpp>
#include <strike/element/hex8.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/load/support.hpp>
#include <strike/mesh/box.hpp>
#include <strike/mesh/select.hpp>
#include <strike/scalar/dual.hpp>

#include "problems/balls.hpp"
#include "support/catch.hpp"

using namespace strike;
using Catch::Matchers::ContainsSubstring;
using testing::Balls;

namespace {

constexpr Elastic rubber{.density = 1000, .youngs_modulus = 1e8, .poissons_ratio = 0.3};
const Eigen::Vector3d point(0.1, -0.2, 0.05), normal(1, -2, 4);

/// Loose nodes that fly at the plane through `point`; every tenth starts behind it.
struct Cloud {
  std::vector<Eigen::Vector3d> x, v;
  std::vector<double> mass;
  std::vector<Index> nodes;

  Cloud() {
    std::mt19937 random(7);
    const auto number = [&] { return std::uniform_real_distribution<double>(-1, 1)(random); };
    const Eigen::Vector3d n = normal.normalized();
    for (Index i = 0; i < 100; ++i) {
      const double height = i % 10 == 0 ? -0.01 : 0.02 + 0.01 * number();
      const Eigen::Vector3d along(number(), number(), number());
      x.push_back(point + along - n.dot(along) * n + height * n);
      v.push_back(0.3 * Eigen::Vector3d(number(), number(), number()) - n);
      mass.push_back(std::pow(10, number()));
      nodes.push_back(99 - i);
    }
  }
};

template <class A, class B>
void check_same(const A& a, const B& b) {
  CHECK(a.contact.force() == b.contact.force());
  CHECK(a.contact.impulse() == b.contact.impulse());
  CHECK(a.contact.penetration() == b.contact.penetration());
  CHECK(a.contact.forces(a.nodes.size()) == b.contact.forces(b.nodes.size()));
  CHECK(a.contact.warning() == b.contact.warning());
  CHECK(a.ledger.contact.settled() == b.ledger.contact.settled());
  CHECK(a.ledger.friction.settled() == b.ledger.friction.settled());
  for (std::size_t i = 0; i < a.nodes.size(); ++i) CHECK(a.nodes.v(i) == b.nodes.v(i));
}

}  // namespace

TEST_CASE("a RigidWall and a kinematic Contact with a RigidPlane are the same to the bit") {
  const Cloud cloud;
  for (const double friction : {0.0, 0.3}) {
    Balls wall(cloud.x, cloud.v, cloud.mass, RigidWall{point, normal, cloud.nodes, friction});
    Balls everywhere(cloud.x, cloud.v, cloud.mass, RigidWall{point, normal, friction});
    Balls contact(cloud.x, cloud.v, cloud.mass,
                  Contact{NodeToRigid{cloud.nodes, RigidPlane{point, normal}}, Coulomb{friction}});
    for (int n = 0; n < 60; ++n) {
      wall.step(1e-3), everywhere.step(1e-3), contact.step(1e-3);
      check_same(wall, contact);
      check_same(wall, everywhere);
    }
    CHECK(wall.contact.impulse().norm() > 1);
    CHECK(wall.energy() + wall.ledger.contact.settled() + wall.ledger.friction.settled() ==
          Approx(wall.begin_energy).epsilon(1e-12));
  }
}

TEST_CASE("a plane of plates is touched half a thickness away") {
  Balls plate({{0, 0, 1}}, {{0, 0, -1}}, {1},
              Contact{NodeToRigid{std::vector<Index>{0}, RigidPlane{{0, 0, 0}, {0, 0, 3}}, 0.2}});
  for (int n = 0; n < 120; ++n) plate.step(1e-2);
  CHECK(plate.nodes.x(0).z() == Approx(0.1).epsilon(1e-14));
}

TEST_CASE("D35: nodes that start behind a wall are reported and stay there without energy until they leave") {
  Balls run({{1, 2, -0.01}, {3, 4, -0.03}, {5, 6, 0}, {7, 8, -0.02}, {9, 9, -1e-17}},
            {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0.1}, {0, 0, 0}}, {1, 1, 1, 1, 1},
            RigidWall{{0, 0, 0}, {0, 0, 1}});
  CHECK(run.contact.warning() ==
        "3 nodes begin inside what they may touch, the deepest, node 1 at (3, 4, -0.03), by 0.03; they stay so deep "
        "without force until they leave: move the meshes apart if that is not meant.");
  for (int n = 0; n < 1000; ++n) run.step(1e-3);
  CHECK(run.energy() == Approx(run.begin_energy).epsilon(1e-12));
  CHECK(run.contact.impulse().norm() == 0);
  CHECK(run.nodes.x(1).z() == -0.03);
  // A node that has left comes back to the plane itself; one that has not, to where it began.
  for (std::size_t i = 0; i < run.nodes.size(); ++i) run.nodes.set_velocity(i, {0, 0, -0.1});
  for (int n = 0; n < 2000; ++n) run.step(1e-3);
  CHECK(run.nodes.x(3).z() == Approx(0).margin(1e-15));
  CHECK(run.nodes.x(1).z() == Approx(-0.03).epsilon(1e-14));
  CHECK(run.contact.penetration() < 1e-15);
  CHECK(RigidWall({0, 0, 0}, {0, 0, 1}).warning().empty());
}

TEST_CASE("a node that something else moves behind a wall comes out no faster than it came in") {
  Balls run({{1, 2, 0.5}}, {{0, 0, -2}}, {3}, RigidWall{{0, 0, 0}, {0, 0, 1}});
  run.nodes.set_position(0, {1, 2, -0.5});
  run.step(1e-3);
  CHECK(run.nodes.v(0).z() == Approx(2).epsilon(1e-15));
  for (int n = 0; n < 1000; ++n) run.step(1e-3);
  CHECK(run.energy() == Approx(run.begin_energy).epsilon(1e-12));
}

TEST_CASE("both names give the same bits in runs of any numbers") {
  const Mesh mesh = box({.lower = {0, 0, 0.01}, .size = {1, 1, 1}, .cells = {2, 2, 2}});
  const auto nodes = all_nodes(mesh.nodes);
  const auto check = [&](auto number) {
    const auto struck = [&](auto contact) {
      Explicit run{Scene{mesh.nodes, Part{Hex8{}, rubber, mesh.hexahedra}, InitialVelocity{{3, 0, -5}}, contact},
                   ExplicitOptions{.largest_step = 2e-4}, number};
      run.until(0.01);
      CHECK(run.template item<2>().impulse().z() > 1);
      return std::pair{run.positions(), run.energy().friction};
    };
    const auto wall = struck(RigidWall{{0, 0, 0}, {0, 0, 1}, 0.2}),
               contact = struck(Contact{NodeToRigid{nodes, RigidPlane{{0, 0, 0}, {0, 0, 1}}}, Coulomb{0.2}});
    CHECK(wall == contact);
    CHECK(wall.second > 0);
  };
  check(in<Pack<double>>);
  check(in<Pack<float>>);
  check(in<Pack<float>, double>);
  check(in<Dual<double, 1>>);
}
