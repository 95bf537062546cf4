#pragma once
#include <utility>
#include <vector>

#include <strike/ascending.hpp>
#include <strike/contact/friction.hpp>
#include <strike/contact/plane_contact.hpp>
#include <strike/contact/rigid.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/range.hpp>

namespace strike {

/// A rigid half-space that nodes may touch and leave but not enter, with or without Coulomb friction: the same contact
/// as Contact{NodeToRigid{nodes, RigidPlane{point, normal}}, Coulomb{friction}}, for all nodes of a scene if none are
/// given.
class RigidWall : public detail::PlaneContact<Coulomb> {
 public:
  /// The plane through `point`; `normal`, of any length, points to where nodes may be. `friction` is a coefficient.
  /// Error: a number out of its range.
  RigidWall(const Eigen::Vector3d& point, const Eigen::Vector3d& normal, double friction = 0)
      : PlaneContact({point, normal}, Coulomb{friction}), plane_{point, normal}, coefficient_(friction) {
    detail::check_ranges(*this);
  }
  RigidWall(const Eigen::Vector3d& point, const Eigen::Vector3d& normal, std::vector<Index> nodes, double friction = 0)
      : PlaneContact({point, normal}, detail::ascending(std::move(nodes)), Coulomb{friction}),
        plane_{point, normal},
        coefficient_(friction) {
    detail::check_ranges(*this);
  }

  void ranges(const auto& number) const {
    number("point", plane_.point, range::point);
    number("normal", plane_.normal, range::direction);
    number("friction", coefficient_, range::not_negative);
  }

 private:
  RigidPlane plane_;
  double coefficient_;
};

}  // namespace strike
