#pragma once
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

#include <strike/cxx20.hpp>

namespace strike::detail {

/// Member i of a tuple; std::get, which has many forms to choose from, is looked for once for each.
template <std::size_t i, class Tuple>
constexpr auto& member(Tuple& tuple) {
  return std::get<i>(tuple);
}

/// f(member) of every member of a tuple, in their order; fewer functions to instantiate than with std::apply.
template <class Tuple, class F>
constexpr void each_of(Tuple&& tuple, const F& f) {
  [&]<std::size_t... i>(std::index_sequence<i...>) {
    (f(member<i>(tuple)), ...);
  }(std::make_index_sequence<std::tuple_size_v<std::remove_cvref_t<Tuple>>>{});
}

}  // namespace strike::detail
