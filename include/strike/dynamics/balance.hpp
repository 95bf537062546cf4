#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include <strike/motion/ledger.hpp>
#include <strike/text.hpp>

namespace strike::detail {

// The balance of energies of a run, as functions of numbers.

/// The kinetic energy with which central differences start: sum of m v.v/2 less f.(v+ - v) kick/2, for the first half
/// step is one under the force f at its start alone. (From rest under a constant f they keep m v-.v+/2 - f x at
/// -(kick f)^2/(2 m).)
inline double kinetic_energy_at_start(double kinetic, double kick, double force_power) {
  return kinetic - 0.5 * kick * force_power;
}

/// Energy that rounding may add until a step, a share `tolerance` of that of nodes that move by the spacing of the
/// numbers in each: `moved` is the sum of m spacing^2/2 [energy time^2].
inline double energy_of_rounding(double tolerance, double moved, std::size_t step, double dt) {
  if (std::isinf(tolerance)) return tolerance;
  const double moves = static_cast<double>(step) / (dt * dt);
  return tolerance * moved * moves;
}

/// Velocities that change sign and grow from step to step. An unstable step keeps the balance: a negative kinetic
/// energy grows with the internal one. (A vibration of the energy E with w dt = 2 sin(a) has the kinetic energy -E
/// tan^2(a) at its turning points: -4 E at 0.9 of the stable step, -49 E at 0.99.) `reached` is the largest of the
/// initial energy and the external work so far: a pendulum that comes back to where it has begun at rest has neither
/// there.
inline bool grows_beyond_stability(const Energy& energy, double reached, double rounding) {
  return !(energy.kinetic >= -100 * reached - rounding);
}

/// The balance is within the tolerance, a share of the largest energy, or off by rounding alone.
inline bool is_balanced(const Energy& energy, double reached, double tolerance, double rounding) {
  return std::abs(energy.imbalance()) <=
         std::max(rounding, tolerance * std::max(energy.scale(), reached));  // infinite times 0
}

[[gnu::cold]] inline std::string beyond_stability(const Energy& energy) {
  return joined({"the velocities grow from step to step with changing sign (kinetic energy ", text(energy.kinetic),
                 "): the step is beyond stability; use a smaller step factor"});
}
[[gnu::cold]] inline std::string out_of_balance(const Energy& energy, const std::string& culprit,
                                                const std::string& load) {
  const std::string advice =
      !load.empty() ? load : joined({"use a smaller step factor or look for what is wrong near ", culprit});
  return joined(
      {"the energy balance is off by ", text(100 * energy.error()), " % of ", text(energy.scale()), "; ", advice});
}

}  // namespace strike::detail
