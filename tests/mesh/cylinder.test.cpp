#include <algorithm>
#include <cmath>
#include <numbers>

#include <strike/mesh/check.hpp>
#include <strike/mesh/cylinder.hpp>
#include <strike/mesh/measure.hpp>
#include <strike/mesh/select.hpp>
#include <strike/mesh/surface.hpp>

#include "support/catch.hpp"

using namespace strike;
using std::numbers::pi;

namespace {
double radius_at(const Eigen::Vector3d& x) { return std::hypot(x[0], x[1]); }
}  // namespace

TEST_CASE("cylinder: the default is the X3D mesh of the Taylor bar, 3 blocks x 3 x 3 x 50") {
  const Mesh bar = cylinder({.radius = 3.2, .length = 32.4});
  CHECK(bar.hexahedra.size() == 1350);
  CHECK(bar.nodes.size() == 51 * (16 + 3 * 7));  // 16 nodes of the core and three arcs of seven in each plane
  CHECK_NOTHROW(check(bar));
}

TEST_CASE("cylinder: volume is that of the prism over the polygon through the mantle nodes, and tends to pi R^2 L") {
  for (const auto& [sector, quarters] : {std::pair{Sector::quarter, 1u}, {Sector::half, 2u}, {Sector::full, 4u}}) {
    double error = 0;
    for (const Index n : {1u, 2u, 4u, 8u}) {
      const Mesh bar = cylinder({.radius = 3.2, .length = 32.4, .cells = n, .layers = 3, .sector = sector});
      CHECK(bar.hexahedra.size() == std::size_t(quarters) * 3 * n * n * 3);
      CHECK_NOTHROW(check(bar));
      const double polygon = quarters * n * std::sin(pi / (4 * n)) * 3.2 * 3.2 * 32.4;
      CHECK(volume(bar) == Approx(polygon).epsilon(1e-13));  // rounding over some hundred cells
      const double round = quarters * pi / 4 * 3.2 * 3.2 * 32.4, last = error;
      error = (round - volume(bar)) / round;  // 1 - sin(a)/a = a^2/6 with a = pi/(4 n): a quarter per doubling
      if (n > 1) CHECK(last / error == Approx(4).epsilon(0.03));  // next term a^2/20
    }
  }
}

TEST_CASE("cylinder: mantle nodes lie on the circle at equal angles, symmetry planes are exact") {
  for (const Sector sector : {Sector::quarter, Sector::half, Sector::full}) {
    const Index quarters = sector == Sector::quarter ? 1 : sector == Sector::half ? 2 : 4;
    const Mesh bar = cylinder({.radius = 1, .length = 2, .cells = 5, .layers = 4, .sector = sector});
    const auto mantle = nodes_where(bar.nodes, [](const Eigen::Vector3d& x) { return radius_at(x) > 0.99; });
    const Index around = quarters * 10 + (sector == Sector::full ? 0 : 1);
    REQUIRE(mantle.size() == 5 * around);
    std::vector<double> angle;
    for (const Index node : mantle) {
      CHECK(std::abs(radius_at(bar.nodes[node]) - 1) < 1e-15);
      if (bar.nodes[node][2] == 0) angle.push_back(std::atan2(bar.nodes[node][1], bar.nodes[node][0]));
    }
    std::sort(angle.begin(), angle.end());
    for (std::size_t i = 1; i < angle.size(); ++i) CHECK(angle[i] - angle[i - 1] == Approx(pi / 20).epsilon(1e-13));

    for (const Eigen::Vector3d& x : bar.nodes)  // a node is in a plane of symmetry or clearly outside it
      for (const int axis : {0, 1}) CHECK((x[axis] == 0 || std::abs(x[axis]) > 0.01));
    CHECK(nodes_where(bar.nodes, [](const Eigen::Vector3d& x) { return x[2] == 0; }).size() * 5 == bar.nodes.size());
    CHECK(nodes_where(bar.nodes, [](const Eigen::Vector3d& x) { return x[2] == 2; }).size() * 5 == bar.nodes.size());
  }
}

TEST_CASE("cylinder: the core has its corners at .55 R on the axes and (.42, .42) R") {
  const Mesh bar = cylinder({.radius = 10, .length = 1, .cells = 3, .layers = 1});
  CHECK((bar.nodes[3] - Eigen::Vector3d(5.5, 0, 0)).norm() < 1e-14);
  CHECK((bar.nodes[12] - Eigen::Vector3d(0, 5.5, 0)).norm() < 1e-14);
  CHECK((bar.nodes[15] - Eigen::Vector3d(4.2, 4.2, 0)).norm() < 1e-14);
}

TEST_CASE("cylinder: layers are graded from the foot") {
  const Mesh bar = cylinder({.radius = 1, .length = 7, .cells = 1, .layers = 3, .grading = 4});
  const std::size_t stride = bar.nodes.size() / 4;
  CHECK(bar.nodes[0][2] == 0);
  CHECK(bar.nodes[stride][2] == Approx(1).epsilon(1e-14));
  CHECK(bar.nodes[2 * stride][2] == Approx(3).epsilon(1e-14));
  CHECK(bar.nodes[3 * stride][2] == 7);
}
