#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include <Eigen/Core>

#include <strike/contact/closest_point.hpp>
#include <strike/contact/target.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike::detail {

/// The bodies that closed pieces of a surface enclose: a point is inside one if a ray from it leaves the piece once
/// more than it enters. Faces stand in columns along the ray, so that a point looks at few of them.
class Interior {
 public:
  Interior(const Target& target, std::span<const Eigen::Vector3d> x) : target_(target), x_(x) {
    find_pieces();
    const std::size_t faces = target.faces().size();
    boxes_.resize(faces);
    for (std::size_t f = 0; f < faces; ++f) {
      for (const Index corner : target.faces()[f]) boxes_[f].take(across_ray(x[corner]));
      all_.take(boxes_[f].lower), all_.take(boxes_[f].upper);
    }
    columns_ = std::max<std::size_t>(1, static_cast<std::size_t>(std::sqrt(static_cast<double>(faces))));
    first_.assign(columns_ * columns_ + 1, 0);
    each_entry([&](std::size_t column, Index) { ++first_[column + 1]; });
    for (std::size_t c = 0; c + 1 < first_.size(); ++c) first_[c + 1] += first_[c];
    in_column_.resize(first_.back());
    std::vector<std::size_t> end(first_.begin(), first_.end() - 1);
    each_entry([&](std::size_t column, Index f) { in_column_[end[column]++] = f; });
  }

  /// The nearest face of the bodies that a node is inside of, other than its own; `none` if it is outside of all. The
  /// node is looked at a little within its own solid, to which `outward` is its normal (or zero), `by` a length; a face
  /// that looks the same way, with which it is flush, is none that it has come through.
  Index nearest_face(Index node, const Eigen::Vector3d& outward, double by) const {
    std::array<Index, 2> best{Target::none, Target::none};  // of those that it may have come through, and of all
    std::array<double, 2> least;
    least.fill(std::numeric_limits<double>::infinity());
    for (const Index piece : pieces_around(node, x_[node] - by * outward))
      for (Index f = 0; f < piece_.size(); ++f) {
        if (piece_[f] != piece) continue;
        const Corners X = target_.corners(f, x_);
        if (squared_distance_to_box(X, x_[node]) >= least[0]) continue;
        const double distance2 = target_.closest(f, X, x_[node]).distance2;
        const bool is_flush = target_.normal(f, x_).dot(outward) > 0.3;
        for (std::size_t k = is_flush ? 1 : 0; k < 2; ++k)
          if (distance2 < least[k]) least[k] = distance2, best[k] = f;
      }
    return best[0] != Target::none ? best[0] : best[1];
  }

 private:
  using Plane = std::array<double, 2>;
  struct Box {
    static constexpr double infinity = std::numeric_limits<double>::infinity();
    Plane lower{infinity, infinity}, upper{-infinity, -infinity};

    void take(const Plane& at) {
      for (std::size_t c = 0; c < 2; ++c) lower[c] = std::min(lower[c], at[c]), upper[c] = std::max(upper[c], at[c]);
    }
  };

  /// Pieces hang together by edges; one with a border, or of plates, encloses nothing.
  void find_pieces() {
    piece_.assign(target_.faces().size(), Target::none);
    std::vector<Index> reached;
    for (std::size_t first = 0; first < piece_.size(); ++first) {
      if (piece_[first] != Target::none) continue;
      const auto piece = static_cast<Index>(is_closed_.size());
      is_closed_.push_back(!target_.is_plate(static_cast<Index>(first)));
      piece_[first] = piece, reached.push_back(static_cast<Index>(first));
      while (!reached.empty()) {
        const Index f = reached.back();
        reached.pop_back();
        for (unsigned k = 0; k < target_.count(f); ++k) {
          const Index other = target_.across(f, k);
          if (other == Target::none)
            is_closed_[piece] = false;
          else if (piece_[other] == Target::none)
            piece_[other] = piece, reached.push_back(other);
        }
      }
    }
  }

