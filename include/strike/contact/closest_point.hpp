#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <strike/tensor/tensor.hpp>

namespace strike::detail {

/// Positions of the corners of a face; the last of a triangle is ignored [length].
using Corners = std::array<Eigen::Vector3d, 4>;

/// The point of a face that is closest to a node: x_c = sum of N_I x_I.
struct ClosestPoint {
  enum Where { inside, on_edge, at_corner };

  std::array<double, 4> N{};                       ///< shape functions of the corners, none negative, of sum 1
  Eigen::Vector3d away = Eigen::Vector3d::Zero();  ///< from x_c to the node [length]
  double distance2 = std::numeric_limits<double>::infinity();
  Where where = inside;
  unsigned which = 0;  ///< the edge, from corner `which` to the next, or the corner
};

/// Takes the closest point of the edge between the corners i and j if it is closer than the best.
inline void approach_edge(ClosestPoint& best, const Corners& X, const Eigen::Vector3d& x, unsigned i, unsigned j) {
  const Eigen::Vector3d along = X[j] - X[i], from = x - X[i];
  const double length2 = along.squaredNorm();
  const double t = length2 > 0 ? std::clamp(from.dot(along) / length2, 0.0, 1.0) : 0.0;
  const Eigen::Vector3d away = from - t * along;
  if (!(away.squaredNorm() < best.distance2)) return;
  best = {.away = away, .distance2 = away.squaredNorm()};
  best.N[i] = 1 - t, best.N[j] = t;
  best.where = t > 0 && t < 1 ? ClosestPoint::on_edge : ClosestPoint::at_corner;
  best.which = t < 1 ? i : j;
}

/// The closest point of a plane triangle by barycentric coordinates; outside of them that of its edges.
inline ClosestPoint closest_on_triangle(const Corners& X, const Eigen::Vector3d& x) {
  const Eigen::Vector3d b = X[1] - X[0], c = X[2] - X[0], r = x - X[0], normal = cross<double>(b, c);
  const double area2 = normal.squaredNorm();
  ClosestPoint point;
  if (area2 > 0) {
    const double s = cross<double>(r, c).dot(normal) / area2, t = cross<double>(b, r).dot(normal) / area2;
    if (s >= 0 && t >= 0 && s + t <= 1) {
      point.N = {1 - s - t, s, t, 0};
      point.away = (r.dot(normal) / area2) * normal;
      point.distance2 = point.away.squaredNorm();
      return point;
    }
  }
  for (unsigned i = 0; i < 3; ++i) approach_edge(point, X, x, i, (i + 1) % 3);
  return point;
}

/// The squared distance of a point from the box around a face: a bound of that from the face.
inline double squared_distance_to_box(const Corners& X, const Eigen::Vector3d& x) {
  double sum = 0;
  for (int c = 0; c < 3; ++c) {
    const auto [low, high] = std::minmax({X[0](c), X[1](c), X[2](c), X[3](c)});
    const double apart = std::max({low - x(c), x(c) - high, 0.0});
    sum += apart * apart;
  }
  return sum;
}

/// A bilinear quadrilateral x(s, t) = m0 + s m1 + t m2 + s t m3, |s|, |t| <= 1.
struct Quadrilateral {
  Eigen::Vector3d m0, m1, m2, m3;

  explicit Quadrilateral(const Corners& X)
      : m0(0.25 * (X[0] + X[1] + X[2] + X[3])),
        m1(0.25 * (X[1] + X[2] - X[0] - X[3])),
        m2(0.25 * (X[2] + X[3] - X[0] - X[1])),
        m3(0.25 * (X[0] - X[1] + X[2] - X[3])) {}

  /// A point at which the way r = x(s, t) - x to a node is orthogonal to both tangents.
  struct Stationary {
    double s, t;
    Eigen::Vector3d r;
    bool found;

