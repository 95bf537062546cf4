#include <cmath>
#include <numbers>

#include <strike/mesh/box.hpp>
#include <strike/mesh/inertia.hpp>
#include <strike/mesh/sheet.hpp>
#include <strike/mesh/sphere.hpp>
#include <strike/mesh/tetrahedra.hpp>
#include <strike/mesh/transform.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {

double difference(const SymmetricTensor<double>& a, const SymmetricTensor<double>& b) {
  const SymmetricTensor<double> d = a - b;
  return std::sqrt(double_dot(d, d));
}

}  // namespace

TEST_CASE("inertia: a brick has m/12 (b^2 + c^2), wherever it is, of any cells") {
  const double a = 0.3, b = 0.2, c = 0.5, density = 7, m = density * a * b * c;
  const SymmetricTensor<double> exact{m / 12 * (b * b + c * c), m / 12 * (c * c + a * a), m / 12 * (a * a + b * b)};
  const Mesh brick = box({.size = {a, b, c}, .cells = {1, 1, 1}});
  for (const Mesh& mesh : {brick, box({.size = {a, b, c}, .cells = {2, 3, 2}}), tetrahedralized(brick)}) {
    const Inertia found = inertia(translated(mesh, {10, -20, 30}), density);
    CHECK(found.mass == Approx(m).epsilon(1e-13));
    CHECK((found.centre - Eigen::Vector3d(10 + a / 2, -20 + b / 2, 30 + c / 2)).norm() < 1e-12);
    CHECK(difference(found.moment, exact) < 1e-12);
  }
}

TEST_CASE("inertia: the shares of the nodes have the mass and the centre of the body") {
  Mesh mesh = box({.size = {1, 1, 1}, .cells = {1, 1, 1}});
  mesh.nodes[6] += Eigen::Vector3d(0.4, 0.3, 0.2);
  mesh.nodes[1] += Eigen::Vector3d(0, -0.2, 0.1);
  std::vector<double> nodal(mesh.nodes.size(), 0.0);
  const Inertia found = inertia(mesh, 3, 0, nodal);
  Inertia shared;
  for (std::size_t i = 0; i < nodal.size(); ++i) shared.add(nodal[i], mesh.nodes[i]);
  CHECK(shared.mass == Approx(found.mass).epsilon(1e-14));
  CHECK((shared.centre - found.centre).norm() < 1e-14);
  // ... and a body of two halves that of both together
  Inertia twice = found;
  twice.add(inertia(translated(mesh, {2, 0, 0}), 3));
  Inertia other = inertia(translated(mesh, {2, 0, 0}), 3);
  other.add(found);
  CHECK(difference(twice.moment, other.moment) < 1e-13);
  CHECK(twice.centre.x() == Approx(found.centre.x() + 1));
}

TEST_CASE("inertia: a ball tends to 2/5 m r^2, a square plate has m a^2/12 with its thickness") {
  const Inertia ball = inertia(sphere({.radius = 0.1, .cells = 3}), 1000);
  const double m = ball.mass;
  CHECK(m == Approx(4.0 / 3 * std::numbers::pi * 1e-3 * 1000).epsilon(0.1));
  // A ball of as much mass in flat faces: its moments are those of a ball of its volume, to the square of the faces.
  CHECK(ball.moment.xx == Approx(0.4 * m * std::pow(m / (4.0 / 3 * std::numbers::pi * 1000), 2.0 / 3)).epsilon(5e-3));
  CHECK(std::abs(ball.moment.xy) < 1e-12);

  const double a = 2, t = 0.3;
  const Inertia plate = inertia(rectangle({.size = {a, a}, .cells = {3, 2}}), 5, t);
  const double mass = 5 * a * a * t;
  CHECK(plate.moment.zz == Approx(mass * a * a / 6).epsilon(1e-13));
  CHECK(plate.moment.xx == Approx(mass * (a * a + t * t) / 12).epsilon(1e-13));
}
