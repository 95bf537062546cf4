#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <Eigen/Core>

#include <strike/mesh/mesh.hpp>
#include <strike/motion/execution.hpp>

namespace strike::detail {

/// The faces within a reach of each node. Nodes are sorted into buckets of the size of the faces, and each face looks
/// into those that its box, enlarged by the reach, overlaps. Buckets are found by their hash, so that empty ones take
/// no memory. The work is linear in nodes and faces.
class BucketSearch {
 public:
  using Corners = std::array<Index, 4>;

  /// Finds, for `near(s)`, the faces whose box, enlarged by `reach` [length], holds x[nodes[s]]. Returns by how much
  /// the boxes around all nodes and all faces are farther apart than the reach; 0 if they are not. `less(s, f)` is by
  /// how much less a face is enlarged for a node; infinite for those that never meet [length].
  template <Execution E, class Less>
  double sort(std::span<const Index> nodes, std::span<const Corners> faces, std::span<const Eigen::Vector3d> x,
              double reach, const E& execution, const Less& less) {
    begin_.assign(nodes.size() + 1, 0);
    near_.clear(), room_.clear(), awake_.clear();
    Box all_nodes, all_faces;
    for (const Index i : nodes) all_nodes.take(x[i]);
    boxes_.resize(faces.size());
    double size = 0;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      boxes_[f] = {};
      for (const Index i : faces[f]) boxes_[f].take(x[i]);
      size += boxes_[f].longest_edge();
      all_faces.take(boxes_[f].lower), all_faces.take(boxes_[f].upper);
      boxes_[f].grow(reach);
    }
    if (nodes.empty() || faces.empty()) return std::numeric_limits<double>::infinity();
    const double apart = all_nodes.gap_to(all_faces);
    if (apart > reach) return apart - reach;

    all_faces.grow(reach), all_nodes.grow(reach);
    edge_ = std::max(size / static_cast<double>(faces.size()) + 2 * reach, std::numeric_limits<double>::min());
    fill_buckets(nodes, x, all_faces);
    found_.resize(chunks(faces.size()));
    for_each_chunk(execution, faces.size(), [&](std::size_t c, std::size_t first, std::size_t last) {
      found_[c].clear();
      for (std::size_t f = first; f < last; ++f)
        if (all_nodes.overlaps(boxes_[f])) look(static_cast<Index>(f), less, found_[c]);
    });
    const auto each_found = [&](const auto& g) {
      for (const auto& some : found_)
        for (const Found& found : some) g(found);
    };
    each_found([&](const Found& found) { ++begin_[found.node + 1]; });
    for (std::size_t s = 0; s < nodes.size(); ++s) {
      if (begin_[s + 1] > 0) awake_.push_back(static_cast<Index>(s));
      begin_[s + 1] += begin_[s];
    }
    near_.resize(begin_.back()), room_.resize(begin_.back());
    std::vector<std::size_t> end(begin_.begin(), begin_.end() - 1);
    each_found([&](const Found& found) {
      const std::size_t place = end[found.node]++;
      near_[place] = found.face, room_[place] = found.room;
    });
    return 0;
  }

  template <Execution E = Serial>
  double sort(std::span<const Index> nodes, std::span<const Corners> faces, std::span<const Eigen::Vector3d> x,
              double reach, const E& execution = {}) {
    return sort(nodes, faces, x, reach, execution, [](Index, Index) { return 0.0; });
  }

  /// The faces near nodes[s], in ascending order.
  std::span<const Index> near(std::size_t s) const { return {near_.data() + begin_[s], begin_[s + 1] - begin_[s]}; }
  /// The place of the first of them among those of all nodes; their number, and that of the nodes.
  std::size_t first(std::size_t s) const { return begin_[s]; }
  std::size_t size() const { return near_.size(); }
  /// By how much smaller a reach would have found each of those of all nodes, in the sort [length].
  const std::vector<double>& room() const { return room_; }
  std::size_t nodes() const { return begin_.empty() ? 0 : begin_.size() - 1; }
  /// The places in the list of the nodes that have a face near.
  const std::vector<Index>& awake() const { return awake_; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(begin_, near_, awake_);
  }

 private:
  struct Box {
    static constexpr double infinity = std::numeric_limits<double>::infinity();
    Eigen::Vector3d lower{infinity, infinity, infinity}, upper{-infinity, -infinity, -infinity};

