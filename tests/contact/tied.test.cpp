#include <cmath>
#include <limits>
#include <vector>

#include <strike/contact/tied.hpp>
#include <strike/element/hex8.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/load/nodal_force.hpp>
#include <strike/load/support.hpp>
#include <strike/mesh/select.hpp>
#include <strike/mesh/surface.hpp>
#include <strike/mesh/transform.hpp>

#include "problems/column.hpp"
#include "support/catch.hpp"

using namespace strike;

namespace {

/// Two blocks, one on the other, with 2 x 2 and 3 x 3 cells where they meet at z = 1.
struct Stack {
  Mesh mesh = box({.size = {1, 1, 1}, .cells = {2, 2, 2}});
  Index first_upper = append(mesh, box({.lower = {0, 0, 1}, .size = {1, 1, 1}, .cells = {3, 3, 3}}));
  std::vector<Index> nodes;
  std::vector<Face> faces;

  Stack() {
    for (Index i = first_upper; i < mesh.nodes.size(); ++i)
      if (mesh.nodes[i].z() < 1 + 1e-9) nodes.push_back(i);
    for (const Face& face : surface(mesh))
      if (face.nodes[0] < first_upper && area_vector(mesh.nodes, face).normalized().z() > 0.9) faces.push_back(face);
  }
  template <class Field>
  auto run(Field field) const {
    return Explicit{Scene{mesh.nodes, Part{Hex8{}, Elastic{1000, 1e9, 0.3}, mesh.hexahedra},
                          Tied{nodes, Surface{faces}}, InitialVelocityField{field}}};
  }
};

}  // namespace

TEST_CASE("tied meshes that do not fit move as one, and keep momentum and energy") {
  const Stack stack;
  auto run = stack.run([](const Eigen::Vector3d& x) {  // a turn and a stretch
    const Eigen::Vector3d r = x - Eigen::Vector3d(0.5, 0.5, 1);
    return Eigen::Vector3d(cross<double>(Eigen::Vector3d(0.3, 2, 0.5), r) + Eigen::Vector3d(1, 2, 0.8 * r.z()));
  });
  const auto angular = [&] {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < run.nodes().size(); ++i)
      sum += run.nodes().mass(i) * cross<double>(run.nodes().x(i), run.nodes().v(i));
    return sum;
  };
  const Eigen::Vector3d momentum = run.momentum(), spin = angular();
  for (int n = 0; n < 400; ++n) run.step();
  CHECK((run.momentum() - momentum).norm() < 1e-10 * momentum.norm());
  CHECK((angular() - spin).norm() < 1e-10 * spin.norm());
  CHECK(std::abs(run.energy().error()) < 1e-3);
  CHECK(std::abs(run.energy().contact) < 2e-3 * run.energy().initial);
  for (std::size_t k = 0; k < stack.nodes.size(); ++k) {  // where they were on the faces, by bilinear shares
    const Eigen::Vector3d X = stack.mesh.nodes[stack.nodes[k]];
    Eigen::Vector3d x = Eigen::Vector3d::Zero();
    for (const Face& face : stack.faces) {
      const Eigen::Vector3d lower = stack.mesh.nodes[face.nodes[0]].cwiseMin(stack.mesh.nodes[face.nodes[2]]);
      const Eigen::Vector3d at = 2 * (X - lower);
      if (at.head<2>().minCoeff() < -1e-9 || at.head<2>().maxCoeff() > 1 + 1e-9) continue;
      x.setZero();
      for (const Index i : face.nodes) {
        const Eigen::Vector3d corner = 2 * (stack.mesh.nodes[i] - lower);
        x += (1 - std::abs(at.x() - corner.x())) * (1 - std::abs(at.y() - corner.y())) * run.nodes().x(i);
      }
    }
    CHECK((run.nodes().x(stack.nodes[k]) - x).norm() < 1e-10);
  }
  CHECK(run.template item<1>().sweeps() < 40);
}

TEST_CASE("ties far from the origin take no sweeps for what rounding hides") {
  Stack stack;
  stack.mesh = translated(stack.mesh, {1000, -2000, 500});
  auto run = stack.run([](const Eigen::Vector3d& x) { return Eigen::Vector3d(0, 0, x.z() - 501); });
  for (int n = 0; n < 20; ++n) {
    run.step();
    CHECK(run.template item<1>().sweeps() < 40);
  }
}

TEST_CASE("a node that is not at the surface cannot be tied to it") {
  Stack stack;
  stack.nodes.push_back(static_cast<Index>(stack.mesh.nodes.size() - 1));
  CHECK_THROWS_WITH(stack.run([](const Eigen::Vector3d&) { return Eigen::Vector3d(0, 0, 0); }),
                    Catch::Matchers::ContainsSubstring("node 90 at (1, 1, 2) is farther than"));
  stack.nodes.back() = stack.faces[0].nodes[0];
  CHECK_THROWS_WITH(stack.run([](const Eigen::Vector3d&) { return Eigen::Vector3d(0, 0, 0); }),
                    Catch::Matchers::ContainsSubstring("belongs to"));
}

namespace {

/// Deletes all elements of a part at once.
struct Doomed {
  const bool* now;
  template <class State, class Condition>
  auto keeps(const State&, const Condition& element) const {
    return element.relative_volume() > (*now ? 2.0 : 0.0);
  }
};

}  // namespace

