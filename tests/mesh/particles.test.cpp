#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include <strike/mesh/check.hpp>
#include <strike/mesh/particles.hpp>
#include <strike/mesh/remaining.hpp>
#include <strike/mesh/select.hpp>
#include <strike/mesh/tetrahedra.hpp>

#include "support/catch.hpp"

using namespace strike;
using Catch::Matchers::ContainsSubstring;
using std::numbers::pi;

namespace {

constexpr double mass = 1.8, density = 950;
constexpr BirdForm forms[] = {BirdForm::cylinder, BirdForm::hemispherical_ends, BirdForm::ellipsoid};

BirdShape bird_of(BirdForm form, Sector sector = Sector::full) {
  return {.mass = mass, .density = density, .form = form, .cells = 2, .layers = 4, .sector = sector};
}
/// That of all, which have the same.
double volume_of_each(const Mesh& mesh) {
  const std::vector<double>& V = mesh.particles.volumes;
  CHECK(std::all_of(V.begin(), V.end(), [&](double v) { return v == V[0]; }));
  return V.at(0);
}

std::vector<std::array<double, 3>> sorted(const std::vector<Eigen::Vector3d>& nodes) {
  std::vector<std::array<double, 3>> all;
  for (const auto& x : nodes) all.push_back({x[0], x[1], x[2]});
  std::sort(all.begin(), all.end());
  return all;
}
/// Those of the whole on the positive sides of planes through the origin.
std::vector<std::array<double, 3>> cut(const std::vector<Eigen::Vector3d>& nodes, int planes) {
  std::vector<Eigen::Vector3d> left;
  for (const auto& x : nodes)
    if (x.y() > 0 && (planes < 2 || x.x() > 0)) left.push_back(x);
  return sorted(left);
}

}  // namespace

TEST_CASE("particles: a bird has its mass, whatever its form and sector, and a cut one has those of the whole") {
  for (const BirdForm form : forms) {
    const Mesh whole = particles(bird_of(form), 10);
    CAPTURE(static_cast<int>(form));
    CHECK_NOTHROW(check(whole));
    CHECK(whole.particles.size() == whole.nodes.size());
    const double spacing = size_of(bird_of(form)).diameter / 10;
    CHECK((whole.nodes[1] - whole.nodes[0]).norm() == Approx(spacing).epsilon(1e-12));
    CHECK(density * volume(whole) == Approx(mass).epsilon(1e-12));               // the rounding of a sum of a thousand
    CHECK(volume_of_each(whole) == Approx(std::pow(spacing, 3)).epsilon(0.05));  // stairs of 10 across: up to 0.04
    for (const auto& [sector, planes] : {std::pair{Sector::half, 1}, {Sector::quarter, 2}}) {
      const Mesh part = particles(bird_of(form, sector), 10);
      CHECK(sorted(part.nodes) == cut(whole.nodes, planes));
      CHECK(volume_of_each(part) == Approx(volume_of_each(whole)).epsilon(1e-14));
    }
  }
}

TEST_CASE("particles: a body is its own mirror image, and has its centre of mass") {
  for (const BirdForm form : forms) {
    const double middle = size_of(bird_of(form)).length / 2;
    std::vector<Eigen::Vector3d> about = particles(bird_of(form), 6).nodes;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (auto& x : about) x.z() -= middle, sum += x;
    CHECK(sum.norm() < 1e-12 * static_cast<double>(about.size()) * middle);
    for (int axis = 0; axis < 2; ++axis) {
      auto image = about;
      for (auto& x : image) x[axis] = -x[axis];
      CHECK(sorted(image) == sorted(about));
    }
    auto image = about;  // along z to rounding of the middle
    for (auto& x : image) x.z() = -x.z();
    for (const auto& x : image) CHECK((about[nearest_node(about, x)] - x).norm() < 1e-12 * middle);
  }
}

TEST_CASE("particles: their number tends to that of cubes in the smooth body") {
  // A cylinder whose length is four spacings has four layers of the points of a disc: 12 at 4 across, 32 at 6.
  const auto count = [](Index across, double length) {
    return particles(CylinderShape{.radius = 1, .length = length, .sector = Sector::full}, across).nodes.size();
  };
  CHECK(count(4, 2) == 4 * 12);
  CHECK(count(6, 4. / 3) == 4 * 32);
  CHECK(particles(SphereShape{.radius = 1}, 2).nodes.size() == 8);
  CHECK(particles(SphereShape{.radius = 1}, 4).nodes.size() == 32);  // all but the 32 of two or three 3/4
  const double cubes = 4. / 3 * pi * std::pow(20., 3);
  CHECK(static_cast<double>(particles(SphereShape{.radius = 1}, 40).nodes.size()) == Approx(cubes).epsilon(5e-3));
}

