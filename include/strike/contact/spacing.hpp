#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

#include <Eigen/Core>

#include <strike/mesh/mesh.hpp>

namespace strike::detail {

/// Nearest neighbours by a tree that halves the points along the widest side of their box (Bentley 1975): n log n,
/// however they lie.
class NearestNeighbour {
 public:
  explicit NearestNeighbour(std::span<const Eigen::Vector3d> points)
      : points_(points), order_(points.size()), axis_(points.size()) {
    std::iota(order_.begin(), order_.end(), Index{0});
    split(0, order_.size());
  }
  /// The distance of point i to the nearest that is not in the same place; infinite if there is none [length].
  double distance(Index i) const {
    double least2 = std::numeric_limits<double>::infinity();
    look(points_[i], 0, order_.size(), least2);
    return std::sqrt(least2);
  }

 private:
  static constexpr std::size_t leaf = 8;

  void split(std::size_t begin, std::size_t end) {
    if (end - begin <= leaf) return;
    Eigen::Vector3d lower = points_[order_[begin]], upper = lower;
    for (std::size_t k = begin; k < end; ++k)
      for (int c = 0; c < 3; ++c) {
        lower(c) = std::min(lower(c), points_[order_[k]](c)), upper(c) = std::max(upper(c), points_[order_[k]](c));
      }
    int widest = 0;
    for (const int c : {1, 2})
      if (upper(c) - lower(c) > upper(widest) - lower(widest)) widest = c;
    const std::size_t middle = (begin + end) / 2;
    const auto at = [&](std::size_t k) { return order_.begin() + static_cast<std::ptrdiff_t>(k); };
    std::nth_element(at(begin), at(middle), at(end),
                     [&](Index i, Index j) { return points_[i](widest) < points_[j](widest); });
    axis_[middle] = widest;
    split(begin, middle), split(middle + 1, end);
  }
  void look(const Eigen::Vector3d& x, std::size_t begin, std::size_t end, double& least2) const {
    const auto take = [&](Index j) {
      const double apart2 = (points_[j] - x).squaredNorm();
      if (apart2 > 0 && apart2 < least2) least2 = apart2;
    };
    if (end - begin <= leaf) {
      for (std::size_t k = begin; k < end; ++k) take(order_[k]);
      return;
    }
    const std::size_t middle = (begin + end) / 2;
    const double beyond = x(axis_[middle]) - points_[order_[middle]](axis_[middle]);
    take(order_[middle]);
    const auto low = [&] { look(x, begin, middle, least2); };
    const auto high = [&] { look(x, middle + 1, end, least2); };
    beyond < 0 ? low() : high();
    if (beyond * beyond < least2) beyond < 0 ? high() : low();
  }

  std::span<const Eigen::Vector3d> points_;
  std::vector<Index> order_;
  std::vector<int> axis_;
};

/// The size of the cells around each point: the distance to the nearest other, and for bodies that nearly touch no less
/// than a tenth of its median [length].
inline std::vector<double> spacing(std::span<const Eigen::Vector3d> points) {
  const NearestNeighbour nearest(points);
  std::vector<double> distance(points.size());
  for (Index i = 0; i < points.size(); ++i) distance[i] = nearest.distance(i);
  if (points.empty()) return distance;
  std::vector<double> sorted = distance;
  const auto median = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), median, sorted.end());
  if (std::isfinite(*median))
    for (double& d : distance) d = std::max(d, 0.1 * *median);
  return distance;
}

/// The share of a cell by which something may close in the step in which it comes to touch: what it strikes gets its
/// velocity within the step, and elements see the mean of the force.
inline constexpr double closing_share = 0.1;

/// The step in which what is `gap` apart closes by it and that share of a cell [length].
inline double closing_step(double gap, double closing_velocity, double cell) {
  return (std::max(gap, 0.0) + closing_share * cell) / closing_velocity;
}

}  // namespace strike::detail