TEST_CASE("the nodes near a surface are those within a distance that do not belong to it") {
  const Stack stack;
  std::vector<Index> all, upper;
  for (Index i = 0; i < stack.mesh.nodes.size(); ++i) {
    all.push_back(i);
    if (i >= stack.first_upper) upper.push_back(i);
  }
  const Surface surface{stack.faces};
  CHECK(nodes_near(stack.mesh.nodes, all, surface, 1e-9) == stack.nodes);
  CHECK(nodes_near(stack.mesh.nodes, upper, surface, 0.33) == stack.nodes);
  CHECK(nodes_near(stack.mesh.nodes, upper, surface, 0.34).size() == 32);    // two layers, 1/3 apart
  CHECK(nodes_near(stack.mesh.nodes, all, surface, 0.51).size() == 32 + 9);  // and one below the faces, 1/2 apart

  const std::vector<Eigen::Vector3d> x{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.2, 0.3}, {0.8, 0.8, 0}, {0, -0.4, 0.3}};
  const Surface triangle{{Face{{0, 1, 2, 2}, 0}}};
  CHECK(nodes_near(x, {3, 4, 5, 0}, triangle, 0.299).empty());
  CHECK(nodes_near(x, {3, 4, 5, 0}, triangle, 0.301) == std::vector<Index>{3});
  CHECK(nodes_near(x, {5, 4, 3, 3}, triangle, 0.425) == std::vector<Index>{3, 4});  // 4 is 0.6/sqrt(2) beside an edge
  CHECK(nodes_near(x, {5, 4, 3}, triangle, 0.501) == std::vector<Index>{3, 4, 5});
  CHECK(nodes_near(x, {}, triangle, 1).empty());
}

TEST_CASE("a tie ends with the element that it is tied to, and not before") {
  const Stack stack;
  const auto middle = stack.mesh.hexahedra.begin() + 8;
  const Cells<8> lower(stack.mesh.hexahedra.begin(), middle), upper(middle, stack.mesh.hexahedra.end());
  const Elastic stiff{1000, 1e9, 0.3};
  bool now = false;
  std::vector<Index> pulled;
  for (Index i = stack.first_upper; i < stack.mesh.nodes.size(); ++i) pulled.push_back(i);
  Explicit run{Scene{stack.mesh.nodes, Part{Hex8{}, stiff, upper}, Part{Hex8{}, stiff, lower, Doomed{&now}},
                     Clamped{nodes_where(stack.mesh.nodes, on_plane(Axis::z, 0))}, NodalForce{{0, 0, 1000}, pulled},
                     Tied{stack.nodes, solid_surface(lower, 1)}},
               ExplicitOptions{.energy_tolerance = 10, .print_warnings = false}};
  const auto& tied = run.item<4>();
  const auto momentum = [&] {
    double p = 0;
    for (const Index i : pulled) p += run.nodes().mass(i) * run.nodes().v(i).z();
    return p;
  };
  run.until(2e-2);
  CHECK(tied.size() == 16);
  CHECK(tied.force().z() < 0);
  now = true;
  run.until(2.5e-2);
  const double before = momentum(), start = run.time();
  run.until(3e-2);
  CHECK(run.part<1>().deleted() == 8);
  CHECK(tied.size() == 0);
  CHECK(tied.force() == Eigen::Vector3d::Zero());
  // The load alone is left: p = F t, to half a step, by which velocities are ahead.
  CHECK(momentum() - before == Approx(1000 * static_cast<double>(pulled.size()) * (run.time() - start)).epsilon(0.02));
}

TEST_CASE("a tie breaks at its strength in tension, in shear and in both, and not under pressure") {
  // A cube on a clamped one; its tied nodes are pulled ever more, each with a force of 1000 t.
  Mesh mesh = box({.size = {1, 1, 1}});
  const std::vector<Face> top{surface(mesh)[1]};
  const Index first = append(mesh, box({.lower = {0, 0, 1}, .size = {1, 1, 1}}));
  const std::vector<Index> tied{first, first + 1, first + 2, first + 3};
  const auto broken_at = [&](const Eigen::Vector3d& direction, TieStrength strength) {
    std::vector<Index> lower(first);
    for (Index i = 0; i < first; ++i) lower[i] = i;
    Explicit run{
        Scene{mesh.nodes, Part{Hex8{}, Elastic{1, 1e7, 0.3}, mesh.hexahedra}, Clamped{lower},
              NodalForce{1000 * direction, tied, [](double t) { return t; }}, Tied{tied, Surface{top}, strength}},
        ExplicitOptions{.energy_tolerance = 10}};
    const auto& ties = run.template contact<0>();
    Eigen::Vector3d last = Eigen::Vector3d::Zero();
    run.until(1, [&] {
      if (ties.size() == 4) last = ties.force();
    });
    CHECK(ties.size() + ties.broken() == 4);
    return ties.broken() == 4 ? 0.25 * last.norm() : 0;
  };
  REQUIRE(area_vector(mesh.nodes, top[0]).z() > 0.99);
  const double inf = std::numeric_limits<double>::infinity();
  // The force of a tie when it breaks, to the steps of a ramp that the cube follows with small swings.
  CHECK(broken_at({0, 0, 1}, {.normal = 300}) == Approx(300).epsilon(2e-3));
  CHECK(broken_at({0, 0, -1}, {.normal = 300}) == 0);
  CHECK(broken_at({1, 0, 0}, {.normal = 300}) == 0);
  CHECK(broken_at({1, 0, 0}, {.shear = 200}) == Approx(200).epsilon(2e-3));
  CHECK(broken_at({0, 0, -1}, {.shear = 200}) == 0);
  CHECK(broken_at({0, 3, 4}, {.normal = 300, .shear = 200}) ==
        Approx(1 / std::hypot(0.8 / 300, 0.6 / 200)).epsilon(5e-3));
  CHECK(broken_at({0, 0, 1}, {inf, inf}) == 0);
  CHECK_THROWS_WITH((Tied{tied, Surface{top}, {.normal = -1}}),
                    "strike: the normal of TieStrength is -1; it must be positive.");
}
