#pragma once
#include <algorithm>
#include <utility>
#include <vector>

#include <strike/cxx20.hpp>

namespace strike::detail {

/// The values in ascending order, each once.
template <class T>
std::vector<T> ascending(std::vector<T> values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}
/// The values of two lists in ascending order, each once.
template <class T>
std::vector<T> ascending(std::vector<T> values, const std::vector<T>& others) {
  values.insert(values.end(), others.begin(), others.end());
  return ascending(std::move(values));
}

}  // namespace strike::detail
