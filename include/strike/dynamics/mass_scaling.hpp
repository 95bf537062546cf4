#pragma once
#include <cstddef>
#include <string>

#include <strike/scalar/scalar.hpp>
#include <strike/text.hpp>

namespace strike::detail {

/// The mass that scaled elements of a part have more than their own, for elements whose state has a `mass_factor`.
class ScaledMass {
 public:
  /// An element of the number e: its mass, with what was added, and the factor between the two.
  void add(std::size_t e, double mass, double own, double factor) {
    added_ += mass - own;
    if (factor > largest_) largest_ = factor, element_ = e;
  }
  double added() const { return added_; }

  /// Empty if nothing was added; `mass` is the part's own.
  [[gnu::cold]] std::string warning(std::size_t part, double mass) const {
    if (!(added_ > 0)) return {};
    return joined({"Mass scaling has added ", text(added_), " to part ", std::to_string(part), ", ",
                   text(100 * added_ / mass), " % of its mass; most to element ", std::to_string(element_),
                   ", which has ", text(largest_), " times its own."});
  }

 private:
  double added_ = 0, largest_ = 1;
  std::size_t element_ = 0;
};

}  // namespace strike::detail