TEST_CASE("particles: a box has one in the middle of each cell, and half of it half of them") {
  const BoxShape shape{.lower = {-1, 2, 3}, .size = {2, 1, 3}, .cells = {4, 2, 6}};
  const Mesh all = particles(shape);
  CHECK(all.nodes.size() == 48);
  CHECK(volume_of_each(all) == Approx(0.125).epsilon(1e-15));
  const Mesh cells = box(shape);
  for (std::size_t e = 0; e < 48; ++e)
    CHECK((all.nodes[e] - centroid<8>(cells.nodes, cells.hexahedra[e])).norm() < 1e-15);
  const Mesh half = particles(BoxShape{.lower = {0, 2, 3}, .size = {1, 1, 3}, .cells = {2, 2, 6}});
  CHECK(volume_of_each(half) == volume_of_each(all));
  for (const auto& x : half.nodes) CHECK((all.nodes[nearest_node(all.nodes, x)] - x).norm() < 1e-15);
}

TEST_CASE("particles: inside meshes they are those of the bodies, on however many edges lines meet them") {
  // Lines through nodes, edges and faces of a box all of whose nodes are under the lattice, and of its tetrahedra.
  const Mesh brick = box({.lower = {-1.25, -1.25, -1}, .size = {2.5, 2.5, 2}, .cells = {5, 5, 4}});
  for (const Mesh& mesh : {brick, tetrahedralized(brick), tetrahedralized(brick, Split::five)}) {
    const Mesh all = particles(mesh, 0.5);
    CHECK(volume(all) == Approx(12.5).epsilon(1e-14));
    // From -1.25 (in, for lines move up) to 1.25 (out): five lines each way; and four in height.
    CHECK(all.nodes.size() == 5 * 5 * 4);
  }
  // The skin alone, whichever way it faces.
  Mesh skin{.nodes = brick.nodes};
  for (const Face& face : surface(brick)) skin.quadrilaterals.push_back(face.nodes);
  CHECK(sorted(particles(skin, 0.5).nodes) == sorted(particles(brick, 0.5).nodes));
  for (auto& [a, b, c, d] : skin.quadrilaterals) std::swap(b, d);
  CHECK(particles(skin, 0.5).nodes.size() == 100);
  CHECK(volume(particles(skin, 0.5)) == Approx(12.5).epsilon(1e-14));
}

TEST_CASE("particles: what lies on lines of the lattice but for rounding lies on them") {
  const Mesh brick = box({.lower = {-1.25, -1.25, -1}, .size = {2.5, 2.5, 2}, .cells = {5, 5, 4}});
  std::mt19937 random(5);
  std::uniform_real_distribution<double> rounding(-1e-12, 1e-12);
  for (int times = 0; times < 20; ++times) {
    Mesh shaken = tetrahedralized(brick);
    for (Eigen::Vector3d& x : shaken.nodes) x += Eigen::Vector3d::NullaryExpr([&] { return rounding(random); });
    CHECK(particles(shaken, 0.5).nodes == particles(brick, 0.5).nodes);
  }
}

TEST_CASE("particles: of a turned and shifted mesh they are the points in the turned body") {
  const Eigen::Vector3d axis(1, 2, 3), size(2, 1.4, 1.1);
  const double h = 0.1, near_is = 2e-5 * h;  // places are rounded to 2^-17 in each direction
  for (const double angle : {0.0, 0.3, pi / 2, 2.0})
    for (const Eigen::Vector3d& shift : {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0.1, -3.7, 5.05)}) {
      const Mesh brick = box({.lower = -0.5 * size, .size = size, .cells = {3, 2, 2}});
      const Mesh mesh = translated(rotated(brick, axis, angle), shift);
      const Mesh all = particles(mesh, h);
      const Eigen::Matrix3d back = Eigen::AngleAxisd(-angle, axis.normalized()).toRotationMatrix();
      const auto depth = [&](const Eigen::Vector3d& x) {  // positive inside
        return (0.5 * size - (back * (x - shift)).cwiseAbs()).minCoeff();
      };
      std::size_t inside = 0, near = 0;
      const Eigen::Vector3d middle = (shift / h).array().floor();
      for (int i = -15; i < 15; ++i)  // half a diagonal of the brick is 13.4 h, and `middle` is off by up to h
        for (int j = -15; j < 15; ++j)
          for (int k = -15; k < 15; ++k) {
            const double d = depth(h * (middle + Eigen::Vector3d(i + 0.5, j + 0.5, k + 0.5)));
            inside += d > near_is, near += std::abs(d) <= near_is;
          }
      CAPTURE(angle, shift.x());
      CHECK(all.nodes.size() >= inside);
      CHECK(all.nodes.size() <= inside + near);
      CHECK(std::all_of(all.nodes.begin(), all.nodes.end(), [&](const auto& x) { return depth(x) > -near_is; }));
      CHECK(volume(all) == Approx(size.prod()).epsilon(1e-12));
    }
}

