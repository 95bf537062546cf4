#pragma once
#include <optional>
#include <utility>
#include <vector>

#include <strike/ascending.hpp>
#include <strike/contact/friction.hpp>
#include <strike/contact/plane_contact.hpp>
#include <strike/contact/rigid.hpp>
#include <strike/mesh/mesh.hpp>

namespace strike {

/// A rigid half-space that nodes may touch and leave but not enter, with or without Coulomb friction: the same contact
/// as Contact{NodeToRigid{nodes, RigidPlane{point, normal}}, Coulomb{friction}}, for all nodes of a scene if none are
/// given.
class RigidWall : public detail::PlaneContact<Coulomb> {
 public:
  /// The plane through `point`; `normal`, of any length, points to where nodes may be. `friction` is a coefficient.
  RigidWall(const Eigen::Vector3d& point, const Eigen::Vector3d& normal, double friction = 0)
      : PlaneContact({point, normal}, std::nullopt, Coulomb{friction}) {}
  RigidWall(const Eigen::Vector3d& point, const Eigen::Vector3d& normal, std::vector<Index> nodes, double friction = 0)
      : PlaneContact({point, normal}, detail::ascending(std::move(nodes)), Coulomb{friction}) {}
};

}  // namespace strike
