#pragma once
#include <cstddef>
#include <vector>

#include <strike/cxx20.hpp>

namespace strike::detail {

/// Values by the numbers of nodes, most of which have the same one: stretches of numbers that all have it take no
/// memory.
template <class T>
class ByNumber {
 public:
  explicit ByNumber(const T& usual) : usual_(usual) {}

  const T& operator[](std::size_t i) const {
    const std::size_t k = i / stretch;
    return k < values_.size() && !values_[k].empty() ? values_[k][i % stretch] : usual_;
  }
  T& at(std::size_t i) {
    const std::size_t k = i / stretch;
    if (k >= values_.size()) values_.resize(k + 1);
    if (values_[k].empty()) values_[k].assign(stretch, usual_);
    return values_[k][i % stretch];
  }

 private:
  static constexpr std::size_t stretch = 256;

  T usual_;
  std::vector<std::vector<T>> values_;
};

}  // namespace strike::detail
