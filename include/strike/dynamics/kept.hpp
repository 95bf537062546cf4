#pragma once
#include <cstddef>
#include <utility>
#include <vector>

#include <strike/cxx20.hpp>

namespace strike::detail {

/// A list of what a part has, such as its blocks, by their numbers among all; those of other processes need not be
/// kept.
template <class T>
class Kept {
 public:
  Kept() = default;
  explicit Kept(std::vector<T> all) : size_(all.size()), kept_(std::move(all)) {}

  /// Number of all.
  std::size_t size() const { return size_; }
  T& operator[](std::size_t k) { return kept_[k - first_]; }
  const T& operator[](std::size_t k) const { return kept_[k - first_]; }

  /// The numbers [first, last) of those that are kept.
  std::size_t first() const { return first_; }
  std::size_t last() const { return first_ + kept_.size(); }
  auto begin() { return kept_.begin(); }
  auto begin() const { return kept_.begin(); }
  auto end() { return kept_.end(); }
  auto end() const { return kept_.end(); }

  void resize(std::size_t size) { kept_.resize(size), size_ = size; }
  /// Keeps [first, last) alone, or if there are none the first one.
  void keep(std::size_t first, std::size_t last) {
    if (first == last) first = 0, last = 1;
    const auto at = [&](std::size_t k) { return kept_.begin() + static_cast<std::ptrdiff_t>(k - first_); };
    kept_ = std::vector<T>(at(first), at(last));
    first_ = first;
  }

 private:
  std::size_t size_ = 0, first_ = 0;
  std::vector<T> kept_;
};

}  // namespace strike::detail
