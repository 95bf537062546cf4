#pragma once
#include <utility>

#include <strike/cxx20.hpp>

namespace strike {

/// An observer that ends a run early: `run.until(1.0, StopWhen{[&] { return run.energy().kinetic < 1e-3; }})`. The
/// condition is asked after each step, as `condition()` or `condition(run)`.
template <class F>
class StopWhen {
 public:
  using Condition = F;

  explicit StopWhen(F condition) : condition_(std::move(condition)) {}

  template <class Run>
  void operator()(const Run& run) {
    if constexpr (requires { condition_(run); })
      met_ = condition_(run);
    else
      met_ = condition_();
  }
  /// The run is to end.
  bool stops() const { return met_; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(met_);
  }

 private:
  F condition_;
  bool met_ = false;
};

}  // namespace strike
