#pragma once
#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include <strike/ascending.hpp>
#include <strike/motion/execution.hpp>
#include <strike/motion/ranks.hpp>

namespace strike::detail {

/// The nodes as the processes of a run share them: each keeps and moves its own, those that items name, which all move,
/// and copies of others that its elements name. Places among all nodes are those of the whole scene; nodes that are
/// kept have places here, in the same order.
class NodeShare {
 public:
  /// Of nodes at `size` places: those of rank r end about where the nodes end that patches of ranks up to r are the
  /// first to name, in whole chunks. `named` are the places that items name, in ascending order.
  NodeShare(std::size_t size, const std::vector<std::size_t>& first_named, std::vector<Index> named, std::size_t rank)
      : rank_(rank), named_(std::move(named)), is_named_(size), needed_(first_named.size()) {
    for (const std::size_t end : first_named) ends_.push_back(std::min((end + chunk / 2) / chunk * chunk, size));
    ends_.back() = size;
    for (const Index place : named_) is_named_[place] = true;
    for (const std::size_t end : ends_) {
      named_ends_.push_back(
          static_cast<std::size_t>(std::lower_bound(named_.begin(), named_.end(), end) - named_.begin()));
      chunk_ends_.push_back(chunks(end));
    }
  }
  std::size_t owner(std::size_t place) const {
    return static_cast<std::size_t>(std::upper_bound(ends_.begin(), ends_.end(), place) - ends_.begin());
  }
  /// The elements of a rank need what moves at a place.
  void need(std::size_t rank, Index place) {
    if (owner(place) != rank && !is_named_[place]) needed_[rank].push_back(place);
  }
  /// When all needs are known.
  void finish() {
    for (std::size_t r = 0; r < ends_.size(); ++r)
      if (own_of(r).first == own_of(r).last && named_.empty() && needed_[r].empty()) needed_[r].push_back(0);
    for (auto& places : needed_) places = ascending(std::move(places));
    const Places own = own_of(rank_);
    std::vector<Index> others = ascending(needed_[rank_], named_);
    std::erase_if(others, [&](Index place) { return place >= own.first && place < own.last; });
    list_kept(others);
    lent_.clear(ends_.size());
    for (std::size_t r = 0; r < ends_.size(); ++r) {
      for (const Index place : needed_[r])
        if (owner(place) == rank_) lent_.to[r].push_back(here(place));
      for (const Index place : needed_[rank_])
        if (owner(place) == r) lent_.from[r].push_back(here(place));
    }
    for (Index& place : named_) place = here(place);
    if (own.first < own.last) own_ = {here(own.first), here(own.last - 1) + std::size_t{1}};
    for (Index& place : others) place = here(place);
    others_ = runs(others);
    std::vector<Index> named_of_others;
    for (const Index place : named_)
      if (place < own_.first || place >= own_.last) named_of_others.push_back(place);
    named_of_others_ = runs(named_of_others);
    needed_.clear(), is_named_.clear();
  }

  /// Number of the nodes that are kept.
  std::size_t size() const { return kept_.back().here; }
  /// The place here of a node that is kept, by its place among all, ...
  Index here(std::size_t place) const {
    const auto after = std::upper_bound(kept_.begin(), kept_.end() - 1, place,
                                        [](std::size_t at, const Run& run) { return at < run.first; });
    return static_cast<Index>((after - 1)->here + place - (after - 1)->first);
  }
  /// ... that among all by that here, ...
  Index among_all(std::size_t here) const {
    const auto after = std::upper_bound(kept_.begin(), kept_.end() - 1, here,
                                        [](std::size_t at, const Run& run) { return at < run.here; });
    return static_cast<Index>((after - 1)->first + here - (after - 1)->here);
  }
  /// ... and f(place among all, place here) for each.
  template <class F>
  void each_kept(const F& f) const {
    for (std::size_t k = 0; k + 1 < kept_.size(); ++k)
      for (std::size_t i = kept_[k].here; i < kept_[k + 1].here; ++i) f(kept_[k].first + i - kept_[k].here, i);
  }

  // Places here.
  Places own() const { return own_; }
  /// Velocities of own nodes to the processes that have copies, and those of copies.
  const PlaceLists& lent() const { return lent_; }
  /// Places that this process moves beside its own, and of these the named ones.
  const std::vector<Places>& others() const { return others_; }
  const std::vector<Places>& named_of_others() const { return named_of_others_; }

  /// Of a field at the places of all nodes, those of this process.
  Places own_among_all() const { return own_of(rank_); }
  /// Gives all processes what each has there, ...
  template <class Ranks, class T>
  void exchange(const Ranks& ranks, std::vector<T>& field) const {
    ranks.exchange(std::span(field).first(ends_.back()), std::span<const std::size_t>(ends_));
  }
  /// ... chunk by chunk, of which the first is its own, ...
  std::size_t first_chunk() const { return rank_ > 0 ? chunk_ends_[rank_ - 1] : 0; }
  template <class Ranks, class T>
  void exchange_chunks(const Ranks& ranks, std::vector<T>& list) const {
    ranks.exchange(std::span(list), std::span<const std::size_t>(chunk_ends_));
  }
  /// ... and, of a field at the places here, at the nodes that items name.
  template <class Ranks, class T>
  void exchange_named(const Ranks& ranks, std::vector<T>& field) const {
    std::vector<T> packed(named_.size());
    const std::size_t first = rank_ > 0 ? named_ends_[rank_ - 1] : 0;
    for (std::size_t k = first; k < named_ends_[rank_]; ++k) packed[k] = field[named_[k]];
    ranks.exchange(std::span(packed), std::span<const std::size_t>(named_ends_));
    for (std::size_t k = 0; k < named_.size(); ++k) field[named_[k]] = packed[k];
  }

 private:
  /// Nodes that follow each other among all and here.
  struct Run {
    std::size_t first, here;
  };

  Places own_of(std::size_t rank) const { return {rank > 0 ? ends_[rank - 1] : 0, ends_[rank]}; }
  /// Own nodes and others.
  void list_kept(const std::vector<Index>& others) {
    std::vector<Places> all = runs(others);
    if (const Places own = own_of(rank_); own.first < own.last) all.push_back(own);
    std::sort(all.begin(), all.end(), [](const Places& a, const Places& b) { return a.first < b.first; });
    std::size_t here = 0;
    for (const auto& [first, last] : all) kept_.push_back({first, here}), here += last - first;
    kept_.push_back({ends_.back(), here});
  }
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

  std::size_t rank_;
  std::vector<std::size_t> ends_, chunk_ends_, named_ends_;  // of what each process owns
  std::vector<Index> named_;
  std::vector<bool> is_named_;              // until all is known, ...
  std::vector<std::vector<Index>> needed_;  // ... as what each process needs
  std::vector<Run> kept_;                   // and their end
  Places own_;
  PlaceLists lent_;
  std::vector<Places> others_, named_of_others_;
};

}  // namespace strike::detail
