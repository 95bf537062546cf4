#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include <strike/dynamics/explicit.hpp>
#include <strike/element/plate4.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/material/plane_stress.hpp>
#include <strike/mesh/sheet.hpp>
#include <strike/section/layered.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {

const Homogeneous section{PlaneStress{Elastic{1, 1e7, 0}}, 0.1};
const Eigen::Vector3d spin(10, -4, 3), flight(5, 0, -7), centre(0.1, 0.2, 0.3);

Eigen::Vector3d rigid(const Eigen::Vector3d& x) { return flight + spin.cross(x - centre); }

/// A warped sheet, so that its plates look to all sides.
const Mesh mesh =
    sheet({4, 4}, [](double s, double t) { return Eigen::Vector3d(s - 0.5, t - 0.5, 0.2 * s * t + 0.1 * s * s); });

template <class Item>
auto flying(Item item) {
  return Explicit{Scene{mesh.nodes, Part{Plate4{}, section, mesh.quadrilaterals}, std::move(item)},
                  ExplicitOptions{.print_warnings = false}};
}

}  // namespace

TEST_CASE("plates that are told the field of a rigid motion spin with it, without strain") {
  auto by_field = flying(InitialVelocityField{rigid});
  auto by_spin = flying(InitialVelocity{flight + spin.cross(-centre), Spin{spin}});
  for (Index i = 0; i < mesh.nodes.size(); ++i) {
    CHECK((by_field.nodes().w(i) - spin).norm() < 1e-9 * spin.norm());
    CHECK((by_spin.nodes().w(i) - spin).norm() == 0);
    CHECK((by_spin.nodes().v(i) - by_field.nodes().v(i)).norm() < 1e-12 * flight.norm());
  }
  double most = 0;
  by_field.until(0.1, [&] { most = std::max(most, by_field.energy().internal + by_field.energy().hourglass); });
  // The centrifugal stress rho (W r)^2 alone: W^2/(E/rho) = 125/1e7 of the kinetic energy, of which it takes a share.
  CHECK(most < 1e-4 * by_field.energy().initial);
}

TEST_CASE("a field that strains gives no spin, whatever it jumps by") {
  const auto still = [](auto field) {
    const auto run = flying(InitialVelocityField{field});
    double most = 0;
    for (Index i = 0; i < mesh.nodes.size(); ++i) most = std::max(most, run.nodes().w(i).norm());
    return most == 0;
  };
  CHECK(still([](const Eigen::Vector3d& x) { return Eigen::Vector3d(0, 0, 1 - x.x() * x.x()); }));
  CHECK(still([](const Eigen::Vector3d& x) { return Eigen::Vector3d(0, 0, x.x() < 0 ? 1 : -1); }));
  CHECK(still([](const Eigen::Vector3d&) { return Eigen::Vector3d(1, 2, 3); }));
}

TEST_CASE("a spin of some nodes leaves the others at rest") {
  const auto run = flying(InitialVelocity{flight, Spin{spin, centre}, {3, 5}});
  for (const Index i : {Index{3}, Index{5}}) {
    CHECK((run.nodes().v(i) - rigid(mesh.nodes[i])).norm() < 1e-14 * flight.norm());
    CHECK(run.nodes().w(i) == spin);
  }
  CHECK(run.nodes().w(4).norm() + run.nodes().v(4).norm() == 0);
}

TEST_CASE("a velocity that is not finite is named with its node") {
  CHECK_THROWS_WITH(flying(InitialVelocityField{[](const Eigen::Vector3d& x) {
                      return Eigen::Vector3d(0, 0, x.x() < 0.4 ? 1 : std::numeric_limits<double>::infinity());
                    }}),
                    Catch::Matchers::ContainsSubstring("gives node 4 at (0.5, -0.5, 0.1) is (0, 0, inf)"));
}
