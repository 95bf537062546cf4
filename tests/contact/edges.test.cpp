// Edges on edges, where no node is near a face.
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>

#include <strike/contact/contact.hpp>
#include <strike/dynamics/explicit.hpp>
#include <strike/element/hex8.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/material/elastic.hpp>
#include <strike/mesh/box.hpp>
#include <strike/mesh/sheet.hpp>
#include <strike/mesh/surface.hpp>
#include <strike/mesh/transform.hpp>

#include "problems/balls.hpp"
#include "support/catch.hpp"

using namespace strike;

namespace {

const Elastic elastic{.density = 1, .youngs_modulus = 100, .poissons_ratio = 0.3};

/// Heights of the centres of two bodies of hexahedra, the second of which falls on the first, at the time `end`, and
/// the changes of their momentum and of its moment over the momentum before.
struct Fall {
  double lower = 0, upper = 0, momentum = 0, moment = 0;

  template <class Law>
  Fall(const Mesh& one, const Mesh& other, double end, const Law& law, bool by_itself = false,
       const Eigen::Matrix3d& turn = Eigen::Matrix3d::Identity()) {
    Mesh mesh = one;
    const Index first = append(mesh, other);
    for (auto& x : mesh.nodes) x = turn * x;
    std::vector<Index> falling;
    for (Index i = first; i < mesh.nodes.size(); ++i) falling.push_back(i);
    const auto middle = mesh.hexahedra.begin() + static_cast<std::ptrdiff_t>(one.hexahedra.size());
    const auto skin = [](auto begin, auto stop) { return Surface{hexahedron_surface(Cells<8>(begin, stop))}; };
    const auto fall = [&](const auto& pairing) {
      Explicit run{Scene{mesh.nodes, Part{Hex8{}, elastic, mesh.hexahedra},
                         InitialVelocity{turn * Eigen::Vector3d(0, 0, -0.5), falling}, Contact{pairing, law}},
                   ExplicitOptions{.step_factor = 0.5}};
      const auto sums = [&] {
        std::pair<Eigen::Vector3d, Eigen::Vector3d> sum{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
        for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
          const Eigen::Vector3d p = run.nodes().mass(i) * run.nodes().v(i);
          sum.first += p, sum.second += run.nodes().x(i).cross(p);
        }
        return sum;
      };
      const auto before = sums();
      run.until(end);
      const auto after = sums();
      momentum = (after.first - before.first).norm() / before.first.norm();
      moment = (after.second - before.second).norm() / before.first.norm();
      double mass[2] = {0, 0}, height[2] = {0, 0};
      for (Index i = 0; i < mesh.nodes.size(); ++i) {
        const int k = i < first ? 0 : 1;
        mass[k] += run.nodes().mass(i);
        height[k] += run.nodes().mass(i) * turn.col(2).dot(run.nodes().x(i));
      }
      lower = height[0] / mass[0], upper = height[1] / mass[1];
    };
    if (by_itself)
      fall(SelfContact{skin(mesh.hexahedra.begin(), mesh.hexahedra.end())});
    else
      fall(TwoWay{skin(mesh.hexahedra.begin(), middle), skin(middle, mesh.hexahedra.end())});
  }
};

Mesh cube(Index n, const Eigen::Vector3d& lower) {
  return box({.lower = lower, .size = {1, 1, 1}, .cells = {n, n, n}});
}
const Eigen::Matrix3d turned = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();

}  // namespace

