#pragma once
#include <cstddef>
#include <utility>

#include <strike/cxx20.hpp>

namespace strike::detail {

/// A value of a Slots, told apart by its place.
template <std::size_t i, class A>
struct Slot {
  [[no_unique_address]] A value{};
};
template <class Indices, class... A>
struct Slots;
template <std::size_t... i, class... A>
struct Slots<std::index_sequence<i...>, A...> : Slot<i, A>... {};

/// Values of different types: a tuple that is copied as plain memory.
template <class... A>
using List = Slots<std::index_sequence_for<A...>, A...>;

template <std::size_t i, class A>
A& get(Slot<i, A>& slot) {
  return slot.value;
}
template <std::size_t i, class A>
const A& get(const Slot<i, A>& slot) {
  return slot.value;
}

}  // namespace strike::detail
