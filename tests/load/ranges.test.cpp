// Numbers of loads and conditions that are out of their range are refused in one sentence.
#include <cmath>
#include <limits>

#include <strike/load.hpp>
#include <strike/mesh/box.hpp>
#include <strike/mesh/transform.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {

constexpr double nan_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

template <class Item>
void refused(const Item& item, const std::string& sentence) {
  CHECK_THROWS_WITH(detail::check_ranges(item), "strike: " + sentence);
}

}  // namespace

TEST_CASE("vectors of loads are finite") {
  const Eigen::Vector3d none(nan_number, 0, 0), endless(0, infinity, 0);
  refused(BodyForce{none}, "the acceleration of BodyForce is (nan, 0, 0); it must be finite.");
  refused(NodalForce{endless, {0}}, "the force of NodalForce is (0, inf, 0); it must be finite.");
  refused(InitialVelocity{none}, "the velocity of InitialVelocity is (nan, 0, 0); it must be finite.");
  refused(InitialVelocity{{0, 0, 0}, Spin{endless}}, "the angular_velocity of Spin is (0, inf, 0); it must be finite.");
}

TEST_CASE("directions are not zero") {
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero(), none(0, 0, nan_number);
  refused(Support{{0}, {zero}}, "the direction of Support is (0, 0, 0); it must be finite and not zero.");
  refused(Support{{0}, {unit(Axis::x)}, {none}}, "the axis of Support is (0, 0, nan); it must be finite and not zero.");
  refused(Symmetry{none, {0}}, "the normal of Symmetry is (0, 0, nan); it must be finite and not zero.");
  refused(PrescribedVelocity{zero, {0}, Constant{}},
          "the direction of PrescribedVelocity is (0, 0, 0); it must be finite and not zero.");
  refused(PrescribedDisplacement{none, {0}, Constant{}},
          "the direction of PrescribedDisplacement is (0, 0, nan); it must be finite and not zero.");
  CHECK_NOTHROW(detail::check_ranges(Clamped{{0}}));
}

TEST_CASE("histories are of numbers") {
  CHECK_THROWS_WITH(Curve({{nan_number, 1}}), "strike: the time of point 0 of Curve is nan; it must be finite.");
  CHECK_THROWS_WITH(Curve({{0, 0}, {1, infinity}}), "strike: the value of point 1 of Curve is inf; it must be finite.");
  refused(Pressure{{}, Constant{nan_number}}, "the value of Constant is nan; it must be finite.");
  CHECK_NOTHROW(detail::check_ranges(Pressure{{}, [](double t) { return t; }}));
}

TEST_CASE("what writes to a node that is not there is refused, by any number") {
  Nodes<double> nodes({{0, 0, 0}, {1, 0, 0}}, {0, 1});
  const auto refuses = [](const auto& f) {
    CHECK_THROWS_WITH(f(), "strike: a condition names node 999, but there are 2 nodes; count them from 0.");
  };
  refuses([&] { nodes.add_force(999, {1, 0, 0}); });
  refuses([&] { nodes.set_velocity(999, {1, 0, 0}); });
  refuses([&] { nodes.set_position(999, {1, 0, 0}); });
  refuses([&] { nodes.add_mass(999, 1); });
}
