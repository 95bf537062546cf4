#pragma once
// 8 x 8 x 8 free cubes at nu = 0.4999 without damping of any kind, which begin with velocities at random.
#include <random>

#include <strike/dynamics/explicit.hpp>
#include <strike/element/hex8.hpp>
#include <strike/mesh/box.hpp>

namespace strike::free_cubes {

inline constexpr double h = 1.0 / 8;
inline constexpr Elastic rubber{.density = 1000, .youngs_modulus = 1e9, .poissons_ratio = 0.4999};
inline double wave_speed() {
  return std::sqrt((rubber.bulk_modulus() + 4 * rubber.shear_modulus() / 3) / density_of(rubber));
}

/// So small that 1e5 steps of an hourglass do not turn the cubes over.
struct RandomVelocity {
  template <class N>
  void begin(N& nodes) const {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform(-1e-6, 1e-6);
    for (std::size_t i = 0; i < nodes.size(); ++i)
      nodes.set_velocity(i, {uniform(random), uniform(random), uniform(random)});
  }
};

inline auto cubes(const ExplicitOptions& options = {}) {
  const Mesh mesh = box({.size = {1, 1, 1}, .cells = {8, 8, 8}});
  const Hex8 undamped{NoHourglass{}, HughesWinget{}, NoBulkViscosity{}};
  return Explicit{Scene{mesh.nodes, Part{undamped, rubber, mesh.hexahedra}, RandomVelocity{}}, options};
}

/// The largest error of the balance on the way to that many steps.
template <class Run>
double drift(Run& run, std::size_t steps) {
  double worst = 0;
  while (run.steps() < steps) {
    run.step();
    worst = std::max(worst, std::abs(run.energy().error()));
  }
  return worst;
}

}  // namespace strike::free_cubes
