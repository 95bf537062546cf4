#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include <strike/contact/closest_point.hpp>
#include <strike/contact/orientation.hpp>
#include <strike/error.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/tensor/tensor.hpp>
#include <strike/text.hpp>

namespace strike::detail {

/// The foot of a node on a face.
struct Foot {
  Index face = 0;
  ClosestPoint point;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< from the closest point, to the outside
  double height = 0;                                 ///< distance, negative inside [length]
  bool on_border = false;                            ///< at an edge that no other face shares
};

/// Faces that nodes may touch, with their neighbours: those of solids from outside, plates from both sides at half
/// their thickness, which goes evenly from node to node over a face.
class Target {
 public:
  static constexpr Index none = std::numeric_limits<Index>::max();

  Target() = default;
  /// Faces by their corners among n ContactNodes; a triangle repeats its third corner. Of each, or of none, the
  /// thickness of its plate, 0 of a solid [length].
  Target(std::vector<FaceCorners> faces, std::size_t n, std::vector<double> thickness = {})
      : faces_(std::move(faces)), thickness_(std::move(thickness)), first_(n + 1, 0) {
    thickness_.resize(faces_.size());
    const auto each_corner = [&](auto f) {
      for (std::size_t k = 0; k < faces_.size(); ++k)
        for (unsigned i = 0; i < count(k); ++i) f(k, faces_[k][i]);
    };
    each_corner([&](std::size_t, Index i) { ++first_[i + 1]; });
    for (std::size_t i = 0; i < n; ++i) first_[i + 1] += first_[i];
    at_.resize(first_.back());
    std::vector<std::size_t> end(first_.begin(), first_.end() - 1);
    each_corner([&](std::size_t k, Index i) { at_[end[i]++] = static_cast<Index>(k); });
    across_.resize(faces_.size());
    for (std::size_t k = 0; k < faces_.size(); ++k)
      for (unsigned i = 0; i < 4; ++i) across_[k][i] = i < count(k) ? find_across(k, i) : none;
    find_halves();
  }

  const std::vector<FaceCorners>& faces() const { return faces_; }
  unsigned count(std::size_t face) const { return faces_[face][2] == faces_[face][3] ? 3 : 4; }
  bool has(Index face, Index node) const {
    return std::find(faces_[face].begin(), faces_[face].end(), node) != faces_[face].end();
  }
  /// Leaves out the contact of pieces; `piece` is that of each face.
  void keep_apart(std::vector<std::array<Index, 2>> pieces, std::vector<Index> piece) {
    apart_ = std::move(pieces), piece_ = std::move(piece);
  }
  /// False for a node of the surface and a face whose pieces are kept apart.
  bool may_touch(Index node, Index face) const {
    return apart_.empty() || at(node).empty() ||
           std::any_of(at(node).begin(), at(node).end(), [&](Index own) { return !are_apart(own, face); });
  }
  bool are_apart(Index face, Index other) const {
    return std::any_of(apart_.begin(), apart_.end(), [&](const std::array<Index, 2>& pair) {
      return (pair[0] == piece_[face] && pair[1] == piece_[other]) ||
             (pair[1] == piece_[face] && pair[0] == piece_[other]);
    });
  }
  bool is_plate(Index face) const { return thickness_[face] > 0; }
  bool are_alike(Index face, Index other) const { return is_plate(face) == is_plate(other); }
  /// Half the thickness of the plates at a node, their mean; 0 of solids [length].
  double half(Index node) const { return half_[node]; }
  /// The largest half of a thickness [length].
  double largest_half() const { return half_.empty() ? 0 : *std::max_element(half_.begin(), half_.end()); }
  double largest_half(Index face) const {
    if (!is_plate(face)) return 0;
    const auto& c = faces_[face];
    return std::max({half_[c[0]], half_[c[1]], half_[c[2]], half_[c[3]]});
  }
  /// How far the surface of a face is from its middle at shape functions N, 0 of solids [length].
  double half(Index face, const std::array<double, 4>& N) const {
    if (!is_plate(face)) return 0;
    double sum = 0;
    for (unsigned k = 0; k < count(face); ++k) sum += N[k] * half_[faces_[face][k]];
    return sum;
  }
  /// The faces that have a node as a corner.
  std::span<const Index> at(Index node) const { return {at_.data() + first_[node], first_[node + 1] - first_[node]}; }

  /// The face beyond edge i of a face, from its corner i to the next, a plate beyond a plate and a solid's beyond a
  /// solid's; `none` at a border.
  Index across(Index face, unsigned i) const { return across_[face][i]; }

  /// The face with these corners, from either side; `none` if there is none.
  Index find(const FaceCorners& corners) const {
    for (const Index face : at(corners[0]))
      if (faces_[face] == corners || faces_[face] == turned_over(corners)) return face;
    return none;
  }

