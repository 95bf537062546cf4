// A ball of a given mass that strikes a plate, as docs/tour.md shows it.
#include <algorithm>
#include <cmath>

#include <strike/contact/contact.hpp>
#include <strike/contact/pairing.hpp>
#include <strike/contact/policies.hpp>
#include <strike/dynamics/explicit.hpp>
#include <strike/element/plate4.hpp>
#include <strike/load/rigid_body.hpp>
#include <strike/load/support.hpp>
#include <strike/material/elastic.hpp>
#include <strike/material/plane_stress.hpp>
#include <strike/mesh/select.hpp>
#include <strike/mesh/sheet.hpp>
#include <strike/mesh/sphere.hpp>
#include <strike/mesh/transform.hpp>
#include <strike/section/layered.hpp>

#include "support/catch.hpp"

using namespace strike;

TEST_CASE("a rigid ball of 2 kg strikes a clamped plate and leaves it, no faster") {
  // mm, ms, kg
  Mesh mesh = rectangle({.lower = {-150, -150, 0}, .size = {300, 300}, .cells = {20, 20}});
  const auto rim = [](const auto& x) { return std::max(std::abs(x[0]), std::abs(x[1])) > 149; };
  const std::vector<Index> edge = nodes_where(mesh.nodes, rim);
  append(mesh, translated(sphere({.radius = 40, .cells = 2}), {0, 0, 42}));
  const Homogeneous plate{PlaneStress{Elastic{7.85e-6, 210, 0.3}}, 2};
  const Inertia mass{2, {0, 0, 42}, {1280, 1280, 1280, 0, 0, 0}};  // of a ball, 2/5 m r^2
  Explicit run{Scene{mesh.nodes, Part{Plate4{}, plate, mesh.quadrilaterals},
                     RigidBody{Mesh{mesh.nodes, mesh.hexahedra}, mass}.moving({0, 0, -10}), Clamped{edge},
                     Contact{Everything{}, Penalty{}}}};
  run.until(5);
  const RigidMotion& ball = run.nodes().bodies()[0];
  CHECK(run.nodes().bodies()[0].mass() == 2);
  CHECK(run.energy().initial == Approx(100));
  CHECK(ball.velocity().z() > 0);
  CHECK(ball.velocity().norm() < 10);
  CHECK(ball.centre().z() > 42);
  CHECK(ball.angular_velocity().norm() < 1e-3 * 10 / 40);  // it strikes in the middle of a symmetric mesh
  CHECK(std::abs(run.energy().error()) < 5e-3);
}
