#pragma once
#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include <strike/ascending.hpp>
#include <strike/dynamics/deal.hpp>
#include <strike/dynamics/patches.hpp>
#include <strike/motion/execution.hpp>
#include <strike/motion/ranks.hpp>

namespace strike::detail {

/// The nodes as the processes of a run share them: each moves its own, those that items name, which all move, and
/// copies of others that its elements name. It is told only what of them it does not find out itself; the rest of the
/// nodes it has not.
class NodeShare {
 public:
  /// Of nodes at `size` places: those of rank r end about where the nodes end that patches of ranks up to r are the
  /// first to name, in whole chunks. `named` are the places that items name, in ascending order.
  NodeShare(std::size_t size, const std::vector<std::size_t>& first_named, std::vector<Index> named, std::size_t rank)
      : rank_(rank), named_(std::move(named)), is_named_(size), needed_(first_named.size()) {
    for (const std::size_t end : first_named) ends_.push_back(std::min((end + chunk / 2) / chunk * chunk, size));
    ends_.back() = size;
    for (const Index place : named_) is_named_[place] = true;
    for (const std::size_t end : ends_)
      named_ends_.push_back(
          static_cast<std::size_t>(std::lower_bound(named_.begin(), named_.end(), end) - named_.begin()));
    for (const std::size_t end : ends_) chunk_ends_.push_back(chunks(end));
  }
  std::size_t owner(std::size_t place) const {
    return static_cast<std::size_t>(std::upper_bound(ends_.begin(), ends_.end(), place) - ends_.begin());
  }
  Places own() const { return {rank_ > 0 ? ends_[rank_ - 1] : 0, ends_[rank_]}; }

  /// The elements of a rank need what moves at a place.
  void need(std::size_t rank, Index place) {
    if (owner(place) != rank && !is_named_[place]) needed_[rank].push_back(place);
  }
  /// When all needs are known.
  void finish() {
    lent_.clear(ends_.size());
    for (auto& places : needed_) places = ascending(std::move(places));
    for (std::size_t r = 0; r < ends_.size(); ++r) {
      for (const Index place : needed_[r])
        if (owner(place) == rank_) lent_.to[r].push_back(place);
      for (const Index place : needed_[rank_])
        if (owner(place) == r) lent_.from[r].push_back(place);
    }
    const auto [first, last] = own();
    std::vector<Index> named_of_others;
    for (const Index place : named_)
      if (place < first || place >= last) named_of_others.push_back(place);
    others_ = runs(ascending(needed_[rank_], named_of_others));
    named_of_others_ = runs(named_of_others);
    needed_.clear();
  }

  /// Velocities of own nodes to the processes that have copies, and those of copies.
  const PlaceLists& lent() const { return lent_; }
  /// Places that this process moves beside its own, and of these the named ones.
  const std::vector<Places>& others() const { return others_; }
  const std::vector<Places>& named_of_others() const { return named_of_others_; }

  /// The chunks of places up to those of each process.
  const std::vector<std::size_t>& chunk_ends() const { return chunk_ends_; }
  /// Whether the process knows what moves at each place.
  std::vector<char> known() const {
    std::vector<char> known(ends_.back());
    const auto mark = [&](const Places& places) {
      std::fill(known.begin() + std::ptrdiff_t(places.first), known.begin() + std::ptrdiff_t(places.last), true);
    };
    mark(own());
    for (const Places& places : others_) mark(places);
    return known;
  }

  /// Gives all processes what each has of its own nodes, ...
  template <class Ranks, class T>
  void exchange(const Ranks& ranks, std::vector<T>& field) const {
    ranks.exchange(std::span(field).first(ends_.back()), std::span<const std::size_t>(ends_));
  }
  /// ... chunk by chunk of the nodes, ...
  template <class Ranks>
  void exchange_chunks(const Ranks& ranks, std::vector<double>& list) const {
    ranks.exchange(std::span(list), std::span<const std::size_t>(chunk_ends_));
  }
  /// ... and at the nodes that items name.
  template <class Ranks, class T>
  void exchange_named(const Ranks& ranks, std::vector<T>& field) const {
    std::vector<T> packed(named_.size());
    for (std::size_t k = own_named().first; k < own_named().last; ++k) packed[k] = field[named_[k]];
    ranks.exchange(std::span(packed), std::span<const std::size_t>(named_ends_));
    for (std::size_t k = 0; k < named_.size(); ++k) field[named_[k]] = packed[k];
  }

 private:
  Places own_named() const { return {rank_ > 0 ? named_ends_[rank_ - 1] : 0, named_ends_[rank_]}; }
  static std::vector<Places> runs(const std::vector<Index>& places) {
    std::vector<Places> runs;
    for (const Index place : places) {
      if (!runs.empty() && runs.back().last == place)
        ++runs.back().last;
      else
        runs.push_back({place, place + std::size_t{1}});
    }
    return runs;
  }

  std::size_t rank_ = 0;
  std::vector<std::size_t> ends_, chunk_ends_, named_ends_;  // of what each process owns
  std::vector<Index> named_;
  std::vector<bool> is_named_;
  std::vector<std::vector<Index>> needed_;  // by each process, until all is known
  PlaceLists lent_;
  std::vector<Places> others_, named_of_others_;
};

}  // namespace strike::detail
