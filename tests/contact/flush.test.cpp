// Bodies that meet exactly face on face, edge on edge and corner on corner, where rounding alone could decide.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include <strike/contact/contact.hpp>
#include <strike/dynamics/explicit.hpp>
#include <strike/element/hex8.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/load/support.hpp>
#include <strike/material/elastic.hpp>
#include <strike/mesh/box.hpp>
#include <strike/mesh/measure.hpp>
#include <strike/mesh/surface.hpp>
#include <strike/mesh/transform.hpp>

#include "contact/bodies.hpp"
#include "problems/balls.hpp"
#include "support/catch.hpp"

using namespace strike;
using testing::apart;

namespace {

using Positions = std::vector<Eigen::Vector3d>;

/// Two bodies in one mesh.
struct Pair {
  Mesh mesh;
  Index first_node;  ///< of the second body
  Cells<8> one, other;

  Pair(const Mesh& a, const Mesh& b) : mesh(a), first_node(append(mesh, b)), one(a.hexahedra) {
    other.assign(mesh.hexahedra.begin() + static_cast<std::ptrdiff_t>(one.size()), mesh.hexahedra.end());
  }
  std::vector<Index> nodes(bool second) const {
    std::vector<Index> numbers;
    const auto end = static_cast<Index>(mesh.nodes.size());
    for (Index i = second ? first_node : 0; i < (second ? end : first_node); ++i) numbers.push_back(i);
    return numbers;
  }
};

const auto two_way = [](const Pair& pair) { return TwoWay{solid_surface(pair.one, 0), solid_surface(pair.other, 1)}; };
const auto swapped = [](const Pair& pair) { return TwoWay{solid_surface(pair.other, 1), solid_surface(pair.one, 0)}; };
const auto by_itself = [](const Pair& pair) { return SelfContact{Surface{hexahedron_surface(pair.mesh.hexahedra)}}; };
const auto one_way = [](const Pair& pair) { return NodeToSurface{pair.nodes(true), solid_surface(pair.one, 0)}; };

/// A cube of n cells along each edge falls on another, which lies below it, after a turn of the whole scene.
template <class Pairing, class Law>
Positions fall(Index n, double shift, const Eigen::Matrix3d& turn, const Pairing& pairing, const Law& law) {
  const Elastic elastic{.density = 1, .youngs_modulus = 100, .poissons_ratio = 0.3};
  Pair cubes(box({.size = {1, 1, 1}, .cells = {n, n, n}}),
             box({.lower = {shift, shift, 1.05}, .size = {1, 1, 1}, .cells = {n, n, n}}));
  const std::vector<Index> base = nodes_where(cubes.mesh.nodes, on_plane(Axis::z, 0));
  for (auto& x : cubes.mesh.nodes) x = turn * x;
  Explicit run{Scene{cubes.mesh.nodes, Part{Hex8{}, elastic, cubes.one}, Part{Hex8{}, elastic, cubes.other},
                     InitialVelocity{turn * Eigen::Vector3d(0, 0, -0.5), cubes.nodes(true)}, Clamped{base},
                     Contact{pairing(cubes), law}},
               ExplicitOptions{.step_factor = 0.5}};
  run.until(0.6);
  Positions x = run.positions();
  for (auto& at : x) at = turn.transpose() * at;
  return x;
}
const Eigen::Matrix3d unturned = Eigen::Matrix3d::Identity();

/// Two equal bars of 20 cells along z that fly at each other.
template <class Law>
struct Impact {
  double rebound = 0, across = 0;  ///< of the first bar's mean velocity, and the largest across, over that before

  Impact(Index n, double gap, bool skins, const Law& law) {
    const Elastic elastic{.density = 1, .youngs_modulus = 1, .poissons_ratio = 0};
    const double v = 0.01;
    const Pair bars(box({.lower = {0, 0, -10}, .size = {1, 1, 10}, .cells = {n, n, 20}}),
                    box({.lower = {0, 0, gap}, .size = {1, 1, 10}, .cells = {n, n, 20}}));
    const auto end = [&](const Cells<8>& cells, double z) {
      std::vector<Face> faces;
      for (const Face& face : hexahedron_surface(cells))
        if (std::abs(centroid(bars.mesh.nodes, face).z() - z) < 1e-9) faces.push_back(face);
      return Surface{faces};
    };
    using Element = Hex8<ViscousHourglass, HughesWinget, NoBulkViscosity>;
    Explicit run{Scene{bars.mesh.nodes, Part{Element{}, elastic, bars.one}, Part{Element{}, elastic, bars.other},
                       InitialVelocity{{0, 0, v}, bars.nodes(false)}, InitialVelocity{{0, 0, -v}, bars.nodes(true)},
                       Contact{skins ? two_way(bars) : TwoWay{end(bars.one, 0), end(bars.other, gap)}, law}}};
    run.until(30 + gap / (2 * v), [&] {
      for (Index i = 0; i < bars.mesh.nodes.size(); ++i) across = std::max(across, run.nodes().v(i).head(2).norm() / v);
    });
    double momentum = 0, mass = 0;
    for (const Index i : bars.nodes(false))
      momentum += run.nodes().mass(i) * run.nodes().v(i).z(), mass += run.nodes().mass(i);
    rebound = momentum / (mass * v);
  }
};

}  // namespace

