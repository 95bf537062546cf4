#pragma once
#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include <strike/contact/closest_point.hpp>
#include <strike/contact/target.hpp>
#include <strike/mesh/mesh.hpp>

namespace strike::detail {

/// The faces of plates that a node never touches in a contact of a surface with itself: those that hang together with
/// it within a thickness at the start. Plates that are only near, of another body or beyond a fold, are not among them.
class Neighbourhood {
 public:
  /// Of every node of the target, from the positions at the start.
  void find(const Target& target, std::span<const Eigen::Vector3d> start) {
    first_.assign(start.size() + 1, 0), faces_.clear();
    std::vector<Index> chain, seen;
    for (std::size_t i = 0; i < start.size(); ++i) {
      const auto node = static_cast<Index>(i);
      const auto is_within_thickness = [&](Index face) {
        const ClosestPoint point = target.closest(face, target.corners(face, start), start[i]);
        const double depth = target.half(node) + target.half(face, point.N);
        return point.distance2 < 1.02 * depth * depth;
      };
      chain.assign(target.at(node).begin(), target.at(node).end());
      seen = chain;
      for (std::size_t k = 0; k < chain.size(); ++k)
        for (unsigned c = 0; c < target.count(chain[k]); ++c)
          for (const Index other : target.at(target.faces()[chain[k]][c])) {
            if (std::find(seen.begin(), seen.end(), other) != seen.end()) continue;
            seen.push_back(other);
            if (is_within_thickness(other)) chain.push_back(other);
          }
      faces_.insert(faces_.end(), chain.begin(), chain.end());
      first_[i + 1] = faces_.size();
    }
  }
  bool has(Index node, Index face) const {
    return std::find(faces_.begin() + at(node), faces_.begin() + at(node + 1), face) != faces_.begin() + at(node + 1);
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(first_, faces_);
  }

 private:
  std::ptrdiff_t at(std::size_t node) const { return static_cast<std::ptrdiff_t>(first_[node]); }

  std::vector<std::size_t> first_;
  std::vector<Index> faces_;
};

}  // namespace strike::detail
