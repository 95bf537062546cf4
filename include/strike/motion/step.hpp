#pragma once
#include <cstddef>

#include <strike/cxx20.hpp>

namespace strike {

/// A step in time as those see it who push or hold nodes: it begins at `time`, `dt` long, after one of `dt_before`.
struct Step {
  std::size_t number = 0;
  double time = 0;
  double dt_before = 0;
  double dt = 0;

  /// How long a force at `time` acts on the velocities: from the middle of the last step to the middle of this one.
  double kick() const { return 0.5 * (dt_before + dt); }
};

}  // namespace strike
