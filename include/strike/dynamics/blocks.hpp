#pragma once
#include <cstddef>
#include <vector>

#include <strike/cxx20.hpp>

namespace strike::detail {

/// The blocks of a part, by their numbers among all; those that other processes work on need not be kept.
template <class Block>
class Blocks {
 public:
  /// Number of blocks of the part.
  std::size_t size() const { return size_; }
  Block& operator[](std::size_t b) { return kept_[b - first_]; }
  const Block& operator[](std::size_t b) const { return kept_[b - first_]; }

  /// The numbers [first, last) of those that are kept.
  std::size_t first() const { return first_; }
  std::size_t last() const { return first_ + kept_.size(); }
  auto begin() { return kept_.begin(); }
  auto begin() const { return kept_.begin(); }
  auto end() { return kept_.end(); }
  auto end() const { return kept_.end(); }

  void resize(std::size_t size) { kept_.resize(size), size_ = size; }
  /// Keeps the blocks [first, last) alone, or if there are none the first one.
  void keep(std::size_t first, std::size_t last) {
    if (first == last) first = 0, last = 1;
    const auto at = [&](std::size_t b) { return kept_.begin() + static_cast<std::ptrdiff_t>(b - first_); };
    kept_ = std::vector<Block>(at(first), at(last));
    first_ = first;
  }

 private:
  std::size_t size_ = 0, first_ = 0;
  std::vector<Block> kept_;
};

}  // namespace strike::detail
