#pragma once
#include <cstddef>

#include <strike/cxx20.hpp>

namespace strike {

/// A step in time, as loads, supports and contacts see it: it starts at `time` and lasts `dt`, after a step of
/// `dt_before`.
struct Step {
  std::size_t number = 0;
  double time = 0;
  double dt_before = 0;
  double dt = 0;
  double stable_dt = dt;  ///< of the elements alone, whatever the step factor and what else shortens the step

  /// Duration over which a force at `time` acts on the velocities: from the middle of the last step to the middle of
  /// this one.
  double kick() const { return 0.5 * (dt_before + dt); }
};

}  // namespace strike
