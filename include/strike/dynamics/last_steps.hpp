#pragma once
#include <cmath>
#include <optional>
#include <string>

#include <strike/error.hpp>
#include <strike/text.hpp>

namespace strike::detail {

/// The step with which whole steps fill what is left of a run. Steps that differ much from the one before cost balance,
/// so that none is shorter than dt by a larger share than by which it may grow: 1 step of 20 left over is spread over
/// these 20.
inline double step_to_end(double dt, double left, double growth) {
  const double steps = std::ceil(left / dt * (1 - 1e-9));  // but for rounding
  if (steps <= 1) return left;
  return steps <= 2 || steps * (growth - 1) < 1 + 1e-9 ? left / steps : dt;
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
