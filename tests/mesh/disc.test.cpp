#include <cmath>
#include <numbers>

#include <strike/mesh/check.hpp>
#include <strike/mesh/disc.hpp>
#include <strike/mesh/measure.hpp>
#include <strike/mesh/select.hpp>

#include "support/catch.hpp"

using namespace strike;
using std::numbers::pi;

namespace {
double area(const Mesh& mesh) {
  double sum = 0;
  for (const auto& cell : mesh.quadrilaterals) sum += quadrilateral_area(mesh.nodes, cell);
  return sum;
}
}  // namespace

TEST_CASE("disc: area is that of the polygon through the rim, and tends to pi R^2") {
  for (const auto& [sector, quarters] : {std::pair{Sector::quarter, 1u}, {Sector::half, 2u}, {Sector::full, 4u}}) {
    double error = 0;
    for (const Index n : {1u, 2u, 4u, 8u}) {
      const Mesh plate = disc({.radius = 2.5, .cells = n, .sector = sector});
      CHECK(plate.quadrilaterals.size() == std::size_t(quarters) * 3 * n * n);
      CHECK_NOTHROW(check(plate));  // convex, and no node without a cell
      CHECK(area(plate) == Approx(quarters * n * std::sin(pi / (4 * n)) * 6.25).epsilon(1e-13));
      const double round = quarters * pi / 4 * 6.25, last = error;
      error = (round - area(plate)) / round;  // a^2/6 with a = pi/(4 n)
      if (n > 1) CHECK(last / error == Approx(4).epsilon(0.03));
    }
  }
}

TEST_CASE("disc: it faces +z, its rim lies on the circle, and a symmetry plane is exact") {
  const Mesh plate = disc({.radius = 2, .cells = 4});
  for (const auto& cell : plate.quadrilaterals) CHECK(area_vector(plate.nodes, Face{cell, 0}).z() > 0);
  std::size_t rim = 0;
  for (const auto& x : plate.nodes) {
    CHECK(x[2] == 0);
    CHECK(x.norm() < 2 * (1 + 1e-15));
    rim += std::abs(x.norm() - 2) < 1e-15;
    for (const int axis : {0, 1}) CHECK((x[axis] == 0 || std::abs(x[axis]) > 0.01));
  }
  CHECK(rim == 4 * 2 * 4);
  CHECK(plate.nodes.size() == plate.quadrilaterals.size() + rim / 2 + 1);  // Euler
}
