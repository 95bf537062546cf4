#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <strike/contact/contact.hpp>
#include <strike/mesh/box.hpp>
#include <strike/mesh/sheet.hpp>
#include <strike/mesh/transform.hpp>

#include "problems/balls.hpp"
#include "support/catch.hpp"

using namespace strike;
using testing::Balls;

namespace {

/// A mesh of heavy nodes, and light balls that fly at it.
struct ShootingRange {
  std::vector<Eigen::Vector3d> x, v;
  std::vector<double> mass;
  std::vector<Index> balls;

  explicit ShootingRange(const Mesh& mesh)
      : x(mesh.nodes), v(x.size(), Eigen::Vector3d::Zero()), mass(x.size(), 1e12) {}
  void shoot(const Eigen::Vector3d& from, const Eigen::Vector3d& velocity) {
    balls.push_back(static_cast<Index>(x.size()));
    x.push_back(from), v.push_back(velocity), mass.push_back(1);
  }
  double momentum() const {
    double sum = 0;
    for (std::size_t i = 0; i < v.size(); ++i) sum += mass[i] * v[i].norm();
    return sum;
  }
  template <class Pairing, class... Policies>
  auto run(Pairing pairing, const Policies&... policies) const {
    return Balls(x, v, mass, Contact{std::move(pairing), policies...});
  }
};

const Mesh floor_of_8 = rectangle({.size = {1, 1}, .cells = {8, 8}});
std::vector<Face> faces_of(const Mesh& mesh) { return surface(mesh); }

}  // namespace

TEST_CASE("nothing passes a surface or a plate, at any speed and from any angle") {
  std::mt19937 random(1);
  const auto number = [&] { return std::uniform_real_distribution<double>(-1, 1)(random); };
  for (const double thickness : {0.0, 0.02})
    for (const double speed : {1e-3, 0.1, 1.0, 10.0}) {  // in a step, whose length is 1; a face is 0.125 wide
      ShootingRange range(floor_of_8);
      for (int i = 0; i < 200; ++i) {
        const Eigen::Vector3d at(0.5 + 0.4 * number(), 0.5 + 0.4 * number(), 0);
        const Eigen::Vector3d direction(0.3 * number(), 0.3 * number(), thickness > 0 && i % 2 ? 1 : -1);
        range.shoot(at - (0.02 + 0.98 * speed * std::abs(number())) * direction, speed * direction);
      }
      auto run = range.run(NodeToSurface{range.balls, Surface{faces_of(floor_of_8), thickness}});
      for (int n = 0; n < std::min(1000.0, 3 + 0.1 / speed); ++n) run.step(1);
      int through = 0;
      for (std::size_t k = 0; k < range.balls.size(); ++k) {
        const Eigen::Vector3d x = run.nodes.x(range.balls[k]);
        const bool over = std::abs(x.x() - 0.5) < 0.5 && std::abs(x.y() - 0.5) < 0.5;
        const double side = range.v[range.balls[k]].z() < 0 ? 1 : -1;
        if (over && side * x.z() < 0.5 * thickness - 1e-9) ++through;
      }
      INFO("thickness " << thickness << ", speed " << speed);
      CHECK(through == 0);
    }
}

TEST_CASE("what flies past an edge is left alone") {
  const Mesh cube = box({.size = {1, 1, 1}, .cells = {4, 4, 4}});
  for (const double speed : {0.01, 0.1, 1.0}) {
    ShootingRange range(cube);
    range.shoot({1.02, 0.5, 1.5}, {0, 0, -speed});
    range.shoot({1.3, 1.4, 1.32}, {-0.3 * speed, -0.3 * speed, -speed});
    range.shoot({-0.4, 0.6, 1.0 + 0.01}, {speed, 0, 0});
    auto run = range.run(NodeToSurface{range.balls, Surface{faces_of(cube)}});
    for (int n = 0; n < 3 / speed; ++n) run.step(1);
    CHECK(run.contact.impulse().norm() == 0);
  }
}

TEST_CASE("D34: a node on an edge or a corner that faces share is served once") {
  for (const double thickness : {0.0, 0.02})
    for (const Eigen::Vector3d& at : {Eigen::Vector3d(0.5, 0.5, 0), Eigen::Vector3d(0.5, 0.53, 0),
                                      Eigen::Vector3d(0.53, 0.53, 0), Eigen::Vector3d(0.5, 0, 0)}) {
      ShootingRange range(floor_of_8);
      const double height = 0.01 + 0.5 * thickness;
      range.shoot(at + height * Eigen::Vector3d::UnitZ(), {0, 0, -1});
      auto run = range.run(NodeToSurface{range.balls, Surface{faces_of(floor_of_8), thickness}});
      for (int n = 0; n < 40; ++n) {
        run.step(1e-3);
        CHECK(run.contact.pairs().size() <= 1);
      }
      CHECK(run.contact.impulse().z() == Approx(1).epsilon(1e-9));  // an inelastic impact on what does not move
      CHECK(run.nodes.x(range.balls[0]).z() == Approx(0.5 * thickness).margin(1e-12));
      CHECK(run.momentum().z() == Approx(-1).epsilon(1e-12));
    }
}

