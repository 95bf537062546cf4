#pragma once
#include <cmath>
#include <limits>

#include <strike/range.hpp>

namespace strike {

/// Options of the driver.
struct ExplicitOptions {
  double step_factor = 0.9;   ///< of the stable step; above 1 only with a largest_step, which then must be stable
  double step_growth = 1.05;  ///< largest ratio of a step to the one before
  double largest_step = std::numeric_limits<double>::infinity();  ///< [time]
  double smallest_step = 0;        ///< the run is given up below it; 0: below a millionth of the first [time]
  double energy_tolerance = 0.05;  ///< the run is given up if the balance is off by more
  bool print_warnings = true;      ///< on stderr, when the run starts

  void ranges(const auto& number) const {
    const double most = std::isfinite(largest_step) ? std::numeric_limits<double>::max() : 1;
    number("step_factor", step_factor, Range{.low = 0, .high = most, .without_high = false});
    number("step_growth", step_growth, range::at_least(1));
    number("largest_step", largest_step, range::or_infinite(range::positive));
    number("smallest_step", smallest_step, range::not_negative);
    number("energy_tolerance", energy_tolerance, range::or_infinite(range::positive));
  }
};

}  // namespace strike
