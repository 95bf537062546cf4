// Numbers of contacts that are out of their range are refused in one sentence where the contact is made.
#include <limits>

#include <strike/contact.hpp>
#include <strike/mesh/box.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {

constexpr double nan_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
const std::vector<Index> nodes{0, 1};
const Mesh mesh = box({.size = {1, 1, 1}, .cells = {1, 1, 1}});

template <class Make>
void refused(const Make& make, const std::string& sentence) {
  CHECK_THROWS_WITH(make(), "strike: " + sentence);
}

}  // namespace

TEST_CASE("rigid bodies have directions and sizes") {
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero(), up(0, 0, 1), none(nan_number, 0, 0);
  refused([&] { RigidWall{zero, zero}; }, "the normal of RigidWall is (0, 0, 0); it must be finite and not zero.");
  refused([&] { RigidWall{none, up}; }, "the point of RigidWall is (nan, 0, 0); it must be finite.");
  refused([&] { RigidWall{zero, up, -0.3}; }, "the friction of RigidWall is -0.3; it must be zero or positive.");
  refused(
      [&] {
        RigidWall{zero, up, nodes, nan_number};
      },
      "the friction of RigidWall is nan; it must be zero or positive.");
  refused(
      [&] {
        Contact{NodeToRigid{nodes, RigidPlane{zero, none}}};
      },
      "the normal of RigidPlane is (nan, 0, 0); it must be finite and not zero.");
  refused(
      [&] {
        Contact{NodeToRigid{nodes, RigidPlane{zero, up}}, Penalty{}, Coulomb{-1}};
      },
      "the coefficient of Coulomb is -1; it must be zero or positive.");
  refused(
      [&] {
        Contact{NodeToRigid{nodes, RigidPlane{zero, up}}, Coulomb{infinity}};
      },
      "the coefficient of Coulomb is inf; it must be zero or positive and finite.");
  refused(
      [&] {
        Contact{NodeToRigid{nodes, RigidSphere{zero, -1}}};
      },
      "the radius of RigidSphere is -1; it must be positive.");
  refused(
      [&] {
        Contact{NodeToRigid{nodes, RigidSphere{none, 1}}};
      },
      "the centre of RigidSphere is (nan, 0, 0); it must be finite.");
  refused(
      [&] {
        Contact{NodeToRigid{nodes, RigidCylinder{zero, zero, 1}}};
      },
      "the axis of RigidCylinder is (0, 0, 0); it must be finite and not zero.");
  refused(
      [&] {
        Contact{NodeToRigid{nodes, RigidSurface{{zero, none}, {}}}};
      },
      "the point 1 of RigidSurface is (nan, 0, 0); it must be finite.");
  refused(
      [&] {
        Contact{NodeToRigid{nodes, RigidSphere{zero, 1}, -0.1}};
      },
      "the thickness of NodeToRigid is -0.1; it must be zero or positive.");
}

TEST_CASE("laws have numbers that make sense") {
  const NodeToSurface pairing{nodes, Surface{surface(mesh)}};
  refused(
      [&] {
        Contact{pairing, Penalty{.fraction = 0}};
      },
      "the fraction of Penalty is 0; it must be positive and at most 2.");
  refused(
      [&] {
        Contact{pairing, Penalty{.fraction = nan_number}};
      },
      "the fraction of Penalty is nan; it must be positive and at most 2.");
  refused(
      [&] {
        Contact{pairing, Penalty{.stiffness = -1}};
      },
      "the stiffness of Penalty is -1; it must be zero or positive.");
  refused([&] { Contact{pairing, Kinematic{.iterations = 0}}; }, "the iterations of Kinematic is 0; it must be at least 1.");
  refused([&] { Contact{pairing, Coulomb{-0.3}}; }, "the coefficient of Coulomb is -0.3; it must be zero or positive.");
  CHECK_NOTHROW(Contact{pairing, Penalty{.fraction = 2}, Coulomb{0}});
}

TEST_CASE("surfaces and ties have thicknesses, tolerances and strengths") {
  refused([&] { Surface{surface(mesh), -1}; }, "the thickness of Surface is -1; it must be zero or positive.");
  refused([&] { Surface{surface(mesh), nan_number}; }, "the thickness of Surface is nan; it must be zero or positive.");
  refused(
      [&] {
        Contact{NodeToSurface{nodes, Surface{surface(mesh)}, nan_number}};
      },
      "the thickness of NodeToSurface is nan; it must be zero or positive.");
  const Surface faces{surface(mesh)};
  refused([&] { Tied{nodes, faces, -1.0}; }, "the tolerance of Tied is -1; it must be zero or positive.");
  refused([&] { Tied{nodes, faces, nan_number}; }, "the tolerance of Tied is nan; it must be zero or positive.");
  refused(
      [&] {
        Tied{nodes, faces, TieStrength{.normal = 0}};
      },
      "the normal of TieStrength is 0; it must be positive.");
  refused(
      [&] {
        Tied{nodes, faces, TieStrength{.shear = nan_number}};
      },
      "the shear of TieStrength is nan; it must be positive.");
  CHECK_NOTHROW(Tied{nodes, faces, TieStrength{}});
}
