#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace strike {

/// What takes energy from the motion of a whole run: nothing, unless told otherwise.
struct NoDamping {
  static constexpr bool damps = false;
};

/// Statics by dynamic relaxation with kinetic damping (Cundall 1976; Topping and Khan 1994): whenever the kinetic
/// energy has passed a peak, all nodes stop, and the run goes on from where they are, until what still swings is small.
/// Loads should be constant, materials elastic or loaded monotonically; times mean nothing.
///   Explicit run{scene, {}, DynamicRelaxation{}};
///   run.until(at_rest);
struct DynamicRelaxation {
  double tolerance = 1e-4;  ///< the share of the displacements that may still swing: square root of the kinetic energy
                            ///< over the internal one, for twice as long as the longest swing took

  static constexpr bool damps = true;
};

/// The time until which a relaxation runs.
inline constexpr double at_rest = std::numeric_limits<double>::infinity();

namespace detail {

/// A damping at work.
template <class Damping>
class RunningDamping {
 public:
  explicit RunningDamping(const Damping&) {}
};

template <>
class RunningDamping<DynamicRelaxation> {
 public:
  explicit RunningDamping(const DynamicRelaxation& policy) : policy_(policy) {}

  /// Whether the kinetic energy has passed a peak, so that the nodes are to stop. A ripple is no peak.
  bool passes_peak(double kinetic, double internal) {
    const bool quiet = kinetic <= policy_.tolerance * policy_.tolerance * internal;
    quiet_steps_ = quiet ? quiet_steps_ + 1 : 0;
    ++steps_;
    restarts_ = peak_ > 0 && kinetic < 0.9 * peak_;
    if (!restarts_) {
      peak_ = std::max(peak_, kinetic);  // from rest it begins below zero, see Explicit::begin_balance
      return false;
    }
    longest_ = std::max(longest_, steps_);
    steps_ = 0;
    peak_ = 0;
    ++peaks_;
    return true;
  }
  /// Whether the nodes start from rest in this step.
  bool restarts() const { return restarts_; }
  bool is_at_rest() const { return peaks_ > 0 && quiet_steps_ > 2 * longest_; }
  std::size_t peaks() const { return peaks_; }

 private:
  DynamicRelaxation policy_;
  double peak_ = 0;
  std::size_t steps_ = 0, longest_ = 0, quiet_steps_ = 0, peaks_ = 0;
  bool restarts_ = false;
};

}  // namespace detail

}  // namespace strike
