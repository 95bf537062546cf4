#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include <strike/contact/closest_point.hpp>
#include <strike/contact/search.hpp>
#include <strike/contact/target.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike::detail {

/// True if the segment from p to q passes through a face between its ends and its edges, by more than a tolerance.
inline bool pierces(const Target& target, Index face, const Eigen::Vector3d& p, const Eigen::Vector3d& q,
                    std::span<const Eigen::Vector3d> x, double tolerance) {
  const Corners X = target.corners(face, x);
  const bool is_triangle = target.count(face) == 3;
  const Eigen::Vector3d middle = is_triangle ? (X[0] + X[1] + X[2]) / 3.0
                                             : Eigen::Vector3d(0.25 * (X[0] + X[1] + X[2] + X[3])),
                        normal = direction(cross<double>(X[2] - X[0], X[3] - X[1]));
  const double start = normal.dot(p - middle), end = normal.dot(q - middle);
  if (!(std::min(start, end) < -tolerance && std::max(start, end) > tolerance)) return false;
  const Eigen::Vector3d at = p + (start / (start - end)) * (q - p);
  const double warp = is_triangle ? 0 : 0.25 * (X[0] - X[1] + X[2] - X[3]).norm();
  const ClosestPoint point = target.closest(face, X, at);
  return point.where == ClosestPoint::inside && point.distance2 <= (warp + tolerance) * (warp + tolerance) &&
         *std::min_element(point.N.begin(), point.N.begin() + target.count(face)) > 1e-6;
}

/// Edges, by the numbers of their ends, that pass through faces of a target. `passes_by(edge, face)` tells of what has
/// nothing to do with each other; `size` is that of the faces [length].
template <class PassesBy>
std::vector<std::array<Index, 2>> piercing_edges(std::span<const std::array<Index, 2>> edges, const Target& target,
                                                 std::span<const Eigen::Vector3d> x, double size,
                                                 const PassesBy& passes_by) {
  std::vector<Eigen::Vector3d> places(x.begin(), x.end());
  std::vector<Index> middles;
  double longest = 0;
  for (const auto& [p, q] : edges) {
    middles.push_back(static_cast<Index>(places.size()));
    places.push_back(0.5 * (x[p] + x[q]));
    longest = std::max(longest, (x[q] - x[p]).norm());
  }
  BucketSearch search;
  search.sort(middles, target.faces(), places, 0.5 * longest);
  std::vector<std::array<Index, 2>> piercing;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto near = search.near(e);
    if (std::any_of(near.begin(), near.end(), [&](Index f) {
          const auto& [p, q] = edges[e];
          return !target.has(f, p) && !target.has(f, q) && !passes_by(e, f) &&
                 pierces(target, f, x[p], x[q], x, 1e-6 * size);
        }))
      piercing.push_back(edges[e]);
  }
  return piercing;
}

}  // namespace strike::detail
