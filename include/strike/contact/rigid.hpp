#pragma once
#include <vector>

#include <Eigen/Core>

#include <strike/contact/concepts.hpp>
#include <strike/mesh/surface.hpp>

namespace strike {

/// The half-space behind a plane; `normal`, of any length, points to where nodes may be.
struct RigidPlane {
  Eigen::Vector3d point, normal;

  Clearance clearance(const Eigen::Vector3d& x) const {
    const Eigen::Vector3d n = normal.normalized();
    return {n.dot(x - point), n};
  }
};

/// A ball, touched from outside.
struct RigidSphere {
  Eigen::Vector3d centre;
  double radius;  ///< [length]

  Clearance clearance(const Eigen::Vector3d& x) const {
    const Eigen::Vector3d r = x - centre;
    return {r.norm() - radius, r.norm() > 0 ? Eigen::Vector3d(r.normalized()) : Eigen::Vector3d::UnitX()};
  }
};

/// An endless cylinder about the line through `point` along `axis`, of any length, touched from outside.
struct RigidCylinder {
  Eigen::Vector3d point, axis;
  double radius;  ///< [length]

  Clearance clearance(const Eigen::Vector3d& x) const {
    const Eigen::Vector3d a = axis.normalized(), r = x - point;
    return RigidSphere{Eigen::Vector3d::Zero(), radius}.clearance(Eigen::Vector3d(r - a.dot(r) * a));
  }
};

/// Faces between points that do not move, touched from the side from which their corners run counter-clockwise.
struct RigidSurface {
  std::vector<Eigen::Vector3d> points;
  std::vector<Face> faces;
};

}  // namespace strike
