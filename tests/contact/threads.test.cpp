#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include <strike/contact/contact.hpp>
#include <strike/element/hex8.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/load/support.hpp>
#include <strike/mesh/surface.hpp>
#include <strike/mesh/transform.hpp>
#include <strike/motion/openmp.hpp>

#include "problems/column.hpp"
#include "support/catch.hpp"

using namespace strike;

namespace {

/// A body that falls on another and slides on it.
struct Fall {
  Mesh lower, mesh = lower;
  std::vector<Index> upper;
  Cells<8> of_upper;

  Fall(const Mesh& below, const Mesh& above) : lower(below) {
    for (Index i = append(mesh, above); i < mesh.nodes.size(); ++i) upper.push_back(i);
    of_upper.assign(mesh.hexahedra.begin() + static_cast<std::ptrdiff_t>(lower.hexahedra.size()), mesh.hexahedra.end());
  }
  template <class Execution>
  auto run(const Execution& execution) const {
    return Explicit{
        Scene{mesh.nodes, Part{Hex8{}, Elastic{1000, 1e9, 0.3}, mesh.hexahedra},
              Contact{TwoWay{Surface{surface(Mesh{mesh.nodes, of_upper})}, Surface{surface(lower)}}, Coulomb{0.2}},
              InitialVelocity{{0, 5, -20}, upper}},
        {},
        execution};
  }
};

}  // namespace

TEST_CASE("contact gives the same bits for any number of threads") {
  const Fall fall(
      box({.size = {1, 1, 0.3}, .cells = {9, 9, 3}}),
      rotated(box({.lower = {0.2, 0.1, 0.4}, .size = {0.5, 0.5, 0.5}, .cells = {6, 6, 6}}), {1, 0.2, 0}, 0.2));
  const auto after = [&](auto execution) {
    auto run = fall.run(execution);
    for (int n = 0; n < 400; ++n) run.step();
    CHECK(run.template item<1>().impulse().z() > 10);
    return run.positions();
  };
  const auto serial = after(Serial{});
  CHECK(serial == after(OpenMP{1}));
  CHECK(serial == after(OpenMP{2}));
  CHECK(serial == after(OpenMP{5}));
}

TEST_CASE(
    "where hundreds of nodes strike at once, cut at a mirror, every law gives the same bits for any number of "
    "threads") {
  const Mesh lower = box({.size = {1, 1, 0.2}, .cells = {17, 17, 2}});
  Mesh mesh = lower;
  std::vector<Index> upper, cut;
  for (Index i = append(mesh, translated(lower, {0, 0, 0.2})); i < mesh.nodes.size(); ++i) upper.push_back(i);
  for (Index i = 0; i < mesh.nodes.size(); ++i)
    if (mesh.nodes[i].x() == 0) cut.push_back(i);
  const auto check = [&](const auto& law, const auto& friction) {
    const auto after = [&](auto execution) {
      Explicit run{
          Scene{mesh.nodes, Part{Hex8{}, Elastic{1000, 1e9, 0.3}, mesh.hexahedra}, Contact{Everything{}, law, friction},
                Support{cut, {Eigen::Vector3d::UnitX()}}, InitialVelocity{{0, 5, -20}, upper}},
          {},
          execution};
      std::size_t most = 0;
      for (int n = 0; n < 20; ++n) run.step(), most = std::max(most, run.template contact<0>().pairs().size());
      CHECK(most > 512);  // which several threads share
      return run.positions();
    };
    const auto serial = after(Serial{});
    for (const int threads : {1, 2, 3, 8}) CHECK(serial == after(OpenMP{threads}));
  };
  check(Kinematic{}, Frictionless{});
  check(Kinematic{}, Coulomb{0.2});
  check(Penalty{}, Coulomb{0.2});
}

TEST_CASE("edges that cross give the same bits for any number of threads") {
  // Two layers of bars that stand on their edges, across each other.
  constexpr double side = 0.05, turned = 0.25 * std::numbers::pi;
  const Mesh bar = translated(box({.size = {1, side, side}, .cells = {20, 1, 1}}), {-0.5, -0.5 * side, -0.5 * side});
  const auto layer = [&](double z, double about) {
    Mesh bars;
    for (int k = 0; k < 6; ++k) append(bars, translated(rotated(bar, {1, 0, 0}, turned), {0, 0.15 * k - 0.371, z}));
    return rotated(bars, {0, 0, 1}, about);
  };
  const Fall fall(layer(0, 0), layer(1.005 * std::numbers::sqrt2 * side, 1.4));
  const auto after = [&](auto execution) {
    auto run = fall.run(execution);
    std::size_t most = 0;
    for (int n = 0; n < 200; ++n) {
      run.step();
      most = std::max(most, run.template contact<0>().pairs().size());
    }
    CHECK(most > 20);  // of 36 places where bars cross
    return run.positions();
  };
  const auto serial = after(Serial{});
  CHECK(serial == after(OpenMP{2}));
  CHECK(serial == after(OpenMP{5}));
}

