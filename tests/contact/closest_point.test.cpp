#include <cmath>
#include <random>

#include <strike/contact/closest_point.hpp>

#include "support/catch.hpp"

using namespace strike;
using namespace strike::detail;

namespace {

Corners warped_square(double warp = 0) {
  return {Eigen::Vector3d(0, 0, warp), {1, 0, -warp}, {1, 1, warp}, {0, 1, -warp}};
}
Eigen::Vector3d at(const Corners& X, const ClosestPoint& point) {
  Eigen::Vector3d x = Eigen::Vector3d::Zero();
  for (unsigned i = 0; i < 4; ++i)
    if (point.N[i] != 0) x += point.N[i] * X[i];
  return x;
}

}  // namespace

TEST_CASE("the closest point of a plane quadrilateral is the foot, or on the edge or corner that is nearest") {
  const Corners X = warped_square();
  const auto inside = closest_on_quadrilateral(X, {0.3, 0.6, 2});
  CHECK(inside.where == ClosestPoint::inside);
  CHECK((at(X, inside) - Eigen::Vector3d(0.3, 0.6, 0)).norm() < 1e-15);
  const auto edge = closest_on_quadrilateral(X, {0.3, -1, 2});
  CHECK((edge.where == ClosestPoint::on_edge && edge.which == 0));
  CHECK((at(X, edge) - Eigen::Vector3d(0.3, 0, 0)).norm() < 1e-15);
  const auto corner = closest_on_quadrilateral(X, {2, 3, 1});
  CHECK((corner.where == ClosestPoint::at_corner && corner.which == 2));
  CHECK(corner.distance2 == Approx(6));
}

TEST_CASE("the closest point of any quadrilateral and triangle is as close as the best of many") {
  std::mt19937 random(1);
  const auto number = [&] { return std::uniform_real_distribution<double>(-1, 1)(random); };
  for (int trial = 0; trial < 500; ++trial) {
    Corners X = warped_square(0.3 * number());
    for (auto& corner : X) corner += 0.3 * Eigen::Vector3d(number(), number(), number());
    const Eigen::Vector3d x(1.5 * number() + 0.5, 1.5 * number() + 0.5, number());
    double best[2] = {1e9, 1e9};
    for (int i = 0; i <= 100; ++i)
      for (int j = 0; j <= 100; ++j) {
        const double s = i / 100.0, t = j / 100.0;
        const Eigen::Vector3d y = (1 - s) * (1 - t) * X[0] + s * (1 - t) * X[1] + s * t * X[2] + (1 - s) * t * X[3];
        best[0] = std::min(best[0], (x - y).norm());
        if (i + j <= 100) best[1] = std::min(best[1], (x - (1 - s - t) * X[0] - s * X[1] - t * X[2]).norm());
      }
    const ClosestPoint of_quadrilateral = closest_on_quadrilateral(X, x), of_triangle = closest_on_triangle(X, x);
    CHECK(std::sqrt(of_quadrilateral.distance2) < best[0] + 1e-12);
    CHECK(std::sqrt(of_triangle.distance2) < best[1] + 1e-12);
    for (const auto& point : {of_quadrilateral, of_triangle}) {
      CHECK((x - at(X, point) - point.away).norm() < 1e-14);
      CHECK(point.N[0] + point.N[1] + point.N[2] + point.N[3] == Approx(1).epsilon(1e-14));
    }
    if (of_quadrilateral.where == ClosestPoint::inside)
      CHECK(cross<double>(normal_at(X, of_quadrilateral.N, false), of_quadrilateral.away).norm() < 1e-12);
  }
}
