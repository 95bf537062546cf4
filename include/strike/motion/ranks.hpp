#pragma once
#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <strike/mesh/mesh.hpp>

namespace strike {

// The processes of a run, of which each works on a share of the elements; see strike/mpi.
//
// Requirements.
//  1. rank(), size()          the number of this process, from 0, and how many there are
//  2. exchange(list, ends)    gives each process what all have in their ranges of a list that all of them hold: that of
//                             rank r ends at ends[r] and begins where that of the rank before ends
//  3. trade(lists, field, ...) sends the numbers at places of fields to some processes, and takes others from them
//  4. start_trade(...)        the same, on its way while others work: finish() of what it returns has taken them
// Law. All processes call them in the same order.

namespace detail {

/// A range of places, [first, last).
struct Places {
  std::size_t first = 0, last = 0;
};

/// Places of a field by process: whose numbers are sent to each, and come from it.
struct PlaceLists {
  std::vector<std::vector<Index>> to, from;

  void clear(std::size_t ranks) { to.assign(ranks, {}), from.assign(ranks, {}); }
};

}  // namespace detail

/// A process alone, the default.
struct Alone {
  static constexpr std::size_t rank() { return 0; }
  static constexpr std::size_t size() { return 1; }
  template <class T>
  static void exchange(std::span<T>, std::span<const std::size_t>) {}
  static void trade(const auto&...) {}
  struct Traded {
    void finish() const {}
  };
  static Traded start_trade(const auto&...) { return {}; }
};

namespace detail {

/// The processes over which an execution spreads a run.
template <class Execution>
auto ranks_of(const Execution& execution) {
  if constexpr (requires { execution.ranks(); })
    return execution.ranks();
  else
    return Alone{};
}

/// Things that follow each other in space, dealt to the processes in turns of eight: each has some of every place.
struct Turns {
  std::size_t rank = 0, ranks = 1;

  Turns() = default;
  template <class Ranks>
  explicit Turns(const Ranks& all) : rank(all.rank()), ranks(all.size()) {}
  bool has(std::size_t k) const { return ranks == 1 || k / 8 % ranks == rank; }
};

/// The number of each process, by rank.
template <class Ranks, class T>
std::vector<T> of_all_ranks(const Ranks& ranks, const T& mine) {
  std::vector<T> all(ranks.size(), mine);
  std::vector<std::size_t> ends(ranks.size());
  std::iota(ends.begin(), ends.end(), std::size_t{1});
  ranks.exchange(std::span(all), std::span<const std::size_t>(ends));
  return all;
}
/// Their lists, one after the other.
template <class Ranks, class T>
std::vector<T> lists_of_all_ranks(const Ranks& ranks, const std::vector<T>& mine) {
  std::vector<std::size_t> ends = of_all_ranks(ranks, mine.size());
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  std::vector<T> all(ends.back());
  std::copy(mine.begin(), mine.end(), all.begin() + static_cast<std::ptrdiff_t>(ends[ranks.rank()] - mine.size()));
  ranks.exchange(std::span(all), std::span<const std::size_t>(ends));
  return all;
}
template <class Ranks>
double largest_of_ranks(const Ranks& ranks, double mine) {
  const std::vector<double> all = of_all_ranks(ranks, mine);
  return *std::max_element(all.begin(), all.end());
}
template <class Ranks>
double least_of_ranks(const Ranks& ranks, double mine) {
  return -largest_of_ranks(ranks, -mine);
}
/// The number in each list that any process has marked.
template <class Ranks>
void mark_for_all_ranks(const Ranks& ranks, std::vector<char>& marks) {
  if (ranks.size() == 1) return;
  const std::size_t n = marks.size();
  std::vector<char> all(n * ranks.size());
  std::copy(marks.begin(), marks.end(), all.begin() + static_cast<std::ptrdiff_t>(n * ranks.rank()));
  std::vector<std::size_t> ends(ranks.size());
  for (std::size_t r = 0; r < ranks.size(); ++r) ends[r] = n * (r + 1);
  ranks.exchange(std::span(all), std::span<const std::size_t>(ends));
  for (std::size_t k = 0; k < all.size(); ++k)
    if (all[k]) marks[k % n] = true;
}
/// The bytes of one process, for all.
template <class Ranks>
std::string of_rank(const Ranks& ranks, std::size_t rank, std::string bytes) {
  if (ranks.size() == 1) return bytes;
  bytes.resize(of_all_ranks(ranks, bytes.size())[rank]);
  std::vector<std::size_t> ends(ranks.size(), bytes.size());
  std::fill_n(ends.begin(), rank, 0);
  ranks.exchange(std::span(bytes), std::span<const std::size_t>(ends));
  return bytes;
}
/// The text of the first process that has one; empty: none has.
template <class Ranks>
std::string first_of_ranks(const Ranks& ranks, std::string mine) {
  if (ranks.size() == 1) return mine;
  const std::vector<char> have = of_all_ranks(ranks, static_cast<char>(!mine.empty()));
  const auto first = std::find(have.begin(), have.end(), true);
  return first == have.end() ? std::string{} : of_rank(ranks, static_cast<std::size_t>(first - have.begin()), mine);
}

}  // namespace detail

}  // namespace strike