TEST_CASE("D35: what begins inside is reported by number and stays there without energy") {
  ShootingRange range(floor_of_8);
  range.shoot({0.5, 0.5, -0.01}, {0, 0, 0});
  range.shoot({0.3, 0.2, -0.03}, {0, 0, 0});
  range.shoot({0.25, 0.25, 0}, {0, 0, 0});      // on a node
  range.shoot({0.3, 0.3, 0}, {0, 0, 0});        // on a face
  range.shoot({0.6, 0.7, -0.02}, {0, 0, 0.1});  // leaves
  const auto check = [&](auto law) {
    auto run = range.run(NodeToSurface{range.balls, Surface{faces_of(floor_of_8)}}, law);
    CHECK_THAT(run.contact.warning(), Catch::Matchers::ContainsSubstring("3 nodes begin inside") &&
                                          Catch::Matchers::ContainsSubstring("node " + std::to_string(range.balls[1])));
    for (int n = 0; n < 1000; ++n) run.step(1e-3);
    CHECK(run.energy() == Approx(run.begin_energy).epsilon(1e-12));
    CHECK(run.contact.penetration() < 1e-15);
    // The offset of what has left is used up: it comes back to the surface itself.
    for (std::size_t i = 0; i < run.nodes.size(); ++i) run.nodes.set_velocity(i, -run.nodes.v(i));
    for (int n = 0; n < 2000; ++n) run.step(1e-3);
    const double z = run.nodes.x(range.balls[4]).z();
    CHECK(z > -1e-3);
  };
  check(Kinematic{});
  check(Penalty{});
}

TEST_CASE("rigid bodies stop nodes at their surface and let those go that miss it") {
  const auto stop = [](auto body, const Eigen::Vector3d& from, const Eigen::Vector3d& v, const Eigen::Vector3d& at) {
    ShootingRange range({});
    range.shoot(from, v);
    range.shoot(from + Eigen::Vector3d(0, 100, 0), v);
    auto run = range.run(NodeToRigid{std::vector<Index>{range.balls[0]}, body});
    for (int n = 0; n < 200; ++n) run.step(1e-2);
    CHECK((run.nodes.x(0) - at).norm() < 1e-9);
    CHECK((run.contact.impulse() + v).norm() < 1e-9);  // of the mass 1, all of its velocity is normal
    return run;
  };
  stop(RigidPlane{{0, 0, 0}, {0, 0, 2}}, {0.1, 0.2, 1}, {0, 0, -1}, {0.1, 0.2, 0});
  stop(RigidSphere{{0, 0, 0}, 0.5}, {0, 0, 1}, {0, 0, -3}, {0, 0, 0.5});
  stop(RigidCylinder{{0, 0, 0}, {0, 3, 0}, 0.5}, {0, 2, 1}, {0, 0, -300}, {0, 2, 0.5});
  const Mesh mesh = box({.lower = {-1, -1, -1}, .size = {2, 2, 1}, .cells = {3, 3, 1}});
  stop(RigidSurface{mesh.nodes, surface(mesh)}, {0.1, 0.2, 1}, {0, 0, -30}, {0.1, 0.2, 0});

  ShootingRange range({});
  range.shoot({0.51, 0, 1}, {0, 0, -1});
  range.shoot({0.6, 5, 30}, {0, 0, -1000});
  auto run = range.run(NodeToRigid{range.balls, RigidSphere{{0, 0, 0}, 0.5}});
  for (int n = 0; n < 200; ++n) run.step(1e-2);
  CHECK(run.contact.impulse().norm() == 0);
}