TEST_CASE("a node that comes too deep ends a run with one sentence, for any number of threads") {
  const Mesh lower = box({.size = {1, 1, 0.3}, .cells = {9, 9, 3}});
  Mesh mesh = lower;
  std::vector<Index> upper;
  const Mesh block = box({.lower = {0.02, 0.03, 0.301}, .size = {0.9, 0.9, 0.3}, .cells = {12, 12, 3}});
  for (Index i = append(mesh, block); i < mesh.nodes.size(); ++i) upper.push_back(i);
  const auto message = [&](auto execution) -> std::string {
    Explicit run{Scene{mesh.nodes, Part{Hex8{}, Elastic{1000, 1e9, 0.3}, mesh.hexahedra},
                       Contact{NodeToSurface{upper, Surface{surface(lower)}}, Penalty{.stiffness = 1}},
                       InitialVelocity{{0, 0, -50}, upper}},
                 {},
                 execution};
    try {
      for (int n = 0; n < 1000; ++n) run.step();
    } catch (const Error& error) {
      return error.what();
    }
    return {};
  };
  const std::string serial = message(Serial{});
  CHECK_THAT(serial, Catch::Matchers::ContainsSubstring("deep into what it touches"));
  CHECK(serial == message(OpenMP{2}));
}

TEST_CASE("the order of pairs does not count, however few iterations they are given") {
  // Two grids that lie on each other, the nodes of each on faces of the other: no impulses fit all of them.
  const auto grid = [](Index n, double from, double z) {
    std::vector<Eigen::Vector3d> x;
    for (Index j = 0; j < n; ++j)
      for (Index i = 0; i < n; ++i) x.emplace_back(from + i, from + j, z);
    return x;
  };
  constexpr Index n = 9, upper = n * n;
  std::vector<Eigen::Vector3d> x = grid(n, 0, 0);
  for (const auto& at : grid(n, 0.3, 0)) x.push_back(at);
  std::vector<Index> all(x.size());
  std::iota(all.begin(), all.end(), 0u);
  const auto velocities = [&](bool backward, int iterations) {
    Nodes<double> nodes(x, all);
    for (Index i = 0; i < x.size(); ++i) {
      nodes.add_mass(i, 1 + 0.5 * std::sin(i));
      nodes.set_velocity(i, {0, 0, i < upper ? 0.3 * std::sin(i) : -1 + 0.3 * std::cos(2.0 * i)});
    }
    ContactNodes contact;
    contact.begin(nodes, all, {}, {});
    contact.find_held_directions(nodes);
    std::vector<double> stored(2 * x.size(), 0.0);
    std::vector<ContactPair> pairs;
    const auto add = [&](Index node, Index corner, double s, double side) {
      ContactPair pair({0, 0, side}, 0);
      pair.add(node, 1);
      const double N[] = {(1 - s) * (1 - s), s * (1 - s), s * s, s * (1 - s)};
      const Index corners[] = {corner, corner + 1, corner + n + 1, corner + n};
      for (unsigned k = 0; k < 4; ++k) pair.add(corners[k], -N[k]);
      pair.stored = &stored[pairs.size()];
      pairs.push_back(pair);
    };
    for (Index j = 0; j + 1 < n; ++j)
      for (Index i = 0; i + 1 < n; ++i) {
        add(upper + j * n + i, j * n + i, 0.3, 1);
        add((j + 1) * n + i + 1, upper + j * n + i, 0.7, -1);
      }
    if (backward) std::reverse(pairs.begin(), pairs.end());
    contact.gather_forces(nodes, pairs, 0.1, Serial{});
    Kinematic{.iterations = iterations}.press(pairs, contact, Step{1, 0, 0.1, 0.1});
    return contact.v;
  };
  const auto differ = [](const auto& a, const auto& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, (a[i] - b[i]).norm());
    return most;
  };
  for (const int iterations : {1, 5, 50})
    CHECK(differ(velocities(false, iterations), velocities(true, iterations)) < 1e-12);
  CHECK(differ(velocities(false, 5), velocities(false, 500)) > 1e-3);  // they are indeed few
}
