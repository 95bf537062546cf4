#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <strike/mesh/mesh.hpp>
#include <strike/motion/execution.hpp>
#include <strike/scalar/pack.hpp>
#include <strike/scalar/scalar.hpp>
#include <strike/tensor/tensor.hpp>

namespace strike::detail {

/// A box with its faces along the axes.
struct Box {
  Eigen::Array3d low = Eigen::Array3d::Constant(std::numeric_limits<double>::infinity()), high = -low;

  void add(const Box& more) { low = low.min(more.low), high = high.max(more.high); }
  void add(const Eigen::Vector3d& x) { low = low.min(x.array()), high = high.max(x.array()); }
  void add_finite(const Eigen::Vector3d& x) {
    if (x.allFinite()) add(x);
  }
  bool is_empty() const { return !(low <= high).all(); }
  /// The square of its diagonal.
  double squared_size() const { return (high - low).square().sum(); }
  /// The square of the gap between two boxes.
  double squared_gap(const Box& other) const {
    return (low - other.high).max(other.low - high).max(0.0).square().sum();
  }
};

/// The points near each group of `width` points, in ascending order: found in a tree of boxes over the points as they
/// lie in memory, neighbours together, eight to a box. Takes time proportional to the number of points and of those
/// found; points that have mixed take longer, and none is missed. Points at infinity are near to none.
template <std::size_t width>
class Neighbours {
 public:
  /// Finds for the groups of the first `count` points which of all lie within `reach` of one of the group.
  template <class Execution>
  void find(std::span<const Eigen::Vector3d> x, std::size_t count, double reach, const Execution& execution) {
    boxes_ = boxes_around(x, execution);
    lists_.resize((count + width - 1) / width);
    for_each_chunk(execution, lists_.size(), [&](std::size_t, std::size_t first, std::size_t last) {
      for (std::size_t b = first; b < last; ++b) find(x, b, std::min((b + 1) * width, count), reach * reach);
    });
  }
  const std::vector<Index>& of(std::size_t group) const { return lists_[group]; }
  /// Lists that were found with a reach larger by the skin hold all that are within reach, now that the points have
  /// gone these ways; those at infinity are not asked for. Points that go together, wherever they go, stay as far
  /// apart.
  template <class Execution>
  bool hold(std::span<const Eigen::Vector3d> ways, double reach, double skin, const Execution& execution) const {
    const Boxes around_ways = boxes_around(ways, execution);
    return boxes_.empty() || stay(boxes_.size() - 1, 0, 0, around_ways, reach, skin);
  }

 private:
  static constexpr std::size_t arity = 8;
  using Boxes = std::vector<std::vector<Box>>;  // of a tree over the points, from these up

  template <class Execution>
  static Boxes boxes_around(std::span<const Eigen::Vector3d> x, const Execution& execution) {
    Boxes boxes(1, std::vector<Box>((x.size() + arity - 1) / arity));
    for_each_chunk(execution, boxes[0].size(), [&](std::size_t, std::size_t first, std::size_t last) {
      for (std::size_t j = first * arity; j < std::min(last * arity, x.size()); ++j)
        boxes[0][j / arity].add_finite(x[j]);
    });
    while (boxes.back().size() > 1) {
      const std::vector<Box>& below = boxes.back();
      std::vector<Box> level((below.size() + arity - 1) / arity);
      for (std::size_t k = 0; k < below.size(); ++k) level[k / arity].add(below[k]);
      boxes.push_back(std::move(level));
    }
    return boxes;
  }
  /// No point of box a has come into the reach of one of box b, unless it is in its list.
  bool stay(std::size_t level, std::size_t a, std::size_t b, const Boxes& ways, double reach, double skin) const {
    Box of_both = ways[level][a];
    of_both.add(ways[level][b]);
    if (of_both.is_empty() || of_both.squared_size() < skin * skin) return true;
    const double farthest = reach + std::sqrt(of_both.squared_size());
    if (boxes_[level][a].squared_gap(boxes_[level][b]) > farthest * farthest) return true;
    if (level <= 1) return false;  // of 64 points
    const auto end = [&](std::size_t k) { return std::min((k + 1) * arity, boxes_[level - 1].size()); };
    for (std::size_t i = a * arity; i < end(a); ++i)
      for (std::size_t j = a == b ? i : b * arity; j < end(b); ++j)
        if (!stay(level - 1, i, j, ways, reach, skin)) return false;
    return true;
  }
  void find(std::span<const Eigen::Vector3d> x, std::size_t group, std::size_t last, double squared_reach) {
    Box box;
    Group points;
    for (std::size_t l = 0; l < width; ++l) {
      const Eigen::Vector3d& at = x[std::min(group * width + l, last - 1)];
      box.add_finite(at);
      for (int c = 0; c < 3; ++c) set_lane(points(c), l, at(c));
    }
    lists_[group].clear();
    visit(boxes_.size() - 1, 0, 1, x, box, points, squared_reach, lists_[group]);
  }
  using Lanes = Pack<double, width>;
  using Group = Vector3<Lanes>;

  /// Boxes [first, last) of a level, in order.
  void visit(std::size_t level, std::size_t first, std::size_t last, std::span<const Eigen::Vector3d> x, const Box& box,
             const Group& points, double squared_reach, std::vector<Index>& found) const {
    for (std::size_t k = first; k < last; ++k) {
      if (!(box.squared_gap(boxes_[level][k]) <= squared_reach)) continue;
      if (level > 0) {
        visit(level - 1, k * arity, std::min((k + 1) * arity, boxes_[level - 1].size()), x, box, points, squared_reach,
              found);
        continue;
      }
      for (std::size_t j = k * arity; j < std::min((k + 1) * arity, x.size()); ++j) {
        const Group d = points - Group(Lanes(x[j](0)), Lanes(x[j](1)), Lanes(x[j](2)));
        if (any(dot(d, d) <= Lanes(squared_reach))) found.push_back(static_cast<Index>(j));
      }
    }
  }

  Boxes boxes_;
  std::vector<std::vector<Index>> lists_;
};

}  // namespace strike::detail