  /// Mean diagonal of the faces [length].
  double mean_size(std::span<const Eigen::Vector3d> x) const {
    double sum = 0;
    for (const auto& face : faces_) sum += (x[face[2]] - x[face[0]]).norm() / static_cast<double>(faces_.size());
    return sum;
  }
  Corners corners(Index face, std::span<const Eigen::Vector3d> x) const {
    const auto& c = faces_[face];
    return {x[c[0]], x[c[1]], x[c[2]], x[c[3]]};
  }
  /// The unit normal of a face in its middle.
  Eigen::Vector3d normal(Index face, std::span<const Eigen::Vector3d> x) const {
    return normal_at(corners(face, x), {0.25, 0.25, 0.25, 0.25}, count(face) == 3);
  }
  /// Positions after a time t at velocities v.
  Corners corners(Index face, std::span<const Eigen::Vector3d> x, std::span<const Eigen::Vector3d> v, double t) const {
    Corners X = corners(face, x);
    for (unsigned i = 0; i < 4; ++i) X[i] += t * v[faces_[face][i]];
    return X;
  }
  Eigen::Vector3d middle(Index face, std::span<const Eigen::Vector3d> x) const {
    const Corners X = corners(face, x);
    return count(face) == 3 ? (1.0 / 3) * (X[0] + X[1] + X[2]) : 0.25 * (X[0] + X[1] + X[2] + X[3]);
  }

  ClosestPoint closest(Index face, const Corners& X, const Eigen::Vector3d& at,
                       const std::array<double, 2>& start = {0, 0}) const {
    return count(face) == 3 ? closest_on_triangle(X, at) : closest_on_quadrilateral(X, at, start);
  }
  Foot foot(Index face, const Corners& X, const Eigen::Vector3d& at, std::span<const Eigen::Vector3d> x) const {
    return foot(face, X, closest(face, X, at), x);
  }
  /// The foot of a node on a face. Over an edge or a corner the side is given by the mean of the normals around it,
  /// weighted by their angles, which is right on every closed surface (Baerentzen and Aanaes 2005).
  Foot foot(Index face, const Corners& X, const ClosestPoint& point, std::span<const Eigen::Vector3d> x) const {
    Foot foot;
    foot.face = face, foot.point = point;
    const bool triangle = count(face) == 3;
    if (foot.point.where == ClosestPoint::inside) {
      foot.normal = normal_at(X, foot.point.N, triangle);
      foot.height = foot.normal.dot(foot.point.away);
      return foot;
    }
    const Eigen::Vector3d outside = outside_of(foot, X, x);
    const double distance = std::sqrt(foot.point.distance2);
    const double side = foot.point.away.dot(outside) < 0 ? -1 : 1;
    const bool apart = distance > 1e-12 * (X[2] - X[0]).norm();
    foot.height = side * distance;
    foot.normal = apart ? (side / distance) * foot.point.away : direction(outside);
    return foot;
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(faces_, across_, thickness_, half_, piece_, first_, at_);
  }

 private:
  /// The face beyond edge i of face k: of a solid beyond that of a solid, a plate beyond a plate.
  Index find_across(std::size_t k, unsigned i) const {
    const Index a = faces_[k][i], b = faces_[k][(i + 1) % count(k)];
    for (const Index other : at(a))
      if (other != k && has(other, b) && are_alike(static_cast<Index>(k), other)) return other;
    return none;
  }
  void find_halves() {
    half_.assign(first_.size() - 1, 0.0);
    for (Index i = 0; i < half_.size(); ++i) {
      double plates = 0;
      for (const Index face : at(i)) half_[i] += 0.5 * thickness_[face], plates += is_plate(face) ? 1 : 0;
      if (plates > 0) half_[i] /= plates;
    }
  }

  /// A vector to the outside at an edge or a corner; sets `on_border`.
  Eigen::Vector3d outside_of(Foot& foot, const Corners& X, std::span<const Eigen::Vector3d> x) const {
    const auto& point = foot.point;
    if (point.where == ClosestPoint::on_edge) {
      const Index other = across_[foot.face][point.which];
      foot.on_border = other == none;
      const Eigen::Vector3d own = mean_normal(X);
      return other == none ? own : Eigen::Vector3d(own + mean_normal(corners(other, x)));
    }
    const Index corner = faces_[foot.face][point.which];
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Index face : at(corner)) {
      if (!are_alike(foot.face, face)) continue;
      const Corners Y = corners(face, x);
      const unsigned n = count(face);
      for (unsigned i = 0; i < n; ++i) {
        if (faces_[face][i] != corner) continue;
        const Eigen::Vector3d a = Y[(i + 1) % n] - Y[i], b = Y[(i + n - 1) % n] - Y[i];
        sum += std::atan2(cross<double>(a, b).norm(), a.dot(b)) * mean_normal(Y);
        foot.on_border |= across_[face][i] == none || across_[face][(i + n - 1) % n] == none;
      }
    }
    return sum;
  }
  static Eigen::Vector3d mean_normal(const Corners& X) { return direction(cross<double>(X[2] - X[0], X[3] - X[1])); }

  std::vector<FaceCorners> faces_, across_;
  std::vector<double> thickness_;            // of each face
  std::vector<std::array<Index, 2>> apart_;  // pieces that do not touch
  std::vector<Index> piece_;                 // of each face, where some are apart
  std::vector<double> half_;                 // of each node
  std::vector<std::size_t> first_;
  std::vector<Index> at_;
};

}  // namespace strike::detail
