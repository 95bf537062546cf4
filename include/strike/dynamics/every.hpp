#pragma once
#include <cmath>
#include <utility>

#include <strike/dynamics/observer.hpp>
#include <strike/range.hpp>

namespace strike {

/// An observer that acts at the start and then at the first step at or after each multiple of an interval:
///   run.until(80e-6, Every{1e-6, [&] { history.row(run.time(), length()); }});
/// At the end of a run that was given up it acts once more, so that the last state is on record. The action is f() or
/// f(run).
template <class F>
class Every {
 public:
  using Action = F;

  /// Error: an interval that is not positive.
  Every(double interval, F action) : interval_(interval), action_(std::move(action)) { detail::check_ranges(*this); }

  void ranges(const auto& number) const { number("interval", interval_, range::or_infinite(range::positive)); }

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
    detail::observer::observe(action_, run);
  }

  double interval_, next_ = 0;
  F action_;
};

/// Fallback for an Every without an action: its static_assert is the one message.
template <>
class Every<void> {
 public:
  explicit Every(auto interval) {
    static_assert(sizeof(interval) == 0,
                  "strike: an Every takes an interval and an action, such as Every{1e-6, [&] { film.write(run); }}.");
  }
  void operator()() const {}
};
template <class Interval>
Every(Interval) -> Every<void>;

}  // namespace strike
