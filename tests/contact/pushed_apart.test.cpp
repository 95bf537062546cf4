// Bodies that overlap at the start are moved apart without strain, for every pairing.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include <strike/contact/contact.hpp>
#include <strike/contact/rigid_wall.hpp>
#include <strike/dynamics/explicit.hpp>
#include <strike/dynamics/pushed_apart.hpp>
#include <strike/element/hex8.hpp>
#include <strike/element/plate4.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/load/support.hpp>
#include <strike/material/elastic.hpp>
#include <strike/material/plane_stress.hpp>
#include <strike/mesh/box.hpp>
#include <strike/mesh/order.hpp>
#include <strike/mesh/sheet.hpp>
#include <strike/mesh/surface.hpp>
#include <strike/mesh/transform.hpp>
#include <strike/section/layered.hpp>

#include "contact/bodies.hpp"
#include "support/catch.hpp"

using namespace strike;
using Catch::Matchers::ContainsSubstring;
using Positions = std::vector<Eigen::Vector3d>;

namespace {

const Elastic elastic{.density = 1, .youngs_modulus = 100, .poissons_ratio = 0.3};
const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix();

/// Two bodies of cells of about 0.25 in one mesh.
struct Two {
  Mesh mesh;
  Index first_node;
  Cells<8> one, other;

  Two(const Mesh& a, const Mesh& b) : mesh(a), first_node(append(mesh, b)), one(a.hexahedra) {
    other.assign(mesh.hexahedra.begin() + static_cast<std::ptrdiff_t>(one.size()), mesh.hexahedra.end());
  }
  std::vector<Index> nodes(bool second) const {
    std::vector<Index> numbers;
    for (Index i = second ? first_node : 0; i < (second ? mesh.nodes.size() : first_node); ++i) numbers.push_back(i);
    return numbers;
  }
  TwoWay skins() const { return {solid_surface(one, 0), solid_surface(other, 1)}; }
};
Two cubes(double overlap, Index n = 4, double shift = 0) {
  return {box({.size = {1, 1, 1}, .cells = {4, 4, 4}}),
          box({.lower = {shift, shift, 1 - overlap}, .size = {1, 1, 1}, .cells = {n, n, n}})};
}

/// The scene begins and stays at rest, without a warning of its contacts.
template <class S>
Positions rests(const S& scene) {
  Explicit run{scene, ExplicitOptions{.print_warnings = false}};
  const Positions start = run.positions();
  const auto warnings = run.warnings();
  for (const std::string& warning : warnings) CHECK_THAT(warning, ContainsSubstring("moved before the run"));
  for (int step = 0; step < 20; ++step) run.step();
  CHECK(testing::apart(run.positions(), start) < 1e-12);
  double fastest = 0;
  for (const auto& v : run.velocities()) fastest = std::max(fastest, v.norm());
  CHECK(fastest < 1e-10);
  CHECK(std::abs(run.energy().internal) < 1e-20);
  CHECK(std::abs(run.energy().kinetic) < 1e-20);
  return start;
}
const PushedApart& report(const auto& scene) { return std::get<PushedApart>(scene.items); }

template <class... Items>
auto scene_of(const Two& two, const Items&... items) {
  return Scene{two.mesh.nodes, Part{Hex8{}, elastic, two.one}, Part{Hex8{}, elastic, two.other}, items...};
}

}  // namespace

TEST_CASE("overlapping cubes are moved half the overlap each") {
  const double overlap = 0.025;
  const Two two = cubes(overlap);
  const auto check = [&](const auto& contact) {
    const auto scene = pushed_apart(scene_of(two, contact));
    CHECK(report(scene).moved == 50);
    CHECK(report(scene).way == Approx(0.5 * overlap).epsilon(1e-9));
    const Positions x = rests(scene);
    for (std::size_t i = 0; i < x.size(); ++i) {
      const bool top = i < two.first_node && two.mesh.nodes[i].z() > 0.99,
                 bottom = i >= two.first_node && two.mesh.nodes[i].z() < 1;
      const Eigen::Vector3d way{0, 0, top ? -0.5 * overlap : bottom ? 0.5 * overlap : 0};
      CHECK((x[i] - two.mesh.nodes[i] - way).norm() < 1e-12);
    }
  };
  check(Contact{two.skins()});
  check(Contact{two.skins(), Penalty{}});
  check(Contact{Everything{}});
  check(Contact{SelfContact{solid_surface(two.one, 0) + solid_surface(two.other, 1)}});
  check(Contact{NodeToSurface{two.nodes(true), solid_surface(two.one, 0)}});
  // All meshes that are not pushed apart warn, and rest as they are.
  Explicit run{scene_of(two, Contact{Everything{}})};
  CHECK(run.warnings().size() == 1);
  CHECK_THAT(run.warnings()[0], ContainsSubstring("50 nodes begin inside") && ContainsSubstring("0.025"));
}

