#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include <Eigen/Core>

#include <strike/cxx20.hpp>

namespace strike::detail {

/// A face in a picture, or a ball around its only corner.
struct Figure {
  std::array<Eigen::Vector3d, 4> corners;  // x and y in the picture, depth toward the eye [length]
  std::size_t size;                        // number of corners
  double depth;                            // of the centre
  double light, value;
  bool plain;         // without value
  double radius = 0;  // of a ball, 0 of a dot [length]

  bool is_ball() const { return size == 1; }
};

/// The depth of a face where it is nearest to a place in the picture; NaN if that is farther away than a distance.
[[gnu::cold]] inline double depth_near(const Figure& face, const Eigen::Vector3d& place, double distance) {
  const auto& x = face.corners;
  for (std::size_t k = 2; k < face.size; ++k) {  // inside a triangle (0, k - 1, k)
    const Eigen::Vector3d u = x[k - 1] - x[0], v = x[k] - x[0], p = place - x[0];
    const double area = u[0] * v[1] - u[1] * v[0];
    const double s = (p[0] * v[1] - p[1] * v[0]) / area, t = (u[0] * p[1] - u[1] * p[0]) / area;
    if (s >= 0 && t >= 0 && s + t <= 1) return x[0][2] + s * u[2] + t * v[2];
  }
  double least = distance * distance, depth = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t k = 0; k < face.size; ++k) {
    const Eigen::Vector3d u = x[(k + 1) % face.size] - x[k], p = place - x[k];
    const double length = u.head<2>().squaredNorm();
    const double t = length > 0 ? std::clamp(p.head<2>().dot(u.head<2>()) / length, 0.0, 1.0) : 0.0;
    const double square = (p - t * u).head<2>().squaredNorm();
    if (square <= least) least = square, depth = x[k][2] + t * u[2];
  }
  return depth;
}

/// Figures from the back to the front. Faces, and balls, are each in the order of their centres. A ball comes after
/// the faces behind it and before those in front of it, by the depth that they have where they overlap it: the centre
/// of a slanting face can be nearer to the eye than a ball in front of its edge. Where a face in front of a ball has
/// its centre behind that of a face behind the ball, the ball is seen.
[[gnu::cold]] inline std::vector<const Figure*> back_to_front(std::span<const Figure> figures) {
  std::vector<const Figure*> faces, balls;
  for (const Figure& figure : figures) (figure.is_ball() ? balls : faces).push_back(&figure);
  const auto is_behind = [](const Figure* a, const Figure* b) {
    return a->depth != b->depth ? a->depth < b->depth : a < b;  // one order on every machine
  };
  std::sort(faces.begin(), faces.end(), is_behind), std::sort(balls.begin(), balls.end(), is_behind);

  // The bounds of faces in the picture, by which most are far from a ball.
  std::vector<std::array<double, 4>> bounds;
  for (const Figure* face : faces) {
    Eigen::Vector3d lower = face->corners[0], upper = lower;
    for (std::size_t k = 1; k < face->size; ++k)
      lower = lower.cwiseMin(face->corners[k]), upper = upper.cwiseMax(face->corners[k]);
    bounds.push_back({lower[0], upper[0], lower[1], upper[1]});
  }
  // Numbers of faces before each ball: those that have to be, those that may be, and those that are.
  std::vector<std::size_t> least(balls.size(), 0), most(balls.size(), faces.size()), before;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const Figure& ball = *balls[i];
    const Eigen::Vector3d& x = ball.corners[0];
    const double r = ball.radius;
    for (std::size_t k = 0; k < faces.size(); ++k) {
      if (x[0] < bounds[k][0] - r || x[0] > bounds[k][1] + r || x[1] < bounds[k][2] - r || x[1] > bounds[k][3] + r)
        continue;
      const double depth = depth_near(*faces[k], x, r);
      if (depth <= ball.depth) least[i] = k + 1;
      if (depth > ball.depth) most[i] = std::min(most[i], k);
    }
    const auto behind = [](const Figure* face, double depth) { return face->depth <= depth; };
    before.push_back(
        static_cast<std::size_t>(std::lower_bound(faces.begin(), faces.end(), ball.depth, behind) - faces.begin()));
  }
  // Balls in front of a plate stay in their own order as they pass its faces, as do balls behind it.
  std::size_t bound = 0;
  for (std::size_t i = 0; i < balls.size(); ++i)
    bound = std::max(bound, least[i]), before[i] = std::max(before[i], bound);
  bound = faces.size();
  for (std::size_t i = balls.size(); i-- > 0;)
    bound = std::min(bound, most[i]), before[i] = std::max(least[i], std::min(before[i], bound));

  std::vector<std::size_t> sequence(balls.size());
  for (std::size_t i = 0; i < balls.size(); ++i) sequence[i] = i;
  std::stable_sort(sequence.begin(), sequence.end(),
                   [&](std::size_t a, std::size_t b) { return before[a] < before[b]; });
  std::vector<const Figure*> order;
  std::size_t drawn = 0;
  for (const std::size_t i : sequence) {
    while (drawn < before[i]) order.push_back(faces[drawn++]);
    order.push_back(balls[i]);
  }
  order.insert(order.end(), faces.begin() + static_cast<std::ptrdiff_t>(drawn), faces.end());
  return order;
}

}  // namespace strike::detail
