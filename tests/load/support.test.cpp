#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include <strike/dynamics/explicit.hpp>
#include <strike/element/plate4.hpp>
#include <strike/load/support.hpp>
#include <strike/material/plane_stress.hpp>
#include <strike/mesh/select.hpp>
#include <strike/mesh/sheet.hpp>
#include <strike/section/layered.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {

const Homogeneous section{PlaneStress{Elastic{1000, 1e8, 0.3}}, 0.05};

/// Nodes move and turn as a field of the positions tells.
template <class F>
struct Launched {
  F field;  ///< of x: velocity and angular velocity
  template <class N>
  void begin(N& nodes) const {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const auto [v, w] = field(nodes.x(i));
      nodes.set_velocity(i, v), nodes.set_angular_velocity(i, w);
    }
  }
};
template <class F>
Launched(F) -> Launched<F>;

/// A square whose nodes start to move and turn each in its own way, under some supports.
template <class... Supports>
auto shaken(Supports... supports) {
  const Mesh mesh = rectangle({.size = {1, 1}, .cells = {4, 4}});
  const auto field = [](const Eigen::Vector3d& x) {
    const Eigen::Array3d phase(10 * x.x() + 1, 20 * x.y() + 2, 30 * (x.x() - x.y()) + 3);
    return std::pair<Eigen::Vector3d, Eigen::Vector3d>{phase.sin(), phase.cos()};
  };
  Explicit run{Scene{mesh.nodes, Part{Plate4{}, section, mesh.quadrilaterals}, Launched{field}, std::move(supports)...},
               ExplicitOptions{.largest_step = 1e-4}};
  for (int i = 0; i < 100; ++i) run.step();
  CHECK(std::abs(run.energy().error()) < 0.02);  // the start is a jolt
  return run;
}

/// A rectangle from x = left to 1 that swings as its mirror image about x = 0.
template <class... Supports>
auto swung(double left, Index cells, Supports... supports) {
  const Mesh mesh = rectangle({.lower = {left, 0, 0}, .size = {1 - left, 1}, .cells = {cells, 4}});
  const auto field = [](const Eigen::Vector3d& x) {
    return std::pair{Eigen::Vector3d(x.x() * x.y(), x.x() * x.x(), 3 * std::cos(x.x()) * x.y()),
                     Eigen::Vector3d(x.x() * x.x() - x.y(), x.x(), x.x() * x.y())};
  };
  Explicit run{Scene{mesh.nodes, Part{Plate4{}, section, mesh.quadrilaterals}, Launched{field}, std::move(supports)...},
               ExplicitOptions{.largest_step = 2e-4}, in<double>};
  for (int i = 0; i < 200; ++i) run.step();
  return run;
}

std::vector<Index> edge() {
  return nodes_where(rectangle({.size = {1, 1}, .cells = {4, 4}}).nodes, on_plane(Axis::x, 0));
}

}  // namespace

TEST_CASE("clamped nodes neither move nor turn, hinged ones turn, and all others do both") {
  const auto clamped = shaken(Clamped{edge()});
  const auto hinged = shaken(Pinned{edge()});
  for (const Index i : edge()) {
    CHECK(clamped.nodes().v(i).norm() + clamped.nodes().w(i).norm() == 0);
    CHECK(hinged.nodes().v(i).norm() == 0);
    CHECK(hinged.nodes().w(i).cwiseAbs().minCoeff() > 0);
  }
  for (const auto* nodes : {&clamped.nodes(), &hinged.nodes()}) {
    CHECK(nodes->v(2).cwiseAbs().minCoeff() > 0);
    CHECK(nodes->w(2).cwiseAbs().minCoeff() > 0);
  }
}

TEST_CASE("nodes in a plane of symmetry move in it and turn about its normal alone, at any angle") {
  for (const Eigen::Vector3d& normal : {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(1, -2, 3)}) {
    const auto run = shaken(Symmetry{normal, edge()});
    for (const Index i : edge()) {
      const Eigen::Vector3d v = run.nodes().v(i), w = run.nodes().w(i);
      CHECK(std::abs(v.dot(normal)) < 1e-15 * normal.norm());
      CHECK(w.cross(normal).norm() < 1e-14 * normal.norm());
      CHECK(std::abs(w.dot(normal)) > 0);
    }
  }
}

TEST_CASE("supports that meet at a node leave what is at right angles to all of them, in any order") {
  const Support slides{edge(), {{1, 1, 0}}, {{0, 1, 1}}}, turns{edge(), {{0, 1, 0}}, {{0, 1, 0}}};
  const auto one = shaken(slides, turns), other = shaken(turns, slides);
  for (const Index i : edge()) {
    CHECK(one.nodes().v(i).head<2>().norm() < 1e-15);
    CHECK(one.nodes().w(i).tail<2>().norm() < 1e-14);
    CHECK((one.nodes().v(i) - other.nodes().v(i)).norm() < 1e-13);
    CHECK((one.nodes().w(i) - other.nodes().w(i)).norm() < 1e-12);
  }
}

TEST_CASE("half a plate with a plane of symmetry is the half of a whole one") {
  const auto whole = swung(-1, 8);
  const auto half = swung(0, 4, Symmetry{Axis::x, edge()});
  for (Index j = 0; j < 5; ++j)
    for (Index i = 0; i < 5; ++i) {
      CHECK((half.nodes().x(5 * j + i) - whole.nodes().x(9 * j + i + 4)).norm() < 1e-13);
      CHECK((half.nodes().w(5 * j + i) - whole.nodes().w(9 * j + i + 4)).norm() < 1e-10);  // over h = 0.05
    }
  CHECK(2 * half.energy().internal == Approx(whole.energy().internal).epsilon(1e-10));
}