TEST_CASE("equal bars exchange their velocities, by their end faces or their whole skins") {
  const auto exchange = [](auto law, double first_impact) {
    for (const Index n : {1u, 2u})
      for (const double gap : {0.0, 0.05}) {
        CAPTURE(n, gap);
        const Impact skins(n, gap, true, law), ends(n, gap, false, law);
        CHECK(skins.rebound == Approx(ends.rebound).epsilon(1e-12));
        CHECK(skins.rebound == Approx(first_impact - 1).margin(0.02));  // waves of 20 cells disperse
        CHECK(skins.across < 1e-12);
      }
  };
  exchange(Kinematic{}, 1.0 / 40);  // an inelastic impact of the end nodes
  exchange(Penalty{}, 0);
}

TEST_CASE("the answer of flush cubes does not depend on rounding, on angles or on how the contact is said") {
  const Eigen::Matrix3d turned = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const auto check = [&](auto law) {
    for (const Index n : {1u, 3u}) {
      CAPTURE(n);
      const Positions expected = fall(n, 0, unturned, two_way, law);
      CHECK(expected.back().z() > 1.5);  // it has not come through
      // Contacts open and close from step to step, which lets rounding grow; the centre moves by 0.1.
      for (const double shift : {1e-15, 1e-12, 1e-9})
        CHECK(apart(fall(n, shift, unturned, two_way, law), expected) < 3e-4);
      CHECK(apart(fall(n, 0, turned, two_way, law), expected) < 3e-4);
      CHECK(apart(fall(n, 0, unturned, swapped, law), expected) < 3e-4);  // the order in which pairs are corrected
      CHECK(apart(fall(n, 0, unturned, by_itself, law), expected) < 3e-4);
      CHECK(apart(fall(n, 0, turned, by_itself, law), expected) < 3e-4);
      CHECK(apart(fall(n, 0, unturned, one_way, law), expected) < 1e-2);  // nodes on nodes: half of the pairs
    }
  };
  check(Kinematic{});
  check(Penalty{});
}

TEST_CASE("a model cut at its planes of symmetry gives the answer of the whole") {
  // A ball-like block falls on a slab; whole, and a quarter with two planes of symmetry, at an angle.
  const auto strike_slab = [](bool quarter, const Eigen::Matrix3d& turn, auto law) {
    const double low = quarter ? 0.0 : -1.0, size = quarter ? 1.0 : 2.0;
    const Index n = quarter ? 2 : 4;
    Pair bodies(
        box({.lower = {low, low, -0.5}, .size = {size, size, 0.5}, .cells = {n, n, 1}}),
        box({.lower = {0.5 * low, 0.5 * low, 0.02}, .size = {0.5 * size, 0.5 * size, 0.5}, .cells = {n, n, 2}}));
    const auto on = [&](Axis axis) { return nodes_where(bodies.mesh.nodes, on_plane(axis, 0)); };
    const std::vector<Index> x0 = quarter ? on(Axis::x) : std::vector<Index>{}, y0 = quarter ? on(Axis::y) : x0;
    const std::vector<Index> base = nodes_where(bodies.mesh.nodes, on_plane(Axis::z, -0.5));
    const Positions start = bodies.mesh.nodes;
    for (auto& x : bodies.mesh.nodes) x = turn * x;
    const Elastic elastic{.density = 1, .youngs_modulus = 100, .poissons_ratio = 0.3};
    Explicit run{Scene{bodies.mesh.nodes, Part{Hex8{}, elastic, bodies.one}, Part{Hex8{}, elastic, bodies.other},
                       InitialVelocity{turn * Eigen::Vector3d(0, 0, -0.5), bodies.nodes(true)}, Clamped{base},
                       Symmetry{turn.col(0), x0}, Symmetry{turn.col(1), y0}, Contact{two_way(bodies), law}}};
    run.until(0.5);
    Positions kept;  // of the nodes that both models have, in the order of the quarter's
    for (Index i = 0; i < start.size(); ++i)
      if (start[i].x() > -1e-9 && start[i].y() > -1e-9) kept.push_back(turn.transpose() * run.nodes().x(i));
    return kept;
  };
  const Eigen::Matrix3d turned = Eigen::AngleAxisd(0.5, Eigen::Vector3d(3, -1, 2).normalized()).toRotationMatrix();
  const auto check = [&](auto law) {
    const Positions whole = strike_slab(false, unturned, law);
    CHECK(apart(strike_slab(true, unturned, law), whole) < 3e-4);
    CHECK(apart(strike_slab(true, turned, law), whole) < 3e-4);
    CHECK(whole.back().z() > 0.45);
  };
  check(Kinematic{});
  check(Penalty{});
}