TEST_CASE("cubes of one cell answer alike when one is shifted or turned a little") {
  const auto check = [](auto law) {
    const Mesh below = cube(1, {-0.5, -0.5, -1});
    const Fall flush(below, cube(1, {-0.5, -0.5, 0.02}), 0.5, law);
    CHECK(flush.upper - flush.lower > 0.9);
    for (const double shift : {1e-9, 1e-4, 1e-3, 0.012})
      for (const bool by_itself : {false, true}) {
        CAPTURE(shift, by_itself);
        const Fall shifted(below, cube(1, {-0.5 + shift, -0.5 + shift, 0.02}), 0.5, law, by_itself);
        CHECK(std::abs(shifted.upper - flush.upper) < 0.01 * 0.25 + shift);  // the fall is 0.25 long
        CHECK(shifted.momentum < 1e-12);
        CHECK(shifted.moment < 1e-11);
      }
    for (const double angle : {1e-4, 1e-3, 0.01}) {
      CAPTURE(angle);
      const Fall turned_a_little(below, rotated(cube(1, {-0.5, -0.5, 0.02}), {0, 0, 1}, angle), 0.5, law);
      CHECK(std::abs(turned_a_little.upper - flush.upper) < 0.01 * 0.25 + angle);
    }
    // By 45 degrees: no corner is over a face.
    const Mesh star = rotated(cube(1, {-0.5, -0.5, 0.02}), {0, 0, 1}, std::numbers::pi / 4);
    const Fall crossed(below, star, 0.5, law), at_an_angle(below, star, 0.5, law, false, turned);
    CHECK(crossed.upper - crossed.lower > 0.9);
    CHECK(at_an_angle.upper == Approx(crossed.upper).margin(1e-6));
    CHECK(crossed.moment < 1e-11);
  };
  check(Kinematic{});
  check(Penalty{});
}

TEST_CASE("ridges that cross stop each other, and fly past where they do not") {
  const auto beam = [](const Eigen::Vector3d& axis, const Eigen::Vector3d& at) {
    const bool along_y = axis.y() != 0;
    const Eigen::Vector3d half = along_y ? Eigen::Vector3d(0.5, 2, 0.5) : Eigen::Vector3d(2, 0.5, 0.5);
    const Mesh bar = box({.lower = -half, .size = 2 * half, .cells = {along_y ? 1u : 4u, along_y ? 4u : 1u, 1}});
    return translated(rotated(bar, axis, std::numbers::pi / 4), at);
  };
  const Mesh below = beam({0, 1, 0}, {0, 0.3, -0.75});
  const auto check = [&](auto law) {
    const Fall hit(below, beam({1, 0, 0}, {0.3, 0, 0.75}), 4, law);
    CHECK(hit.upper - hit.lower > 1);  // 1.41 as they are, less what bends; -0.5 without contact
    const Fall turned_hit(below, beam({1, 0, 0}, {0.3, 0, 0.75}), 4, law, true, turned);
    CHECK(turned_hit.upper == Approx(hit.upper).margin(1e-3));
    const Fall missed(below, beam({1, 0, 0}, {0.3, 3.1, 0.75}), 4, law);
    CHECK(missed.upper == Approx(0.75 - 0.5 * 4).epsilon(1e-9));
  };
  check(Kinematic{});
  check(Penalty{});
}

TEST_CASE("the edge of a thin blade meets a ridge that crosses it") {
  Mesh blade = box({.lower = {-0.5, -2, -1}, .size = {1, 4, 1}, .cells = {1, 4, 1}});
  for (auto& x : blade.nodes) x.x() *= x.z() > -0.5 ? 1e-3 : 0.1;
  const Mesh bar = translated(
      rotated(box({.lower = {-2, -0.5, -0.5}, .size = {4, 1, 1}, .cells = {4, 1, 1}}), {1, 0, 0}, std::numbers::pi / 4),
      {0.3, 0.1, 0.8});
  const Fall hit(blade, bar, 1.0, Kinematic{});
  CHECK(hit.momentum < 1e-11);
  CHECK(hit.lower < -0.75);  // the light blade, whose centre was at -0.5, is pushed on
}

