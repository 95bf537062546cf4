#pragma once
#include <cmath>
#include <optional>
#include <string>

#include <strike/error.hpp>
#include <strike/text.hpp>

namespace strike::detail {

/// The next step of a run that whole steps lead to its end. Waves near the frequency 2/dt of the step change their
/// energy by the share of dt by which the step changes, all at once or little by little, so that what is left over of a
/// step is spread over the last 50: none of them is shorter by more than a fiftieth.
inline double step_to_end(double dt, double left) {
  const double steps = std::ceil(left / dt * (1 - 1e-9));  // but for rounding
  if (steps <= 1) return left;
  return steps <= 50 ? left / steps : dt;
}

/// The end to which a run is on its way, as long as it is.
class Goal {
 public:
  /// Errors: an end that is past or no number; the run is on its way already.
  Goal(std::optional<double>& goal, double end, double now) : goal_(goal) {
    if (goal)
      throw Error(
          "strike: until has been called by an observer of the same run; an observer changes nothing of it: call until "
          "again when the first has returned.");
    check(end, now);
    goal = end;
  }
  Goal(const Goal&) = delete;
  Goal& operator=(const Goal&) = delete;
  ~Goal() { goal_.reset(); }

  static void check(double end, double now) {
    if (std::isnan(end)) throw Error("strike: the end of a run is nan; give until a time.");
    if (end < now)
      throw Error(joined({"strike: the run is at t = ", shortest(now), " and cannot go until ", shortest(end),
                          ", which is past; give a later end."}));
  }

 private:
  std::optional<double>& goal_;
};

}  // namespace strike::detail