TEST_CASE("what does not overlap is left as it is") {
  for (const double gap : {0.0, 1e-3}) {
    const Two two = cubes(-gap);
    const auto scene = pushed_apart(scene_of(two, Contact{Everything{}}));
    CHECK(report(scene).moved == 0);
    CHECK(testing::apart(scene.nodes, two.mesh.nodes) == 0);
    CHECK(Explicit{scene}.warnings().empty());
  }
}

TEST_CASE("other meshes, shifted and turned, rest and answer alike") {
  for (const Index n : {4u, 3u, 7u})
    for (const double shift : {0.0, 0.1, 1e-3}) {
      CAPTURE(n, shift);
      const Two two = cubes(0.025, n, shift);
      const auto scene = pushed_apart(scene_of(two, Contact{Everything{}}));
      const Positions x = rests(scene);
      CHECK(report(scene).way < 0.025 * (1 + 1e-9));

      Two turned = two;
      for (auto& at : turned.mesh.nodes) at = turn * at;
      Positions y = pushed_apart(scene_of(turned, Contact{Everything{}})).nodes;
      for (auto& at : y) at = turn.transpose() * at;
      CHECK(testing::apart(x, y) < 1e-10);
    }
}

TEST_CASE("a skewed body turned on another") {
  Mesh upper = rotated(box({.lower = {-0.5, -0.5, 0}, .size = {1, 1, 1}, .cells = {4, 5, 4}}), {1, 3, 1}, 0.2);
  for (auto& x : upper.nodes) x.x() += 0.2 * x.z(), x += Eigen::Vector3d(0.5, 0.5, 1.08);
  const Two two(box({.size = {1, 1, 1}, .cells = {4, 4, 4}}), upper);
  for (const auto& scene : {pushed_apart(scene_of(two, Contact{Everything{}}))}) {
    CHECK(report(scene).moved > 4);
    rests(scene);
  }
  rests(pushed_apart(scene_of(two, Contact{two.skins(), Penalty{}})));
}

TEST_CASE("the numbers of nodes and cells do not count") {
  const Two two = cubes(0.025, 3, 0.1);
  const std::size_t count = two.mesh.nodes.size();
  std::vector<Index> number(count);
  for (Index i = 0; i < count; ++i) number[i] = static_cast<Index>((i * 71 + 13) % count);
  REQUIRE(count % 71 != 0);
  Two other = two;
  for (std::size_t i = 0; i < count; ++i) other.mesh.nodes[number[i]] = two.mesh.nodes[i];
  for (Cells<8>* cells : {&other.one, &other.other}) {
    std::reverse(cells->begin(), cells->end());
    for (auto& cell : *cells)
      for (Index& i : cell) i = number[i];
  }
  const Positions x = pushed_apart(scene_of(two, Contact{Everything{}})).nodes,
                  y = pushed_apart(scene_of(other, Contact{Everything{}})).nodes;
  for (std::size_t i = 0; i < count; ++i) CHECK((x[i] - y[number[i]]).norm() < 1e-11);
}

TEST_CASE("light bodies move more, held and rigid ones do not") {
  const double overlap = 0.025;
  const Two two = cubes(overlap);
  const auto heavy = pushed_apart(Scene{two.mesh.nodes, Part{Hex8{}, elastic, two.one},
                                        Part{Hex8{}, Elastic{3, 100, 0.3}, two.other}, Contact{Everything{}}});
  CHECK(report(heavy).way == Approx(0.75 * overlap));
  CHECK(report(heavy).farthest < two.first_node);
  const auto held = pushed_apart(scene_of(two, Contact{Everything{}}, Clamped{two.nodes(false)}));
  CHECK(report(held).moved == 25);
  CHECK(report(held).way == Approx(overlap));
  CHECK(report(held).farthest >= two.first_node);
  CHECK_THROWS_WITH(
      pushed_apart(scene_of(two, Contact{Everything{}}, Clamped{two.nodes(false)}, Clamped{two.nodes(true)})),
      ContainsSubstring("is 0.025 inside what it may touch, and conditions hold both sides"));
}

TEST_CASE("a body in a rigid plane, ball or surface") {
  const Two two = cubes(-1);
  const std::vector<Index> nodes = two.nodes(false);
  const auto check = [&](const auto& contact, double way) {
    const auto scene = pushed_apart(scene_of(two, contact));
    CHECK(report(scene).way == Approx(way).epsilon(1e-6));
    CHECK(report(scene).moved == 25);
    rests(scene);
  };
  const RigidPlane plane{{0, 0, 0.02}, {0, 0, 2}};
  check(RigidWall{plane.point, plane.normal, nodes}, 0.02);
  check(Contact{NodeToRigid{nodes, plane}}, 0.02);
  check(Contact{NodeToRigid{nodes, plane}, Penalty{}}, 0.02);
  const double R = 20;
  check(Contact{NodeToRigid{nodes, RigidSphere{{0.5, 0.5, 0.05 - R}, R}}, Penalty{}}, 0.05);
  const Mesh ground = box({.lower = {-2, -2, -1}, .size = {5, 5, 1.02}, .cells = {3, 3, 1}});
  check(Contact{NodeToRigid{nodes, RigidSurface{ground.nodes, surface(ground)}}}, 0.02);
}

