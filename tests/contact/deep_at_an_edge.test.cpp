// Nodes that springs let come deeper than half a plate, exactly at an edge.
#include <algorithm>
#include <vector>

#include <strike/contact/contact.hpp>
#include <strike/mesh/box.hpp>
#include <strike/mesh/sheet.hpp>
#include <strike/mesh/surface.hpp>

#include "problems/balls.hpp"
#include "support/catch.hpp"

using namespace strike;

namespace {

/// A ball of mass 1 falls at speed 1 on heavy nodes, over the middle of their edge x = 0, on a spring that stops it at
/// a depth of 0.07.
void comes_back(const Mesh& mesh, double above, double of_ball, double of_faces) {
  std::vector<Eigen::Vector3d> x = mesh.nodes, v(x.size(), Eigen::Vector3d::Zero());
  std::vector<double> mass(x.size(), 1e12);
  const auto ball = static_cast<Index>(x.size());
  x.push_back({0, 0.5, above + 0.1}), v.push_back({0, 0, -1}), mass.push_back(1);
  testing::Balls run(x, v, mass,
                     Contact{NodeToSurface{{ball}, Surface{surface(mesh), of_faces}, of_ball},
                             Penalty{.stiffness = 1 / (0.07 * 0.07)}});
  double lowest = above;
  for (int n = 0; n < 500; ++n) run.step(1e-3), lowest = std::min(lowest, run.nodes.x(ball).z());
  CHECK(lowest == Approx(above + 0.05 - 0.07).epsilon(1e-3));
  CHECK((run.nodes.v(ball) - Eigen::Vector3d(0, 0, 1)).norm() < 1e-3);
}

}  // namespace

TEST_CASE("a node of a plate deep in a solid does not pass from its top to its side") {
  comes_back(box({.size = {1, 1, 1}, .cells = {2, 2, 2}}), 1, 0.1, 0);
}

TEST_CASE("a node straight over the border of a plate, past its middle, is still on its side") {
  comes_back(rectangle({.size = {1, 1}, .cells = {2, 2}}), 0, 0, 0.1);
}
