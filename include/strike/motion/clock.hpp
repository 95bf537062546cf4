#pragma once
#include <strike/cxx20.hpp>

namespace strike {

/// The time of a run: a sum of steps that carries its rounding error along (Kahan 1965), so that it is right to the
/// last digit after any number of steps.
class Clock {
 public:
  double time() const { return time_; }
  void advance(double dt) {
    const double increment = dt - error_, sum = time_ + increment;
    error_ = (sum - time_) - increment;
    time_ = sum;
  }
  void set(double time) {
    time_ = time;
    error_ = 0;
  }

 private:
  double time_ = 0, error_ = 0;
};

}  // namespace strike
