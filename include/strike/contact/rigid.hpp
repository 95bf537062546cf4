#pragma once
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <strike/contact/concepts.hpp>
#include <strike/mesh/surface.hpp>
#include <strike/range.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike {

/// The half-space behind a plane; `normal`, of any length, points to where nodes may be.
struct RigidPlane {
  Eigen::Vector3d point, normal;

  void ranges(const auto& number) const {
    number("point", point, range::point);
    number("normal", normal, range::direction);
  }

  Clearance clearance(const Eigen::Vector3d& x) const {
    using namespace detail;
    const Eigen::Vector3d n = direction(normal);
    return {n.dot(x - point), n};
  }
};

/// A ball, touched from outside.
struct RigidSphere {
  Eigen::Vector3d centre;
  double radius;  ///< [length]

  void ranges(const auto& number) const {
    number("centre", centre, range::point);
    number("radius", radius, range::positive);
  }

  Clearance clearance(const Eigen::Vector3d& x) const {
    using namespace detail;
    const Eigen::Vector3d r = x - centre;
    return {r.norm() - radius, r.norm() > 0 ? direction(r) : Eigen::Vector3d{1, 0, 0}};
  }
};

/// A cylinder about the line through `point` along `axis`, of any length, touched from outside: endless, or from the
/// point along the axis as long as `length`, with flat ends.
struct RigidCylinder {
  Eigen::Vector3d point, axis;
  double radius;                                            ///< [length]
  double length = std::numeric_limits<double>::infinity();  ///< [length]

  void ranges(const auto& number) const {
    number("point", point, range::point);
    number("axis", axis, range::direction);
    number("radius", radius, range::positive);
    number("length", length, range::or_infinite(range::positive));
  }

  Clearance clearance(const Eigen::Vector3d& x) const {
    using namespace detail;
    const Eigen::Vector3d a = direction(axis), r = x - point;
    const double along = a.dot(r);
    const Clearance side = RigidSphere{{0, 0, 0}, radius}.clearance(r - along * a);
    if (std::isinf(length)) return side;
    const double beyond = std::abs(along - 0.5 * length) - 0.5 * length;  // an end
    const Clearance end{beyond, along < 0.5 * length ? Eigen::Vector3d(-a) : a};
    if (!(side.gap > 0 && beyond > 0)) return side.gap > beyond ? side : end;
    const Eigen::Vector3d from_edge = side.gap * side.normal + beyond * end.normal;
    return {from_edge.norm(), direction(from_edge)};
  }
};

/// Faces between points that do not move, touched from the side from which their corners run counter-clockwise.
struct RigidSurface {
  std::vector<Eigen::Vector3d> points;
  std::vector<Face> faces;

  void ranges(const auto& number) const {
    for (std::size_t i = 0; i < points.size(); ++i)
      number(("point " + std::to_string(i)).c_str(), points[i], range::point);
  }
};

}  // namespace strike