TEST_CASE("a block slides to rest after v^2/(2 mu g), and does not move on a slope below the angle of friction") {
  const double v = 2, mu = 0.3, g = 9.81, dt = 1e-4;
  for (const double slope : {0.0, 0.9, 1.1}) {
    const double angle = std::atan(slope * mu);
    ShootingRange range({});
    range.shoot({0, 0, 0}, slope > 0 ? Eigen::Vector3d::Zero() : Eigen::Vector3d(v, 0, 0));
    auto run = range.run(NodeToRigid{range.balls, RigidPlane{{0, 0, 0}, {0, 0, 1}}}, Coulomb{mu});
    const Eigen::Vector3d weight(g * std::sin(angle), 0, -g * std::cos(angle));
    double stopped = 0;
    while (run.time < 1.5) {
      run.step(dt, weight);
      if (stopped == 0 && run.nodes.v(0).x() == 0) stopped = run.time;
    }
    if (slope == 0) {
      CHECK(stopped == Approx(v / (mu * g)).epsilon(1e-3));
      CHECK(run.nodes.x(0).x() == Approx(v * v / (2 * mu * g)).epsilon(1e-3));
      CHECK(run.ledger.friction.settled() == Approx(0.5 * v * v).epsilon(1e-3));
    } else if (slope < 1) {
      CHECK(run.nodes.x(0).norm() < 1e-12);
    } else {
      const double a = g * (std::sin(angle) - mu * std::cos(angle));
      CHECK(run.nodes.x(0).x() == Approx(0.5 * a * 1.5 * 1.5).epsilon(1e-3));
    }
  }
}

TEST_CASE("cells that are removed lay bare what they covered") {
  const Mesh block = box({.size = {2, 1, 1}, .cells = {2, 1, 1}});
  Surface skin = solid_surface(block.hexahedra, 0);
  CHECK(skin.faces().size() == 10);
  const std::vector<bool> alive{true, false};
  CHECK(!skin.remove(1, alive));
  CHECK(skin.remove(0, alive));
  CHECK(skin.faces().size() == 6);
  CHECK_THROWS_WITH(solid_surface(block.hexahedra, 0).remove(0, {true}),
                    Catch::Matchers::ContainsSubstring("give one flag for each"));

  const Mesh column = box({.size = {1, 1, 2}, .cells = {1, 1, 2}});
  ShootingRange range(column);
  range.shoot({0.5, 0.4, 2.5}, {0, 0, -1});
  auto run = range.run(NodeToSurface{range.balls, solid_surface(column.hexahedra, 3)});
  const std::vector<bool> top_gone{true, false};
  run.contact.remove(3, top_gone);
  for (int n = 0; n < 300; ++n) run.step(1e-2);
  CHECK(run.nodes.x(range.balls[0]).z() == Approx(1));
}

TEST_CASE("a sheet that folds meets itself, and its neighbours do not count") {
  // Two leaves of a plate of 0.1 at z = 0 and 1, hinged along y = 0 by faces between them; the upper one comes down.
  const Mesh leaves = sheet({4, 12}, [](double s, double t) {
    const double y = std::abs(t - 0.5) < 0.13 ? 0.0 : 6 * (std::abs(t - 0.5) - 0.125),
                 z = std::clamp(4 * t - 1.5, 0.0, 1.0);
    return Eigen::Vector3d(s, y, z);
  });
  ShootingRange range(leaves);
  for (auto& m : range.mass) m = 1;
  for (std::size_t i = 0; i < range.x.size(); ++i)
    if (range.x[i].z() == 1 && range.x[i].y() > 0.4) range.v[i] = {0, 0, -1};
  auto run = range.run(SelfContact{Surface{faces_of(leaves), 0.1}});
  run.step(1e-2);
  CHECK(run.contact.pairs().empty());
  double least = 1;
  for (int n = 0; n < 150; ++n) {
    run.step(1e-2);
    for (const auto& pair : run.contact.pairs()) least = std::min(least, pair.gap);
  }
  CHECK(run.energy() < 0.6 * run.begin_energy);  // inelastic between equals
  CHECK(run.momentum().z() == Approx(-range.momentum()).epsilon(1e-12));
  CHECK(least > -1e-4);  // corrections one after the other
}

TEST_CASE("a contact of what is not there is refused") {
  CHECK_THROWS_WITH(Surface{std::vector<Face>{}}, Catch::Matchers::ContainsSubstring("has no faces"));
  CHECK_THROWS_WITH((Surface{faces_of(floor_of_8), -1}),
                    Catch::Matchers::ContainsSubstring("thickness of Surface is -1"));
  ShootingRange range(floor_of_8);
  range.shoot({0, 0, 1}, {0, 0, 0});
  CHECK_THROWS_WITH(range.run(NodeToSurface{std::vector<Index>{4711}, Surface{faces_of(floor_of_8)}}),
                    Catch::Matchers::ContainsSubstring("names node 4711, but there are 82"));
  CHECK_THROWS_WITH(range.run(NodeToSurface{std::vector<Index>{}, Surface{faces_of(floor_of_8)}}),
                    Catch::Matchers::ContainsSubstring("has no nodes"));
  CHECK_THROWS_WITH(range.run(NodeToSurface{range.balls, Surface{faces_of(floor_of_8)}}, Penalty{.fraction = 5}),
                    Catch::Matchers::ContainsSubstring("fraction of Penalty is 5"));
}
