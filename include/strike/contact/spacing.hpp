#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <strike/mesh/mesh.hpp>

namespace strike::detail {

/// The distance of each point to the nearest other that is not in the same place [length]: the size of the cells there.
/// Where the nearest is farther than the mean spacing of all, that mean.
inline std::vector<double> spacing(std::span<const Eigen::Vector3d> points) {
  std::vector<double> nearest(points.size(), std::numeric_limits<double>::infinity());
  if (points.size() < 2) return nearest;
  Eigen::Vector3d lower = points[0], upper = points[0];
  for (const Eigen::Vector3d& x : points)
    for (int c = 0; c < 3; ++c) lower(c) = std::min(lower(c), x(c)), upper(c) = std::max(upper(c), x(c));
  double longest = 0, volume = 1;
  for (int c = 0; c < 3; ++c) longest = std::max(longest, upper(c) - lower(c));
  if (!(longest > 0)) return nearest;
  const auto n = static_cast<double>(points.size());
  for (int c = 0; c < 3; ++c) volume *= std::max((upper(c) - lower(c)) / longest, 1 / n);
  const double edge = 2 * longest * std::cbrt(volume / n);

  using Bucket = std::array<std::int64_t, 3>;
  std::vector<std::pair<Bucket, Index>> filed;
  const auto bucket_of = [&](const Eigen::Vector3d& x) {
    Bucket bucket{};
    for (int c = 0; c < 3; ++c)
      bucket[static_cast<std::size_t>(c)] = static_cast<std::int64_t>((x(c) - lower(c)) / edge);
    return bucket;
  };
  for (Index i = 0; i < points.size(); ++i) filed.emplace_back(bucket_of(points[i]), i);
  std::sort(filed.begin(), filed.end());
  for (Index i = 0; i < points.size(); ++i) {
    double least2 = edge * edge;
    const Bucket at = bucket_of(points[i]);
    for (std::int64_t a = -1; a <= 1; ++a)
      for (std::int64_t b = -1; b <= 1; ++b) {  // three buckets along z are one range
        const Bucket from{at[0] + a, at[1] + b, at[2] - 1}, to{at[0] + a, at[1] + b, at[2] + 1};
        for (auto k = std::lower_bound(filed.begin(), filed.end(), std::pair(from, Index{0}));
             k != filed.end() && k->first <= to; ++k) {
          const double apart2 = (points[k->second] - points[i]).squaredNorm();
          if (apart2 > 1e-18 * longest * longest) least2 = std::min(least2, apart2);
        }
      }
    nearest[i] = std::sqrt(least2);
  }
  return nearest;
}

/// The share of a cell by which something may close in the step in which it comes to touch: what it strikes gets its
/// velocity within the step, and elements see the mean of the force.
inline constexpr double closing_share = 0.1;

/// The step in which what is `gap` apart closes by it and that share of a cell [length].
inline double closing_step(double gap, double closing_velocity, double cell) {
  return (std::max(gap, 0.0) + closing_share * cell) / closing_velocity;
}

}  // namespace strike::detail