TEST_CASE("particles: a quarter of a mesh has those of the whole, and two bodies those of both") {
  const auto ball = [](Sector sector) { return sphere({.radius = 1, .cells = 2, .sector = sector}); };
  const Mesh whole = particles(ball(Sector::full), 0.2);
  CHECK(sorted(particles(ball(Sector::quarter), 0.2).nodes) == cut(whole.nodes, 2));
  CHECK(sorted(particles(ball(Sector::half), 0.2).nodes) == cut(whole.nodes, 1));
  Mesh two = ball(Sector::full);
  append(two, translated(ball(Sector::full), {4, 0, 0}));  // by 20 spacings
  CHECK(particles(two, 0.2).nodes.size() == 2 * whole.nodes.size());
  // A hollow ball: the inner skin faces the hollow.
  Mesh shell = ball(Sector::full);
  shell.hexahedra = cells_of(shell.hexahedra,
                             cells_where(shell.nodes, shell.hexahedra, [](const auto& x) { return x.norm() > 0.55; }));
  const Mesh hollow = particles(remove_orphan_nodes(shell), 0.1);
  CHECK(std::none_of(hollow.nodes.begin(), hollow.nodes.end(), [](const auto& x) { return x.norm() < 0.4; }));
  CHECK(std::pow(0.1, 3) == Approx(volume_of_each(hollow)).epsilon(0.05));
}

TEST_CASE("particles: what cannot be filled is refused in a sentence") {
  const SphereShape ball{.radius = 1};
  CHECK_THROWS_WITH(particles(ball, 3), ContainsSubstring("the across of particles is 3, which is odd"));
  CHECK_THROWS_WITH(particles(ball, 0), ContainsSubstring("the across of particles is 0"));
  CHECK_THROWS_WITH(particles(CylinderShape{.radius = 1, .length = 0.1}, 2),
                    "strike: particles 1 apart are too coarse: none is inside the body; give more across it.");
  Mesh open = box({.size = {1, 1, 1}});
  for (const Face& face : surface(open)) open.quadrilaterals.push_back(face.nodes);
  open.hexahedra.clear();
  CHECK_NOTHROW(particles(open, 0.5));
  Mesh mixed = open;
  std::swap(mixed.quadrilaterals[2][1], mixed.quadrilaterals[2][3]);
  CHECK_THROWS_WITH(particles(mixed, 0.5), ContainsSubstring("do not all face outwards"));
  open.quadrilaterals.pop_back();
  CHECK_THROWS_WITH(particles(open, 0.5), ContainsSubstring("is open") && ContainsSubstring("close it."));
  CHECK_THROWS_WITH(particles(Mesh{}, 0.5), ContainsSubstring("without cells has no inside"));
  CHECK_THROWS_WITH(particles(box({.size = {1, 1, 1}}), -0.5), ContainsSubstring("the spacing of particles is -0.5"));
  CHECK_THROWS_AS(particles(box({.size = {1, 1, 1}}), 1e-4), Error);
  Mesh wrong = particles(ball, 2);
  wrong.particles.cells[3] = {99};
  CHECK_THROWS_WITH(check(wrong), ContainsSubstring("particle 3 names node 99, but the mesh has 8 nodes"));
  wrong = particles(ball, 2);
  wrong.particles.volumes[5] = 0;
  CHECK_THROWS_WITH(check(wrong), "strike: the volume of particle 5 is 0; it must be positive.");
  wrong.particles.volumes.pop_back();
  CHECK_THROWS_WITH(check(wrong), ContainsSubstring("has 8 particles, but 7 volumes"));
}

TEST_CASE("particles: transforms take them along, with their volumes") {
  const Mesh ball = particles(SphereShape{.radius = 1}, 4);
  Mesh two = scaled(ball, {1, 2, 3});
  CHECK(volume(two) == Approx(6 * volume(ball)).epsilon(1e-14));
  CHECK(append(two, mirrored(translated(ball, {9, 0, 0}), {1, 0, 0})) == 32);
  CHECK(two.particles.cells[40] == std::array<Index, 1>{40});
  CHECK_NOTHROW(check(two));
  CHECK(volume(two) == Approx(7 * volume(ball)).epsilon(1e-14));
  std::vector<bool> alive(64, true);
  alive[3] = alive[50] = false;
  const Mesh left = remove_orphan_nodes(remaining(two, alive));
  CHECK(left.nodes.size() == 62);
  CHECK(left.particles.cells[49] == std::array<Index, 1>{49});
  CHECK(left.particles.volumes[3] == two.particles.volumes[4]);
  CHECK_NOTHROW(check(left));
}
