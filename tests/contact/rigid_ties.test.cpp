// Rigid bodies under ties, relaxation, subcycling and the step of the mesh as a whole.
#include <algorithm>
#include <cmath>
#include <vector>

#include <strike/contact/tied.hpp>
#include <strike/dynamics/dynamic_relaxation.hpp>
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

#include "support/catch.hpp"

using namespace strike;
using Eigen::Vector3d;

namespace {

/// An elastic block under a rigid one of other cells, tied where they meet at z = 1.
struct Tie {
  Mesh mesh = box({.size = {1, 1, 1}, .cells = {3, 3, 3}}), upper;
  Cells<8> soft = mesh.hexahedra, stiff;
  std::vector<Index> nodes_of_soft, nodes_of_stiff;
  std::vector<Face> of_soft, of_stiff;

  Tie() {
    const auto first = static_cast<Index>(mesh.nodes.size());
    upper = box({.lower = {0, 0, 1}, .size = {1, 1, 1}, .cells = {2, 2, 2}});
    stiff = upper.hexahedra;
    for (auto& cell : stiff)
      for (Index& i : cell) i += first;
    mesh.nodes.insert(mesh.nodes.end(), upper.nodes.begin(), upper.nodes.end());
    for (Index i = 0; i < mesh.nodes.size(); ++i)
      if (std::abs(mesh.nodes[i].z() - 1) < 1e-9) (i < first ? nodes_of_soft : nodes_of_stiff).push_back(i);
    const auto meeting = [&](const Cells<8>& cells) {
      std::vector<Face> faces;
      for (const Face& face : surface(Mesh{mesh.nodes, cells}))
        if (std::all_of(face.nodes.begin(), face.nodes.end(),
                        [&](Index i) { return std::abs(mesh.nodes[i].z() - 1) < 1e-9; }))
          faces.push_back(face);
      return faces;
    };
    of_soft = meeting(soft), of_stiff = meeting(stiff);
  }
  auto run(double density, const Tied& tied) const {
    return Explicit{Scene{mesh.nodes, Part{Hex8{}, Elastic{1000, 1e6, 0.3}, soft},
                          RigidBody{Mesh{mesh.nodes, stiff}, density}, tied,
                          InitialVelocity{{1, 2, 3}, Spin{{0.5, 2, 3}, {0.3, 0.2, 1}}}}};
  }
};
template <class Run>
Vector3d angular_momentum(const Run& run) {
  const RigidMotion& body = run.nodes().bodies()[0];
  Vector3d sum = body.angular_momentum() + body.centre().cross(body.momentum());
  for (std::size_t i = 0; i < run.nodes().size(); ++i)
    if (!run.nodes().is_rigid(i)) sum += run.nodes().mass(i) * Vector3d(run.nodes().x(i)).cross(run.nodes().v(i));
  return sum;
}

}  // namespace

TEST_CASE("a tie gives its force and moment to a rigid body, light or heavy, whichever side is the body") {
  const Tie all;
  for (const double density : {10.0, 1000.0, 1e5})
    for (const bool body_is_surface : {true, false}) {
      INFO(density << " " << body_is_surface);
      auto run = all.run(density, body_is_surface ? Tied{all.nodes_of_soft, Surface{all.of_stiff}}
                                                  : Tied{all.nodes_of_stiff, Surface{all.of_soft}});
      const Vector3d momentum = run.momentum(), L = angular_momentum(run);
      int sweeps = 0;
      for (int n = 0; n < 200; ++n) run.step(), sweeps = std::max(sweeps, run.template item<2>().sweeps());
      CHECK((run.momentum() - momentum).norm() < 1e-10 * momentum.norm());
      // A step is straight and a turn is not: points 0.7 from the axis are off by r (w dt)^2/2 at its end.
      const double turned = run.nodes().bodies()[0].angular_velocity().norm() * run.dt(), off = 0.35 * turned * turned;
      CHECK((angular_momentum(run) - L).norm() < off * L.norm());
      CHECK(std::abs(run.energy().error()) < 1e-3);
      double apart = 0;  // the middle of the joint, a node of the body, and the four of the soft block around it
      Vector3d middle = Vector3d::Zero(), mean = middle;
      for (const Index i : all.nodes_of_stiff)
        if ((all.mesh.nodes[i] - Vector3d(0.5, 0.5, 1)).norm() < 1e-9) middle = run.positions()[i];
      for (const Index i : all.nodes_of_soft)
        if ((all.mesh.nodes[i] - Vector3d(0.5, 0.5, 1)).norm() < 0.3) mean += 0.25 * run.positions()[i];
      apart = (middle - mean).norm();
      CHECK(apart < off);
      CHECK(sweeps < 5000);
    }
}

