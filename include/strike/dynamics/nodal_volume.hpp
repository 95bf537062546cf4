#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

#include <strike/dynamics/patches.hpp>
#include <strike/motion/gather.hpp>

namespace strike::detail {

/// The relative volume J_a = sum V/sum V0 of the elements of a part at its nodes, place by place; if the part may lose
/// elements, of those that are left.
template <class Real, bool loses_elements>
class NodalVolume {
 public:
  NodalVolume() = default;
  explicit NodalVolume(Index places) : reference_(places), volume_(places), ratio_(places, Real(1)) {}

  void clear() {
    std::fill(volume_.begin(), volume_.end(), Real(0));
    if constexpr (loses_elements) std::fill(reference_.begin(), reference_.end(), Real(0));
  }
  /// Adds those of the first `count` elements of a block to their nodes.
  template <class T, std::size_t n>
  void add(const T& volume, const BlockNodes<n, lanes<T>>& nodes, std::size_t count) {
    add<T, n>(volume, volume_, nodes, count);
  }
  template <class T, std::size_t n>
  void add(const T& volume, const T& reference, const BlockNodes<n, lanes<T>>& nodes, std::size_t count) {
    add<T, n>(volume, volume_, nodes, count);
    add<T, n>(reference, reference_, nodes, count);
  }
  /// f(field) for what patches have added, ...
  template <class F>
  void each_sum(const F& f) {
    f(volume_);
    if constexpr (loses_elements) f(reference_);
  }
  /// ... and f(field, its value where no element adds) for all, of which the first two are remembered.
  template <class F>
  void each_remembered(const F& f) {
    f(reference_, Real(0)), f(ratio_, Real(1));
  }
  template <class F>
  void each_field(const F& f) {
    each_remembered(f), f(volume_, Real(0));
  }
  std::vector<Real>& sum() { return volume_; }
  std::vector<Real>& reference() { return reference_; }
  /// Gives all processes what the patches of each have added.
  template <class Deal, class Ranks>
  void exchange(const Deal& deal, const Ranks& ranks) {
    each_sum([&](std::vector<Real>& field) { deal.exchange_nodes(ranks, field), deal.exchange_ghosts(ranks, field); });
  }
  /// Adds up what patches have of a node, patch after patch, as the reference.
  void begin(const Patches& patches) {
    patches.gather(volume_);
    reference_ = volume_;
  }
  /// The same as the present volumes, of which every patch learns the ratios, ...
  void update(const Patches& patches) {
    update(patches, {0, patches.size()}, [](const auto&) {});
  }
  /// ... or those in a range, when `tell(ratio)` has brought those of other processes.
  template <class Tell>
  void update(const Patches& patches, const Places& own, const Tell& tell) {
    each_sum([&](std::vector<Real>& field) { patches.gather(field); });
    for (std::size_t i = 0; i < ratio_.size(); ++i)
      if (reference_[i] > 0) ratio_[i] = volume_[i] / reference_[i];
    tell(ratio_);
    for (std::size_t p = own.first; p < own.last; ++p) patches.refresh(patches[p], ratio_);
  }
  /// The mean of J_a over the nodes of the elements of a block.
  template <class T, std::size_t n>
  T mean(const BlockNodes<n, lanes<T>>& nodes) const {
    T sum = T(0.0);
    for (const auto& corner : nodes)
      for (std::size_t l = 0; l < lanes<T>; ++l) set_lane(sum, l, lane(sum, l) + ratio_[corner[l]]);
    return T(1.0 / static_cast<double>(n)) * sum;
  }

 private:
  template <class T, std::size_t n>
  static void add(const T& change, std::vector<Real>& field, const BlockNodes<n, lanes<T>>& nodes, std::size_t count) {
    for (const auto& corner : nodes)
      for (std::size_t l = 0; l < count; ++l) field[corner[l]] += lane(change, l);
  }

  std::vector<Real> reference_, volume_, ratio_;
};

}  // namespace strike::detail
