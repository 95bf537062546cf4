#include <cmath>
#include <numbers>

#include <strike/mesh/canopy.hpp>
#include <strike/mesh/check.hpp>
#include <strike/mesh/measure.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {
constexpr CanopyShape bubble{.length = 80,
                             .top = 50,
                             .height = {.front = 6, .top = 26, .back = 20},
                             .half_width = {.front = 10, .top = 18, .back = 15},
                             .cells = {29, 32}};
}  // namespace

TEST_CASE("a canopy runs through its stations, level at the top, and faces outward") {
  const Mesh mesh = canopy(bubble);
  CHECK(mesh.quadrilaterals.size() == 928);
  CHECK_NOTHROW(check(mesh));
  CHECK(bubble.height_at(0) == Approx(6).epsilon(1e-15));
  CHECK(bubble.height_at(25) == Approx(26 - 20. / 4).epsilon(1e-15));  // half way a parabola has a quarter to go
  CHECK(bubble.height_at(50) == Approx(26).epsilon(1e-15));
  CHECK(bubble.height_at(80) == Approx(20).epsilon(1e-15));
  CHECK(bubble.half_width_at(65) == Approx(18 - 3. / 4).epsilon(1e-15));
  for (const Eigen::Vector3d& x : mesh.nodes)
    CHECK(std::pow(x.y() / bubble.half_width_at(x.x()), 2) + std::pow(x.z() / bubble.height_at(x.x()), 2) ==
          Approx(1).epsilon(1e-14));
  for (const auto& cell : mesh.quadrilaterals) {
    const Eigen::Vector3d middle = centroid<4>(mesh.nodes, cell);
    CHECK(area_vector(mesh.nodes, Face{cell, 0}).dot(Eigen::Vector3d(0, middle.y(), middle.z())) > 0);
  }
}

TEST_CASE("a canopy of equal sections is half a cylinder of chords 2 R sin(pi/(2 n))") {
  const CanopyShape::Profile R{3, 3, 3};
  double area = 0;
  const Mesh mesh = canopy({.length = 5, .top = 2, .height = R, .half_width = R, .cells = {4, 8}});
  for (const auto& cell : mesh.quadrilaterals) area += quadrilateral_area(mesh.nodes, cell);
  CHECK(area == Approx(5 * 8 * 2 * 3 * std::sin(std::numbers::pi / 16)).epsilon(1e-14));
}
