#pragma once
// Taylor's copper bar of particles on a cubic lattice, on a wall that it may leave; a quarter of it.
#include <cmath>
#include <numbers>

#include <strike/contact/rigid_wall.hpp>
#include <strike/element/particle.hpp>

#include "problems/particle_jet.hpp"
#include "problems/taylor_bar.hpp"

namespace strike::taylor {

/// `across` particles to the radius.
inline auto bar_of_particles(double across) {
  const Data& data = mm_ms_kg;
  const double s = data.radius / across;
  const int n = static_cast<int>(across) + 1, layers = static_cast<int>(std::lround(data.length / s));
  const Mesh mesh =
      particle_jet::filled({0, 0, 0}, {n, n, layers}, s, std::numbers::pi / 4 * data.radius * data.radius * data.length,
                           [&](const auto& x) { return std::hypot(x.x(), x.y()) < data.radius; });
  return Explicit{
      Scene{mesh.nodes,
            Part{Particle{Smoothing{}, Mirrors{Mirror{{1, 0, 0}}, Mirror{{0, 1, 0}}}}, copper(data), mesh.particles},
            InitialVelocity{{0, 0, -data.speed}}, RigidWall{{0, 0, 0.5 * s}, {0, 0, 1}}}};
}

}  // namespace strike::taylor
