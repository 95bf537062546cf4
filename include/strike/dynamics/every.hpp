#pragma once
#include <cmath>
#include <utility>

#include <strike/error.hpp>

namespace strike {

/// An observer that acts at the start and then at the first step at or after each multiple of an interval:
/// `run.until(80e-6, Every{1e-6, [&] { history.row(run.time(), length()); }})`. At the end of a run that was given up
/// it acts once more, so that the last state is on record.
template <class Action>
class Every {
 public:
  Every(double interval, Action action) : interval_(interval), action_(std::move(action)) {
    if (!(interval > 0)) throw Error("The interval of an Every is not positive: give a time greater than zero.");
  }

  template <class Run>
  void operator()(const Run& run) {
    if (run.time() < next_) return;
    next_ = interval_ * (std::floor(run.time() / interval_ * (1 + 1e-12)) + 1);
    act(run);
  }
  template <class Run>
  void last(const Run& run) {
    act(run);
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(next_);
  }

 private:
  template <class Run>
  void act(const Run& run) {
    if constexpr (requires { action_(run); })
      action_(run);
    else
      action_();
  }

  double interval_, next_ = 0;
  Action action_;
};

}  // namespace strike
