#pragma once
#include <algorithm>
#include <concepts>
#include <cstddef>

#include <strike/scalar/scalar.hpp>

namespace strike::detail {

/// Memory of an element that is followed from one estimate of the mesh's step to the next: its critical rate, and one
/// over that at the estimate; 0: it was not part of it.
template <class T>
struct FollowedRate {
  T now{}, per_estimated{};
};

template <class State>
concept Followed = requires(const State state) { state.followed.per_estimated; };

/// By how much the critical rates of elements have grown since the estimate, the largest ratio and the largest strain
/// of their shape, and the largest rate of those that were not part of it.
template <class T>
struct GrowthOfRates {
  T ratio = T(0.0), strain = T(0.0), others = T(0.0);

  template <class State>
  void add(const State& state) {
    const FollowedRate<T>& rate = state.followed;
    const auto is_estimated = rate.per_estimated > 0.0;
    ratio = max(ratio, T(rate.now * rate.per_estimated));
    strain = max(strain, T(select(is_estimated, state.strain(), T(0.0))));
    others = max(others, T(select(is_estimated, T(0.0), rate.now)));
  }
  GrowthOfRates<double> reduced() const {
    return {static_cast<double>(reduce_max(ratio)), static_cast<double>(reduce_max(strain)),
            static_cast<double>(reduce_max(others))};
  }
};

}  // namespace strike::detail
