#pragma once
#include <strike/cxx20.hpp>

namespace strike::detail {

/// The first of the policies that `Is`, else the last, which is the usual one.
template <template <class> class Is, class Policy, class... Rest>
constexpr auto pick(const Policy& policy, const Rest&... rest) {
  if constexpr (sizeof...(Rest) == 0 || Is<Policy>::value)
    return policy;
  else
    return pick<Is>(rest...);
}

}  // namespace strike::detail
