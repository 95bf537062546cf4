#pragma once
#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include <strike/element/element.hpp>
#include <strike/range.hpp>
#include <strike/text.hpp>

namespace strike {

// The damping of a whole run, a policy of Explicit.
//
// Requirements.
//  1. Running                                        the damping at work, constructed from the model, with
//     passes_peak(kinetic, internal) -> bool         asked before each step, with the energy m v-.v+/2 that the step
//                                                    would give: true if all nodes are to stop
//     restarts() -> bool                             the nodes start from rest in this step
//     is_at_rest() -> bool                           the run is to end
//     add_warning(part, warnings)                    of a RunningPart, what the user should know first
//     serialize(archive)                             its memory
//
// Models: NoDamping, DynamicRelaxation.
template <class D>
concept Damping = std::copyable<D> && requires(typename D::Running at_work, double energy) {
  { at_work.passes_peak(energy, energy) } -> std::same_as<bool>;
  { at_work.restarts() } -> std::same_as<bool>;
  { at_work.is_at_rest() } -> std::same_as<bool>;
};

/// Nothing takes energy from the motion of a run as a whole: the default.
struct NoDamping {
  struct Running {
    explicit Running(NoDamping) {}
    static constexpr bool passes_peak(double, double) { return false; }
    static constexpr bool restarts() { return false; }
    static constexpr bool is_at_rest() { return false; }
    static void add_warning(const auto&, std::vector<std::string>&) {}
    void serialize(auto&) {}
  };
};

/// Statics by dynamic relaxation with kinetic damping (Cundall 1976; Topping and Khan 1994): whenever the kinetic
/// energy has passed a peak, all nodes stop, and the run goes on from where they are, until what still swings is small.
/// Loads should be constant, materials elastic or loaded monotonically, hourglass control StiffnessHourglass, for a
/// viscous one flows; times mean nothing.
///   Explicit run{scene, {}, DynamicRelaxation{}};
///   run.until(at_rest);
struct DynamicRelaxation {
  double tolerance = 1e-4;  ///< the share of the displacements that may still swing: square root of the kinetic energy
                            ///< over the internal one, for twice as long as the longest swing took

  void ranges(const auto& number) const { number("tolerance", tolerance, Range{.low = 0, .high = 1}); }

  class Running;
};

/// The time until which a relaxation runs.
inline constexpr double at_rest = std::numeric_limits<double>::infinity();

/// The relaxation at work.
class DynamicRelaxation::Running {
 public:
  explicit Running(const DynamicRelaxation& policy) : policy_(policy) {}

  /// True once the kinetic energy has passed a peak, so that the nodes are to stop. A ripple is no peak.
  bool passes_peak(double kinetic, double internal) {
    const bool quiet = kinetic <= policy_.tolerance * policy_.tolerance * internal;
    quiet_steps_ = quiet ? quiet_steps_ + 1 : 0;
    ++steps_;
    restarts_ = peak_ > 0 && kinetic < 0.9 * peak_;
    if (!restarts_) {
      peak_ = std::max(peak_, kinetic);  // from rest it begins below zero, see kinetic_energy_at_start
      return false;
    }
    longest_ = std::max(longest_, steps_);
    steps_ = 0;
    peak_ = 0;
    ++peaks_;
    return true;
  }
  /// The nodes start from rest in this step.
  bool restarts() const { return restarts_; }
  bool is_at_rest() const { return peaks_ > 0 && quiet_steps_ > 2 * longest_; }
  std::size_t peaks() const { return peaks_; }
  template <class Part>
  void add_warning(const Part& part, std::vector<std::string>& warnings) const {
    if constexpr (flows<typename Part::Element>())
      warnings.push_back(detail::joined({"the viscous hourglass control of part ", std::to_string(part.number()),
                                         " flows under a constant load, so that it may never come to rest; take "
                                         "StiffnessHourglass for a relaxation."}));
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(peak_, steps_, longest_, quiet_steps_, peaks_, restarts_);
  }

 private:
  DynamicRelaxation policy_;
  double peak_ = 0;
  std::size_t steps_ = 0, longest_ = 0, quiet_steps_ = 0, peaks_ = 0;
  bool restarts_ = false;
};

}  // namespace strike
