#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <vector>

#include <strike/dynamics/deal.hpp>
#include <strike/dynamics/node_share.hpp>

#include "support/catch.hpp"

using namespace strike;
using detail::Deal, detail::NodeShare, detail::Patches;

namespace {

/// Some process of several, whose exchanges nobody sees.
struct Rank {
  std::size_t number, count;

  std::size_t rank() const { return number; }
  std::size_t size() const { return count; }
};

/// A chain of bars of two nodes, one in a block.
Patches chain(Index bars) {
  std::vector<Index> corners;
  for (Index i = 0; i < bars; ++i) corners.push_back(i), corners.push_back(i + 1);
  return Patches(corners, bars, 1, 0, bars + 1);
}

}  // namespace

TEST_CASE("deal: every patch goes to one process, in their order, and the shares of elements are even to a patch") {
  const Index bars = 5000;
  const Patches patches = chain(bars);
  for (const std::size_t ranks : {1u, 2u, 3u, 7u, 40u}) {
    std::size_t next = 0, most = 0;
    for (std::size_t r = 0; r < ranks; ++r) {
      const Deal deal(patches, bars, 1, {0, 8, 8 * bars}, Rank{r, ranks});
      CHECK(deal.first() == next);
      next = deal.last();
      std::size_t elements = 0;
      for (std::size_t p = deal.first(); p < deal.last(); ++p)
        elements += patches[p].last_block - patches[p].first_block;
      most = std::max(most, elements);
      CHECK(deal.is_dealt() == (ranks > 1));
    }
    CHECK(next == patches.size());
    CHECK(most <= bars / ranks + patches[0].last_block);
  }
  // of two parts of a scene the first goes to the first of two processes
  CHECK(Deal(patches, bars, 1, {0, 8, 16 * bars}, Rank{0, 2}).size() == patches.size());
  CHECK(Deal(patches, bars, 1, {8 * bars, 8, 16 * bars}, Rank{0, 2}).size() == 0);
  CHECK(Deal(patches, bars, 1, {8 * bars, 8, 16 * bars}, Rank{1, 2}).size() == patches.size());
  // and of heavy elements beside as many light ones the first of two has two thirds
  std::size_t heavy = 0;
  const Deal deal(patches, bars, 1, {0, 24, 32 * bars}, Rank{0, 2});
  for (std::size_t p = 0; p < deal.last(); ++p) heavy += patches[p].last_block - patches[p].first_block;
  CHECK(std::abs(static_cast<double>(heavy) - 2.0 / 3 * bars) <= 0.5 * static_cast<double>(patches[0].last_block));
}

TEST_CASE("node share: of every node that is needed the owner lends it to those that need it, and to no others") {
  const std::size_t nodes = 5000, ranks = 4;
  const std::vector<std::size_t> first_named{1200, 2500, 4000, 5000};
  const std::vector<Index> named{3, 1500, 1501, 4999};
  std::vector<NodeShare> shares;
  for (std::size_t r = 0; r < ranks; ++r) {
    NodeShare share(nodes, first_named, named, r);
    for (std::size_t of = 0; of < ranks; ++of)
      for (Index i = static_cast<Index>(of); i < nodes; i += 97) share.need(of, i);
    share.finish();
    shares.push_back(share);
  }
  std::size_t next = 0;
  for (std::size_t r = 0; r < ranks; ++r) {
    const auto [first, last] = shares[r].own();
    CHECK(first == next);
    CHECK((last % detail::chunk == 0 || last == nodes));
    next = last;
    std::set<Index> moved;
    for (std::size_t i = first; i < last; ++i) moved.insert(static_cast<Index>(i));
    for (const auto& run : shares[r].others())
      for (std::size_t i = run.first; i < run.last; ++i) CHECK(moved.insert(static_cast<Index>(i)).second);
    for (const Index i : named) CHECK(moved.count(i) == 1);
    for (Index i = static_cast<Index>(r); i < nodes; i += 97) CHECK(moved.count(i) == 1);
    const std::vector<char> known = shares[r].known();
    CHECK(static_cast<std::size_t>(std::count(known.begin(), known.end(), true)) == moved.size());
    for (std::size_t s = 0; s < ranks; ++s) {
      CHECK(shares[r].lent().to[s] == shares[s].lent().from[r]);
      for (const Index i : shares[r].lent().to[s]) CHECK(shares[r].owner(i) == r);
    }
    CHECK(shares[r].lent().to[r].empty());
  }
  CHECK(next == nodes);
}