TEST_CASE("plates that meet edge on edge do so at their thickness, whatever the order of their corners") {
  // In the planes xz and yz: the edges cross as an X, 0.12 apart, at the thickness 0.1.
  for (const unsigned flips : {0u, 1u, 2u, 3u})
    for (const bool by_itself : {false, true}) {
      Mesh mesh = sheet({4, 4}, [](double u, double v) { return Eigen::Vector3d(4 * u - 2, 0.0, 2 * v - 2.06); });
      const std::size_t first = mesh.quadrilaterals.size();
      const Index first_node = append(
          mesh, sheet({4, 4}, [](double u, double v) { return Eigen::Vector3d(0.6, 4 * u - 1.6, 2 * v + 0.06); }));
      for (std::size_t e = 0; e < mesh.quadrilaterals.size(); ++e) {
        auto& c = mesh.quadrilaterals[e];
        if (flips >> (e < first ? 0 : 1) & 1) c = {c[0], c[3], c[2], c[1]};
      }
      std::vector<Eigen::Vector3d> v(mesh.nodes.size(), Eigen::Vector3d::Zero());
      for (std::size_t i = first_node; i < v.size(); ++i) v[i] = {0, 0, -1};
      const auto middle = mesh.quadrilaterals.begin() + static_cast<std::ptrdiff_t>(first);
      const auto skin = [](auto begin, auto end) { return Surface{quadrilateral_surface(Cells<4>(begin, end)), 0.1}; };
      const auto fly = [&](const auto& pairing) {
        testing::Balls run(mesh.nodes, v, std::vector<double>(v.size(), 1), Contact{pairing});
        run.step(0.01);
        CHECK(run.contact.pairs().empty());
        for (int n = 0; n < 3; ++n) run.step(0.01);
        REQUIRE(run.contact.pairs().size() == 1);
        const ContactPair& pair = run.contact.pairs()[0];
        CHECK(pair.count == 4);
        CHECK(std::abs(pair.normal.z()) == Approx(1));
        CHECK(pair.gap == Approx(0).margin(1e-5));  // the edges turn
        CHECK(run.momentum().norm() == Approx(25).epsilon(1e-12));
        CHECK(run.energy() < run.begin_energy);
      };
      if (by_itself)
        fly(SelfContact{skin(mesh.quadrilaterals.begin(), mesh.quadrilaterals.end())});
      else
        fly(TwoWay{skin(mesh.quadrilaterals.begin(), middle), skin(middle, mesh.quadrilaterals.end())});
    }
}

TEST_CASE("bodies that begin crossed with no node inside are told by their edges") {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const auto edges = [&](const Mesh& one, const Mesh& other) {
    Mesh mesh = one;
    append(mesh, other);
    const auto skin = [&](bool of_other) {
      const auto some = [of_other](const auto& cells, std::size_t of_one) {
        const auto middle = cells.begin() + static_cast<std::ptrdiff_t>(of_one);
        return of_other ? std::decay_t<decltype(cells)>(middle, cells.end())
                        : std::decay_t<decltype(cells)>(cells.begin(), middle);
      };
      return mesh.hexahedra.empty()
                 ? Surface{quadrilateral_surface(some(mesh.quadrilaterals, one.quadrilaterals.size())), 0.1}
                 : Surface{hexahedron_surface(some(mesh.hexahedra, one.hexahedra.size()))};
    };
    const auto count = [&](const auto& pairing) {
      const std::vector<Eigen::Vector3d> still(mesh.nodes.size(), Eigen::Vector3d::Zero());
      const std::string warning =
          testing::Balls(mesh.nodes, still, std::vector<double>(still.size(), 1), Contact{pairing}).contact.warning();
      CHECK((warning.empty() || warning.find("through faces at the start with neither end inside") != warning.npos));
      return warning.empty() ? 0 : std::stoi(warning);
    };
    const int there = count(TwoWay{skin(false), skin(true)});
    CHECK(count(TwoWay{skin(true), skin(false)}) == there);
    CHECK(count(SelfContact{skin(false) + skin(true)}) == there);
    for (auto& x : mesh.nodes) x = turn * x;
    CHECK(count(SelfContact{skin(true) + skin(false)}) == there);
    return there;
  };
  // A bar and another across it, through it, on it, and beside it.
  const Mesh bar = box({.lower = {-2, -0.5, -0.5}, .size = {4, 1, 1}});
  const auto across = [](double z) { return box({.lower = {-0.4, -2, z}, .size = {0.8, 4, 0.6}}); };
  CHECK(edges(bar, across(-0.3)) == 4);
  CHECK(edges(bar, across(0.2)) == 4);  // two of each
  CHECK(edges(bar, across(0.5)) == 0);
  CHECK(edges(bar, across(0.6)) == 0);
  // A plate that stands across another, on it, and above it.
  const Mesh plate = rectangle({.lower = {-1, -1, 0}, .size = {2, 2}});
  const auto stands = [](double z) {
    return sheet({1, 1}, [z](double s, double t) { return Eigen::Vector3d(s - 0.5, 0.1, z + 2 * t); });
  };
  CHECK(edges(plate, stands(-1)) == 2);
  CHECK(edges(plate, stands(0.2)) == 0);
}
