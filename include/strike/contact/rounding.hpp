#pragma once
#include <algorithm>
#include <utility>
#include <vector>

#include <strike/ascending.hpp>
#include <strike/mesh/mesh.hpp>

namespace strike::detail {

/// Nodes whose touch ends at an edge, past which they may go on to touch another face, or their edge another edge. They
/// are a little inside then, for no touch is exact: so they may begin there in this step and in the next.
class Rounding {
 public:
  void add(Index node) { now_.push_back(node); }
  bool has(Index node) const {
    return !is_empty() && (contains(now_, node) || std::binary_search(before_.begin(), before_.end(), node));
  }
  bool is_empty() const { return now_.empty() && before_.empty(); }
  void end_step() { before_ = ascending(std::move(now_)), now_.clear(); }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(before_);
  }

 private:
  static bool contains(const std::vector<Index>& some, Index node) {
    return std::find(some.begin(), some.end(), node) != some.end();
  }

  std::vector<Index> now_, before_;
};

}  // namespace strike::detail