    bool is_inside() const { return std::abs(s) <= 1 && std::abs(t) <= 1; }
    std::array<double, 4> N() const {
      const double p = 0.25 * (1 + t), m = 0.25 * (1 - t);
      return {(1 - s) * m, (1 + s) * m, (1 + s) * p, (1 - s) * p};
    }
  };
  /// By Newton's method. Where a strong warp makes its matrix indefinite, the step leaves the warp out (Gauss-Newton),
  /// which always descends.
  Stationary descend(const Eigen::Vector3d& x, double s, double t) const {
    Eigen::Vector3d r = m0 + s * m1 + t * m2 + s * t * m3 - x;
    bool found = false;
    for (int iteration = 0; iteration < 20 && !found; ++iteration) {
      const Eigen::Vector3d along_s = m1 + t * m3, along_t = m2 + s * m3;
      const double a = along_s.squaredNorm(), b = along_t.squaredNorm(), tangents = along_s.dot(along_t);
      double c = tangents + r.dot(m3), det = a * b - c * c;
      if (!(det > 1e-3 * a * b)) c = tangents, det = a * b - c * c;
      if (!(det > 1e-14 * a * b)) break;
      const double g = r.dot(along_s), h = r.dot(along_t), inverse = 1 / det;
      const double ds = std::clamp((c * h - b * g) * inverse, -2.0, 2.0),
                   dt = std::clamp((c * g - a * h) * inverse, -2.0, 2.0), step = std::abs(ds) + std::abs(dt);
      s = std::clamp(s + ds, -3.0, 3.0), t = std::clamp(t + dt, -3.0, 3.0);
      r = m0 + s * m1 + t * m2 + s * t * m3 - x;
      // Newton squares it: what is left is about step^2 |m3| / |m1|.
      found = step < 1e-7 || step * step * step * step * m3.squaredNorm() < 1e-26 * std::min(a, b);
    }
    return {s, t, r, found};
  }
};

/// The closest point of a bilinear quadrilateral: a stationary one or that of its edges. `start` is near it, at (s, t).
inline ClosestPoint closest_on_quadrilateral(const Corners& X, const Eigen::Vector3d& x,
                                             const std::array<double, 2>& start = {0, 0}) {
  const Quadrilateral face(X);
  ClosestPoint point;
  bool is_found = true;
  const auto descend_from = [&](double s, double t) {
    const auto at = face.descend(x, s, t);
    const bool holds = at.found && at.is_inside();
    if (holds && at.r.squaredNorm() < point.distance2)
      point = {.N = at.N(), .away = -at.r, .distance2 = at.r.squaredNorm()};
    is_found = is_found && holds;
  };
  descend_from(start[0], start[1]);
  const bool is_flat = face.m3.squaredNorm() < 1e-2 * std::min(face.m1.squaredNorm(), face.m2.squaredNorm());
  if (!is_flat)  // with a strong warp the distance has several local minima
    for (const double s : {-0.7, 0.7})
      for (const double t : {-0.7, 0.7}) descend_from(s, t);
  if (!is_found || !is_flat)
    for (unsigned i = 0; i < 4; ++i) approach_edge(point, X, x, i, (i + 1) % 4);
  return point;
}

/// The foot of a node's perpendicular on a face that is continued beyond its edges.
struct Projection {
  std::array<double, 4> N{};  ///< shape functions of the corners, of sum 1; negative beyond an edge
  Eigen::Vector3d away = Eigen::Vector3d::Zero();    ///< from the foot to the node [length]
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< unit, of the face at the foot
  /// How far it is beyond the edges, in widths of the face; negative within them, infinite from half a width on.
  double beyond = std::numeric_limits<double>::infinity();
  unsigned edge = 0;  ///< that it is beyond most, from corner `edge` to the next
};

/// `start` is near it, at (s, t) of a quadrilateral.
inline Projection project(const Corners& X, const Eigen::Vector3d& x, bool is_triangle,
                          const std::array<double, 2>& start = {0, 0}) {
  Projection foot;
  if (is_triangle) {
    const Eigen::Vector3d b = X[1] - X[0], c = X[2] - X[0], r = x - X[0], normal = cross<double>(b, c);
    const double area2 = normal.squaredNorm();
    if (!(area2 > 0)) return foot;
    const double s = cross<double>(r, c).dot(normal) / area2, t = cross<double>(b, r).dot(normal) / area2;
    foot.N = {1 - s - t, s, t, 0};
    foot.away = (r.dot(normal) / area2) * normal;
    foot.normal = (1 / std::sqrt(area2)) * normal;
    const auto least = std::min_element(foot.N.begin(), foot.N.begin() + 3);
    foot.beyond = -*least, foot.edge = static_cast<unsigned>(least - foot.N.begin() + 1) % 3;
    return foot;
  }
  const Quadrilateral face(X);
  const auto at = face.descend(x, start[0], start[1]);
  const double most = std::max(std::abs(at.s), std::abs(at.t));
  if (!at.found || !(most < 2)) return foot;  // where steps end
  const Eigen::Vector3d normal = cross<double>(face.m1 + at.t * face.m3, face.m2 + at.s * face.m3);
  foot.N = at.N(), foot.away = -at.r, foot.normal = direction(normal);
  foot.beyond = 0.5 * (most - 1);
  if (std::abs(at.s) > std::abs(at.t))
    foot.edge = at.s > 0 ? 1 : 3;
  else
    foot.edge = at.t > 0 ? 2 : 0;
  return foot;
}

/// The unit normal of a face at the shape functions N.
inline Eigen::Vector3d normal_at(const Corners& X, const std::array<double, 4>& N, bool is_triangle) {
  if (is_triangle) return direction(cross<double>(X[1] - X[0], X[2] - X[0]));
  const Eigen::Vector3d along_s = (N[0] + N[1]) * (X[1] - X[0]) + (N[2] + N[3]) * (X[2] - X[3]);
  const Eigen::Vector3d along_t = (N[0] + N[3]) * (X[3] - X[0]) + (N[1] + N[2]) * (X[2] - X[1]);
  const Eigen::Vector3d normal = cross<double>(along_s, along_t);
  return direction(normal.squaredNorm() > 0 ? normal : cross<double>(X[2] - X[0], X[3] - X[1]));
}

}  // namespace strike::detail