  /// The ray runs along (a, b, 1), which is parallel to no face of a usual mesh.
  static Plane across_ray(const Eigen::Vector3d& x) { return {x[0] - a * x[2], x[1] - b * x[2]}; }

  template <class G>
  void each_entry(const G& g) const {
    for (Index f = 0; f < boxes_.size(); ++f) {
      const auto low = column_of(boxes_[f].lower), high = column_of(boxes_[f].upper);
      for (std::size_t j = low[1]; j <= high[1]; ++j)
        for (std::size_t i = low[0]; i <= high[0]; ++i) g(j * columns_ + i, f);
    }
  }
  std::array<std::size_t, 2> column_of(const Plane& at) const {
    std::array<std::size_t, 2> column{};
    for (std::size_t c = 0; c < 2; ++c) {
      const double width = all_.upper[c] - all_.lower[c], n = static_cast<double>(columns_);
      const double place = width > 0 ? (at[c] - all_.lower[c]) / width * n : 0.0;
      column[c] = static_cast<std::size_t>(std::clamp(place, 0.0, n - 1));
    }
    return column;
  }

  /// The pieces that a point near a node is inside of, by the turns of their faces around its ray.
  std::vector<Index> pieces_around(Index node, const Eigen::Vector3d& point) const {
    std::vector<Index> own, inside;
    for (const Index f : target_.at(node)) own.push_back(piece_[f]);
    const Plane at = across_ray(point);
    const auto [i, j] = column_of(at);
    std::vector<int> turns(is_closed_.size(), 0);
    for (std::size_t k = first_[j * columns_ + i]; k < first_[j * columns_ + i + 1]; ++k) {
      const Index f = in_column_[k], piece = piece_[f];
      if (!is_closed_[piece] || std::find(own.begin(), own.end(), piece) != own.end()) continue;
      turns[piece] += crossing(f, at, point[2]);
    }
    for (Index piece = 0; piece < turns.size(); ++piece)
      if (turns[piece] != 0) inside.push_back(piece);
    return inside;
  }
  /// 1 where the ray from height z leaves through face f, -1 where it enters, 0 if it misses; of a quadrilateral, the
  /// sum over two triangles.
  int crossing(Index f, const Plane& at, double z) const {
    const auto& c = target_.faces()[f];
    int sum = 0;
    for (unsigned half = 0; half + 2 < target_.count(f); ++half) {
      const Eigen::Vector3d X[] = {x_[c[0]], x_[c[half + 1]], x_[c[half + 2]]};
      Plane P[3];
      for (int k = 0; k < 3; ++k) P[k] = across_ray(X[k]);
      double area[3], whole = 0;
      for (int k = 0; k < 3; ++k) {
        const Plane &p = P[(k + 1) % 3], &q = P[(k + 2) % 3];
        area[k] = (p[0] - at[0]) * (q[1] - at[1]) - (p[1] - at[1]) * (q[0] - at[0]);
        whole += area[k];
      }
      const bool all_left = area[0] >= 0 && area[1] >= 0 && area[2] >= 0 && whole > 0;
      const bool all_right = area[0] <= 0 && area[1] <= 0 && area[2] <= 0 && whole < 0;
      if (!all_left && !all_right) continue;
      const double height = (area[0] * X[0][2] + area[1] * X[1][2] + area[2] * X[2][2]) / whole;
      if (height > z) sum += all_left ? 1 : -1;
    }
    return sum;
  }

  static constexpr double a = 0.0314159265, b = 0.0271828183;

  const Target& target_;
  std::span<const Eigen::Vector3d> x_;
  std::vector<Index> piece_;  // of each face
  std::vector<bool> is_closed_;
  std::vector<Box> boxes_;
  Box all_;
  std::size_t columns_ = 1;
  std::vector<std::size_t> first_;
  std::vector<Index> in_column_;
};

}  // namespace strike::detail
