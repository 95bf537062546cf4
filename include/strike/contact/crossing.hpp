#pragma once
#include <algorithm>
#include <array>
#include <cmath>

#include <strike/contact/closest_point.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike::detail {

/// A face and a node that move at constant velocities for a while: positions at its start, and the ways until its end.
struct Motion {
  Corners X, way_of_corners;
  Eigen::Vector3d x, way;
  bool is_triangle;

  /// The way of the node relative to a point of the face.
  Eigen::Vector3d relative_way(const std::array<double, 4>& N) const {
    Eigen::Vector3d relative = way;
    for (unsigned i = 0; i < (is_triangle ? 3 : 4); ++i) relative -= N[i] * way_of_corners[i];
    return relative;
  }
  Corners corners(double t) const {
    Corners then = X;
    for (unsigned i = 0; i < 4; ++i) then[i] += t * way_of_corners[i];
    return then;
  }
  ClosestPoint closest(double t) const {
    const Corners then = corners(t);
    const Eigen::Vector3d at = x + t * way;
    return is_triangle ? closest_on_triangle(then, at) : closest_on_quadrilateral(then, at);
  }
};

/// How near nodes and faces must come to meet, and from which sides.
struct Reach {
  double own = 0;                      ///< half the thickness of the node's plate, 0 of solids [length]
  std::array<double, 4> of_corners{};  ///< of the face's plate at its corners
  double tolerance = 0;                ///< within which a point counts as on a face or its edge [length]
  bool two_sided = false;              ///< the face is a plate
  double slack = 0;  ///< by which a node may be inside at the start, if it comes from next to the face [length]

  /// The distance of both middles when they touch, where the face has the shape functions N [length].
  double depth(const std::array<double, 4>& N) const {
    return two_sided ? own + N[0] * of_corners[0] + N[1] * of_corners[1] + N[2] * of_corners[2] + N[3] * of_corners[3]
                     : own;
  }
  double largest_depth() const { return own + *std::max_element(of_corners.begin(), of_corners.end()); }
};

/// The meeting of a node with a face, to which its edges and corners belong, from outside.
struct Crossing {
  double when = 2;                                   ///< as a fraction of the motion; 2: never
  double rate = 0;                                   ///< of approach along the normal, over the motion [length]
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< unit, to the side of the node
  ClosestPoint point;                                ///< then

  bool happens() const { return when <= 1; }
};

/// False if boxes around the ways of both stay apart, or the node is on the same side of the face at the start and at
/// the end, farther from its middle plane than its warp and the depth, or recedes.
inline bool may_cross(const Motion& motion, const Reach& reach) {
  const auto& [X, U, x, u, triangle] = motion;
  const bool is_triangle = triangle;
  const double margin = reach.largest_depth() + reach.tolerance + reach.slack;
  for (int c = 0; c < 3; ++c) {
    const auto [a, b] = std::minmax({X[0](c), X[1](c), X[2](c), X[3](c)});
    const auto [p, q] = std::minmax({X[0](c) + U[0](c), X[1](c) + U[1](c), X[2](c) + U[2](c), X[3](c) + U[3](c)});
    const double at = x(c), end = x(c) + u(c);
    if (std::max(at, end) < std::min(a, p) - margin || std::min(at, end) > std::max(b, q) + margin) return false;
  }
  const auto height = [&](const Corners& Y, const Eigen::Vector3d& y, double& apart) {
    const Eigen::Vector3d area = cross<double>(Y[2] - Y[0], Y[3] - Y[1]);
    apart = (margin + (is_triangle ? 0 : 0.25 * (Y[0] - Y[1] + Y[2] - Y[3]).norm())) * area.norm();
    return (y - 0.25 * (Y[0] + Y[1] + Y[2] + Y[3])).dot(area);
  };
  double apart[2];
  const double start = height(X, x, apart[0]), end = height(motion.corners(1), x + u, apart[1]);
  if (!reach.two_sided) return start >= -apart[0] && end <= apart[1] && (end < start || reach.slack > 0);
  return !(start > apart[0] && end > apart[1]) && !(start < -apart[0] && end < -apart[1]);
}

/// The first time at which the node is as near to the face as the depth. The distance to a plane face in translation
/// is a convex function of time, which Newton's method follows from the start without passing its first root
/// (conservative advancement, Mirtich 1996); where faces warp and turn, it returns from beyond.
inline Crossing crossing(const Motion& motion, const Reach& reach) {
  Crossing none;
  if (!may_cross(motion, reach)) return none;
  double t = 0;
  for (int iteration = 0; iteration < 50; ++iteration) {
    Crossing found;
    found.point = motion.closest(t);
    const Eigen::Vector3d way = motion.relative_way(found.point.N);
    const bool over_edge = found.point.where != ClosestPoint::inside;
    double distance = std::sqrt(found.point.distance2);
    Eigen::Vector3d normal = normal_at(motion.corners(t), found.point.N, motion.is_triangle);
    if (!reach.two_sided && !over_edge)
      distance = normal.dot(found.point.away);
    else if (distance > reach.tolerance)
      normal = (1 / distance) * found.point.away;
    const double gap = distance - reach.depth(found.point.N);
    if (std::abs(gap) <= reach.tolerance) {
      found.when = t, found.normal = normal, found.rate = -normal.dot(way);
      return found.rate > 0 ? found : none;
    }
    if (t == 0 && gap < 0) {  // it does not come from outside
      if (over_edge || gap < -reach.slack) return none;
      found.when = 0, found.normal = normal, found.rate = std::max(-normal.dot(way), reach.tolerance);
      return found;
    }
    const double closing = -normal.dot(way);
    if (!(closing > 0)) return none;
    t += gap / closing;
    if (!(t <= 1)) return none;
    t = std::max(t, 0.0);
  }
  return none;
}

}  // namespace strike::detail
