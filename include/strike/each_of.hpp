#pragma once
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

#include <strike/cxx20.hpp>

namespace strike::detail {

/// f(member) of every member of a tuple, in their order; fewer functions to instantiate than with std::apply.
template <class Tuple, class F>
constexpr void each_of(Tuple&& tuple, const F& f) {
  [&]<std::size_t... i>(std::index_sequence<i...>) {
    (f(std::get<i>(tuple)), ...);
  }(std::make_index_sequence<std::tuple_size_v<std::remove_cvref_t<Tuple>>>{});
}

}  // namespace strike::detail
