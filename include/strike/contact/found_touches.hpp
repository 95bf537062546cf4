#pragma once
#include <algorithm>
#include <cstddef>
#include <numeric>
#include <optional>
#include <vector>

#include <strike/contact/contact_nodes.hpp>
#include <strike/contact/touch.hpp>
#include <strike/mesh/mesh.hpp>
#include <strike/motion/ranks.hpp>

namespace strike::detail {

/// The touches of some nodes of a contact in a step, in the order of the nodes.
struct FoundTouches {
  /// A node of the contact that is deeper than it may be [length].
  struct TooDeep {
    Index node;
    double depth, most;
  };
  std::vector<Touch> touches;
  std::vector<ContactPair> pairs;   // of the touches
  std::vector<Index> gone_past;     // an edge, nodes of the contact
  std::optional<TooDeep> too_deep;  // the first; its error waits for the end of the loop, which must not throw

  void clear() { touches.clear(), pairs.clear(), gone_past.clear(), too_deep.reset(); }
};

/// The touches of the nodes of all processes, each of which has found those of its own in chunks.
template <class Ranks>
FoundTouches of_all(const Ranks& ranks, const std::vector<FoundTouches>& chunks) {
  FoundTouches mine;
  const auto append = [](auto& all, const auto& more) { all.insert(all.end(), more.begin(), more.end()); };
  for (const FoundTouches& found : chunks) {
    append(mine.touches, found.touches), append(mine.pairs, found.pairs), append(mine.gone_past, found.gone_past);
    if (!mine.too_deep) mine.too_deep = found.too_deep;
  }
  FoundTouches all;
  all.gone_past = lists_of_all_ranks(ranks, mine.gone_past);
  for (const auto& deep : of_all_ranks(ranks, mine.too_deep))
    if (deep && (!all.too_deep || deep->node < all.too_deep->node)) all.too_deep = deep;
  const auto touches = lists_of_all_ranks(ranks, mine.touches);
  const auto pairs = lists_of_all_ranks(ranks, mine.pairs);
  std::vector<std::size_t> order(touches.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return touches[a].node < touches[b].node; });
  for (const std::size_t k : order) all.touches.push_back(touches[k]), all.pairs.push_back(pairs[k]);
  return all;
}

}  // namespace strike::detail