namespace {

/// A bar of two parts, the fine one on a rigid block at its end.
struct Ended {
  Mesh mesh = box({.size = {0.1, 0.1, 1}, .cells = {1, 1, 10}});
  Cells<8> bar, block;
  std::vector<Index> foot = nodes_where(mesh.nodes, on_plane(Axis::z, 0));

  Ended() {
    for (const auto& cell : mesh.hexahedra) (mesh.nodes[cell[0]].z() > 0.75 ? block : bar).push_back(cell);
  }
  template <class... Policies>
  auto run(const Inertia& own, const Policies&... policies) const {
    return Explicit{Scene{mesh.nodes, Part{Hex8{}, Elastic{1000, 1e6, 0}, bar}, RigidBody{Mesh{mesh.nodes, block}, own},
                          BodyForce{{0, 0, -0.1}}, Pinned{foot}},
                    ExplicitOptions{}, policies...};
  }
};

}  // namespace

TEST_CASE("relaxation stops rigid bodies too: a weight off the axis of a bar bends and presses it as in statics") {
  const Ended all;
  // Off the nodes by more than their extent.
  auto run =
      all.run(Inertia{2, {0.05 + 0.1, 0.05, 0.9}, {0.02, 0.02, 0.02, 0, 0, 0}}, DynamicRelaxation{.tolerance = 1e-4});
  run.until(at_rest);
  const double L = 0.8, E = 1e6, A = 0.01, I = 0.1 * 0.1 * 0.1 * 0.1 / 12, e = 0.1;
  const RigidMotion& body = run.nodes().bodies()[0];
  const double turn = std::asin(body.rotation()(0, 2));
  CHECK(turn == Approx(2 * 0.1 * e * L / (E * I)).epsilon(0.02));  // the weights lean out: 1.4 %
  const auto top = nodes_where(all.mesh.nodes, on_plane(Axis::z, L));
  double down = 0;
  for (const Index i : top) down += 0.25 * (all.mesh.nodes[i] - run.positions()[i]).z();
  const double pressed = 0.1 * (2 * L / (E * A) + 1000 * L * L / (2 * E));
  // Bending shortens it by the integral of slope^2/2, L turn^2/6.
  CHECK(down == Approx(pressed + L * turn * turn / 6).epsilon(0.02));
  CHECK(std::abs(run.energy().error()) < 1e-3);
  CHECK(run.energy().kinetic < 1e-6 * run.energy().internal);
}

TEST_CASE("the step of the mesh as a whole holds for a rigid body whose inertia is far below that of its nodes") {
  const Ended all;
  const Inertia point{0.05, {0.05, 0.05, 0.8}, {1e-7, 1e-7, 1e-7, 0, 0, 0}};
  auto plain = all.run(point);
  auto bound = all.run(point, GlobalStep{});
  plain.until(0.25), bound.until(0.25);  // two and a half swings, of 4 L/c = 0.1
  double apart = 0, moved = 0;
  for (std::size_t i = 0; i < all.mesh.nodes.size(); ++i) {
    apart = std::max(apart, (plain.positions()[i] - bound.positions()[i]).norm());
    moved = std::max(moved, (plain.positions()[i] - all.mesh.nodes[i]).norm());
  }
  CHECK(apart < 0.02 * moved);  // longer steps
  CHECK(bound.steps() < plain.steps());
  CHECK(std::abs(bound.energy().error()) < 1e-2);
}

TEST_CASE("subcycling: a rigid body between a slow part and a fast one moves as without") {
  Mesh mesh = box({.size = {0.1, 0.1, 1.4}, .cells = {1, 1, 14}});
  Cells<8> slow, fast, block;
  for (const auto& cell : mesh.hexahedra) {
    const double z = mesh.nodes[cell[0]].z();
    (z < 0.75 ? slow : z < 0.95 ? block : fast).push_back(cell);
  }
  const auto run = [&](const auto&... policies) {
    return Explicit{
        Scene{mesh.nodes, Part{Hex8{}, Elastic{1000, 1e6, 0.3}, slow}, Part{Hex8{}, Elastic{1000, 3e7, 0.3}, fast},
              RigidBody{Mesh{mesh.nodes, block}, 2000}, BodyForce{{0, 0.5, -1}},
              Pinned{nodes_where(mesh.nodes, on_plane(Axis::z, 0))}, InitialVelocity{{0.02, 0, 0.05}}},
        ExplicitOptions{}, policies...};
  };
  auto plain = run();
  auto cycled = run(Subcycling{});
  CHECK(cycled.cycle().multiple() > 2);
  plain.until(0.1), cycled.until(0.1);
  double apart = 0, moved = 0;
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    apart = std::max(apart, (plain.positions()[i] - cycled.positions()[i]).norm());
    moved = std::max(moved, (plain.positions()[i] - mesh.nodes[i]).norm());
  }
  CHECK(apart < 0.01 * moved);
  CHECK(std::abs(cycled.energy().error()) < 5e-3);
}