TEST_CASE("three bodies at once") {
  Mesh mesh = box({.size = {1, 1, 1}, .cells = {4, 4, 4}});
  const Cells<8> first = mesh.hexahedra;
  append(mesh, box({.lower = {0.1, -0.2, 0.98}, .size = {0.8, 1.3, 1}, .cells = {3, 4, 4}}));
  append(mesh, box({.lower = {0.99, 0.1, -0.1}, .size = {1, 0.7, 2.5}, .cells = {4, 3, 7}}));
  const auto n = static_cast<std::ptrdiff_t>(first.size());
  const Cells<8> second(mesh.hexahedra.begin() + n, mesh.hexahedra.begin() + n + 48),
      third(mesh.hexahedra.begin() + n + 48, mesh.hexahedra.end());
  const auto scene = pushed_apart(Scene{mesh.nodes, Part{Hex8{}, elastic, first}, Part{Hex8{}, elastic, second},
                                        Part{Hex8{}, elastic, third}, Contact{Everything{}}});
  CHECK(report(scene).moved > 40);
  rests(scene);
}

TEST_CASE("plates closer than their thickness") {
  const double h = 0.02;
  for (const double offset : {0.0, 0.5 * h, -0.5 * h})
    for (const Index n : {4u, 3u})
      for (const bool turned : {false, true}) {
        CAPTURE(offset, n, turned);
        Mesh mesh = rectangle({.size = {1, 1}, .cells = {4, 4}});
        const Cells<4> lower = mesh.quadrilaterals;
        append(mesh, translated(rectangle({.size = {1, 1}, .cells = {n, n}}), {0, 0, 0.7 * h}));
        const Cells<4> upper(mesh.quadrilaterals.begin() + 16, mesh.quadrilaterals.end());
        if (turned)
          for (auto& x : mesh.nodes) x = turn * x;
        const Homogeneous section{PlaneStress{elastic}, h, Offset{offset}};
        const auto scene = pushed_apart(
            Scene{mesh.nodes, Part{Plate4{}, section, lower}, Part{Plate4{}, section, upper}, Contact{Everything{}}});
        CHECK(report(scene).moved == 25 + (n + 1) * (n + 1));
        const Positions x = rests(scene);
        if (n == 4)
          for (std::size_t i = 0; i < 25; ++i) CHECK((x[i + 25] - x[i]).norm() == Approx(h).epsilon(1e-9));
      }
}

TEST_CASE("a block deeper in a plate than its middle") {
  const double h = 0.04;
  for (const double side : {1.0, -1.0}) {
    Mesh mesh = box({.size = {1, 1, 1}, .cells = {4, 4, 4}});
    append(mesh, translated(rectangle({.size = {1, 1}, .cells = {4, 4}}), {0, 0, side > 0 ? 0.99 : 0.01}));
    const auto scene = pushed_apart(Scene{mesh.nodes, Part{Hex8{}, elastic, mesh.hexahedra},
                                          Part{Plate4{}, Homogeneous{PlaneStress{elastic}, h}, mesh.quadrilaterals},
                                          Contact{Everything{}}});
    const Positions x = rests(scene);
    for (std::size_t i = 0; i < 125; ++i)
      if (mesh.nodes[i].z() == (side > 0 ? 1 : 0))
        CHECK(side * (x[nearest_node({x.data() + 125, 25}, x[i]) + 125] - x[i]).z() == Approx(0.5 * h).epsilon(1e-9));
  }
}

TEST_CASE("bars that overlapped push each other at once, as those that begin in touch") {
  const auto momentum = [](double overlap, Index cells, const auto& law) {
    const Two bars(box({.size = {1, 1, 5}, .cells = {2, 2, cells}}),
                   box({.lower = {0, 0, 5 - overlap}, .size = {1, 1, 5}, .cells = {2, 2, cells}}));
    const auto scene =
        pushed_apart(scene_of(bars, InitialVelocity{{0, 0, -0.1}, bars.nodes(true)}, Contact{Everything{}, law}));
    CHECK(report(scene).moved == (overlap > 0 ? 18 : 0));
    Explicit run{scene, ExplicitOptions{.print_warnings = false}};
    run.until(0.5);
    double sum = 0;
    for (const Index i : bars.nodes(false)) sum += run.nodes().mass(i) * run.nodes().v(i).z();
    return sum;
  };
  for (const Index cells :
       {20u, 40u}) {  // the bars are half a per cent shorter, their first masses 5 or 10 per cent less
    CAPTURE(cells);
    const double at_once = momentum(0, cells, Kinematic{}), soft = momentum(0, cells, Penalty{});
    CHECK(momentum(0.025, cells, Kinematic{}) == Approx(at_once).epsilon(0.01));
    CHECK(momentum(0.025, cells, Penalty{}) == Approx(soft).epsilon(0.01));
  }
}

TEST_CASE("cells that the moving would turn inside out are named") {
  CHECK_THROWS_WITH(pushed_apart(scene_of(cubes(0.6), Contact{Everything{}})),
                    ContainsSubstring("would be inside out") && ContainsSubstring("of part "));
}