    void take(const Eigen::Vector3d& x) {
      for (int c = 0; c < 3; ++c) lower(c) = std::min(lower(c), x(c)), upper(c) = std::max(upper(c), x(c));
    }
    void grow(double reach) {
      for (int c = 0; c < 3; ++c) lower(c) -= reach, upper(c) += reach;
    }
    bool holds(const Eigen::Vector3d& x) const { return reaches(x, x); }
    /// The distance of a point in the box from its sides.
    double depth_of(const Eigen::Vector3d& x) const {
      return std::min(
          {x(0) - lower(0), upper(0) - x(0), x(1) - lower(1), upper(1) - x(1), x(2) - lower(2), upper(2) - x(2)});
    }
    bool overlaps(const Box& other) const { return reaches(other.lower, other.upper); }
    bool reaches(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const {
      return to(0) >= lower(0) && from(0) <= upper(0) && to(1) >= lower(1) && from(1) <= upper(1) &&
             to(2) >= lower(2) && from(2) <= upper(2);
    }
    double longest_edge() const { return std::max({upper(0) - lower(0), upper(1) - lower(1), upper(2) - lower(2)}); }
    /// The widest gap between this box and another along an axis; negative where they overlap along all.
    double gap_to(const Box& other) const {
      double gap = -infinity;
      for (int c = 0; c < 3; ++c) gap = std::max({gap, lower(c) - other.upper(c), other.lower(c) - upper(c)});
      return gap;
    }
  };
  struct Found {
    Index node, face;
    double room;
  };
  using Bucket = std::array<std::int64_t, 3>;
  struct Filed {
    Bucket bucket;
    Eigen::Vector3d x;
    Index node;

    bool is_in(const Bucket& b) const { return bucket[0] == b[0] && bucket[1] == b[1] && bucket[2] == b[2]; }
  };

  Bucket bucket_of(const Eigen::Vector3d& x) const {
    const auto along = [&](double a) {
      return static_cast<std::int64_t>(std::floor(std::clamp(a / edge_, -1e15, 1e15)));
    };
    return {along(x[0]), along(x[1]), along(x[2])};
  }
  std::size_t slot(const Bucket& b) const {  // Teschner et al. 2003, "Optimized spatial hashing", eq. (1)
    return (static_cast<std::uint64_t>(b[0]) * 73856093u ^ static_cast<std::uint64_t>(b[1]) * 19349663u ^
            static_cast<std::uint64_t>(b[2]) * 83492791u) &
           (slots_ - 1);
  }

  void fill_buckets(std::span<const Index> nodes, std::span<const Eigen::Vector3d> x, const Box& region) {
    slots_ = 1;
    while (slots_ < nodes.size()) slots_ *= 2;
    slot_begin_.assign(slots_ + 1, 0);
    filed_.clear();
    for (std::size_t s = 0; s < nodes.size(); ++s)
      if (const Eigen::Vector3d& at = x[nodes[s]]; region.holds(at))
        filed_.push_back({bucket_of(at), at, static_cast<Index>(s)});
    for (const Filed& filed : filed_) ++slot_begin_[slot(filed.bucket) + 1];
    for (std::size_t k = 0; k < slots_; ++k) slot_begin_[k + 1] += slot_begin_[k];
    sorted_.resize(filed_.size());
    slot_end_.assign(slot_begin_.begin(), slot_begin_.end() - 1);
    for (const Filed& filed : filed_) sorted_[slot_end_[slot(filed.bucket)]++] = filed;
  }

  template <class Less>
  void look(Index f, const Less& less, std::vector<Found>& found) const {
    const Box& box = boxes_[f];
    const auto look_at = [&](const Filed& filed) {
      if (!box.holds(filed.x)) return;
      const double depth = box.depth_of(filed.x), least = less(filed.node, f);
      if (depth >= least) found.push_back({filed.node, f, depth - least});
    };
    const Bucket first = bucket_of(box.lower), last = bucket_of(box.upper);
    const double buckets = static_cast<double>(last[0] - first[0] + 1) * static_cast<double>(last[1] - first[1] + 1) *
                           static_cast<double>(last[2] - first[2] + 1);
    if (buckets > static_cast<double>(sorted_.size())) {  // a face much larger than others
      for (const Filed& filed : sorted_) look_at(filed);
      return;
    }
    for (auto k = first[2]; k <= last[2]; ++k)
      for (auto j = first[1]; j <= last[1]; ++j)
        for (auto i = first[0]; i <= last[0]; ++i) {
          const Bucket bucket{i, j, k};
          const std::size_t at = slot(bucket);
          for (std::size_t n = slot_begin_[at]; n < slot_begin_[at + 1]; ++n)
            if (sorted_[n].is_in(bucket)) look_at(sorted_[n]);
        }
  }

  double edge_ = 1;
  std::size_t slots_ = 1;
  std::vector<Box> boxes_;
  std::vector<Filed> filed_, sorted_;
  std::vector<std::vector<Found>> found_;  // by chunks of faces
  std::vector<std::size_t> slot_begin_, slot_end_, begin_;
  std::vector<Index> near_, awake_;
  std::vector<double> room_;
};

}  // namespace strike::detail
