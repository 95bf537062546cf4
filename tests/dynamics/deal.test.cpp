#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <vector>

#include <strike/dynamics/deal.hpp>
#include <strike/motion/node_share.hpp>

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
  const auto among_all = [&](std::size_t rank, const std::vector<Index>& here) {
    std::vector<Index> places;
    for (const Index i : here) places.push_back(shares[rank].among_all(i));
    return places;
  };
  std::size_t next = 0;
  for (std::size_t r = 0; r < ranks; ++r) {
    const NodeShare& share = shares[r];
    const auto [first, last] = share.own_among_all();
    CHECK(first == next);
    CHECK((last % detail::chunk == 0 || last == nodes));
    next = last;
    std::set<Index> moved;
    for (std::size_t i = share.own().first; i < share.own().last; ++i) moved.insert(share.among_all(i));
    CHECK(*moved.begin() == first);
    CHECK(*moved.rbegin() + 1 == last);
    CHECK(moved.size() == last - first);
    for (const auto& run : share.others())
      for (std::size_t i = run.first; i < run.last; ++i) CHECK(moved.insert(share.among_all(i)).second);
    for (const Index i : named) CHECK(moved.count(i) == 1);
    for (Index i = static_cast<Index>(r); i < nodes; i += 97) CHECK(moved.count(i) == 1);
    CHECK(moved.size() == share.size());
    std::size_t next_here = 0;
    share.each_kept([&](std::size_t place, std::size_t here) {
      CHECK(here == next_here++);
      CHECK(moved.count(static_cast<Index>(place)) == 1);
      CHECK(share.here(place) == here);
      CHECK(share.among_all(here) == place);
    });
    CHECK(next_here == share.size());
    for (std::size_t s = 0; s < ranks; ++s) {
      const std::vector<Index> lent = among_all(r, share.lent().to[s]);
      CHECK(lent == among_all(s, shares[s].lent().from[r]));
      for (const Index i : lent) CHECK(share.owner(i) == r);
    }
    CHECK(share.lent().to[r].empty());
  }
  CHECK(next == nodes);
}

TEST_CASE("node share: a process without nodes of its own keeps one, which the owner lends it") {
  for (std::size_t r = 0; r < 3; ++r) {
    NodeShare share(10, {10, 10, 10}, {}, r);
    share.finish();
    CHECK(share.size() == (r == 2 ? 10 : 1));  // less than a chunk goes to the last
    CHECK(share.own().last - share.own().first == (r == 2 ? 10 : 0));
    CHECK(share.among_all(0) == 0);
  }
}