TEST_CASE("a node in an inner corner touches all its faces, of one body or of several") {
  // A floor at z = 1 and a wall at x = 1: cells of an L, or the wall as a body of its own that stands on the floor.
  Mesh el = box({.size = {2, 2, 2}, .cells = {2, 2, 2}});
  std::erase_if(el.hexahedra, [&](const auto& cell) {
    const Eigen::Vector3d at = centroid<8>(el.nodes, cell);
    return at.x() > 1 && at.z() > 1;
  });
  Mesh stands = box({.size = {2, 2, 1}, .cells = {2, 2, 1}});
  append(stands, box({.lower = {0, 0, 1}, .size = {1, 2, 1}, .cells = {1, 2, 1}}));
  for (const Mesh& corner : {el, stands})
    for (const double speed : {0.1, 10.0}) {
      Positions x = corner.nodes, v(x.size(), Eigen::Vector3d::Zero());
      std::vector<double> mass(x.size(), 1e12);
      std::vector<Index> balls;
      // Along the floor, down the wall, over both edges of cells, into the edge and, with two walls, onto its node.
      for (const Eigen::Vector3d& to : {Eigen::Vector3d(-1, 0, -1), {-1, 0, -0.1}, {-0.1, 0, -1}, {-1, 0.3, -1}}) {
        balls.push_back(static_cast<Index>(x.size()));
        x.push_back({1.5, 1.0, 1.5}), v.push_back(speed * to), mass.push_back(1);
      }
      testing::Balls run(x, v, mass, Contact{NodeToSurface{balls, Surface{hexahedron_surface(corner.hexahedra)}}});
      double lowest = 1;
      for (int n = 0; n < 300; ++n) {
        run.step(0.01, {-0.2, 0, -0.3});
        for (const Index i : balls)
          if (run.nodes.x(i).y() < 2) lowest = std::min({lowest, run.nodes.x(i).x(), run.nodes.x(i).z()});
      }
      CHECK(lowest > 1 - 1e-6 * speed * 0.01);  // the law's 1e-6 of the approach in a step
      CHECK((run.nodes.x(balls[0]) - Eigen::Vector3d(1, 1, 1)).norm() < 1e-9);
    }
}

TEST_CASE("what begins deep inside a body is counted and its depth is the true one") {
  // 4x4x4 cells of 0.4 of a cube of 1.6, by an overlap from above in a larger cube: whole layers of nodes are inside.
  const auto warning = [](double overlap, const auto& pairing) {
    const Pair cubes(box({.size = {4, 4, 4}, .cells = {8, 8, 8}}),
                     box({.lower = {1.1, 1.1, 4 - overlap}, .size = {1.6, 1.6, 1.6}, .cells = {4, 4, 4}}));
    const auto& x = cubes.mesh.nodes;
    testing::Balls run(x, Positions(x.size(), Eigen::Vector3d::Zero()), std::vector<double>(x.size(), 1),
                       Contact{pairing(cubes)});
    run.step(1e-3);
    CHECK(run.contact.penetration() == 0);  // held there without force
    CHECK(run.energy() == 0);
    return run.contact.warning();
  };
  using Catch::Matchers::ContainsSubstring;
  CHECK(warning(0, by_itself) == "");
  CHECK_THAT(warning(0.3, one_way), ContainsSubstring("25 nodes begin inside") && ContainsSubstring("by 0.3;"));
  CHECK_THAT(warning(1, one_way), ContainsSubstring("75 nodes begin inside") && ContainsSubstring("by 1;"));
  // Of the skin 25 + 2 * 16, and the 9 of the larger cube that stand in the smaller one.
  CHECK_THAT(warning(1, two_way), ContainsSubstring("66 nodes begin inside") && ContainsSubstring("by 1;"));
  CHECK_THAT(warning(1, by_itself), ContainsSubstring("66 nodes begin inside") && ContainsSubstring("by 1;"));
}
