#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <strike/contact/closest_point.hpp>
#include <strike/contact/search.hpp>
#include <strike/contact/target.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike::detail {

/// An edge from p to q, and the faces near it that may touch it.
class Piercing {
 public:
  Piercing(const Target& target, std::span<const Eigen::Vector3d> x, Eigen::Vector3d p, Eigen::Vector3d q)
      : target_(target), x_(x), p_(std::move(p)), way_(q - p_) {}

  void look(Index face) {
    near_.push_back(face);
    const double start = height(face, p_), end = height(face, p_ + way_);
    if (!(std::min(start, end) < 0 && std::max(start, end) > 0)) return;
    const double along = start / (start - end);
    const Corners X = target_.corners(face, x_);
    const double warp = target_.count(face) == 3 ? 0 : 0.25 * (X[0] - X[1] + X[2] - X[3]).norm();
    const ClosestPoint point = target_.closest(face, X, p_ + along * way_);
    if (point.where == ClosestPoint::inside && point.distance2 <= warp * warp + 1e-12 * way_.squaredNorm())
      passed_.push_back({along, face});
  }
  /// True if it passes through a plate, or in and out of a solid, and is beyond it by more than a tenth of its own
  /// length there: what curves needs less to lie on another.
  bool passes() {
    std::sort(passed_.begin(), passed_.end());
    const double length = way_.norm();
    for (std::size_t k = 0; k < passed_.size(); ++k) {
      const auto& [along, face] = passed_[k];
      if (target_.is_plate(face)) {
        if (std::min(std::abs(height(face, p_)), std::abs(height(face, p_ + way_))) > 0.1 * length) return true;
      } else if (k + 1 < passed_.size()) {
        const double beyond = passed_[k + 1].first;
        const Eigen::Vector3d middle = p_ + 0.5 * (along + beyond) * way_;
        if (height(face, middle) < 0 && distance(middle) > 0.1 * (beyond - along) * length) return true;
      }
    }
    return false;
  }

 private:
  double height(Index face, const Eigen::Vector3d& at) const {
    const Corners X = target_.corners(face, x_);
    const Eigen::Vector3d diagonals = cross<double>(X[2] - X[0], X[3] - X[1]);
    return direction(diagonals).dot(at - (target_.count(face) == 3 ? X[0] : target_.middle(face, x_)));
  }

  double distance(const Eigen::Vector3d& at) const {
    double least2 = std::numeric_limits<double>::infinity();
    for (const Index f : near_) least2 = std::min(least2, target_.closest(f, target_.corners(f, x_), at).distance2);
    return std::sqrt(least2);
  }

  const Target& target_;
  std::span<const Eigen::Vector3d> x_;
  Eigen::Vector3d p_, way_;
  std::vector<Index> near_;
  std::vector<std::pair<double, Index>> passed_;  // places along the edge, from 0 to 1
};

/// The edges, by their ends, that pass through a target. `passes_by(edge, face)` tells of what never touches.
template <class PassesBy>
std::vector<std::array<Index, 2>> piercing_edges(std::span<const std::array<Index, 2>> edges, const Target& target,
                                                 std::span<const Eigen::Vector3d> x, const PassesBy& passes_by) {
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
  std::vector<std::array<Index, 2>> found;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto& [p, q] = edges[e];
    Piercing piercing(target, x, x[p], x[q]);
    for (const Index f : search.near(e))
      if (!target.has(f, p) && !target.has(f, q) && !passes_by(e, f)) piercing.look(f);
    if (piercing.passes()) found.push_back(edges[e]);
  }
  return found;
}

}  // namespace strike::detail
