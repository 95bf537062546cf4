#pragma once
// A free block of distorted tetrahedra.
#include <random>

#include <strike/mesh/box.hpp>
#include <strike/mesh/tetrahedra.hpp>

namespace strike::free_tetrahedra {

/// The unit cube in 6 n^3 tetrahedra, its corners moved at random by up to a share of the edge.
inline Mesh block(Index n, double distortion) {
  Mesh mesh = tetrahedralized(box({.size = {1, 1, 1}, .cells = {n, n, n}}));
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (Eigen::Vector3d& x : mesh.nodes) x += distortion / n * Eigen::Vector3d{unit(random), unit(random), unit(random)};
  return mesh;
}

/// Every node at a velocity of its own.
struct RandomVelocity {
  double speed;

  template <class N>
  void begin(N& nodes) const {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform(-speed, speed);
    for (std::size_t i = 0; i < nodes.size(); ++i)
      nodes.set_velocity(i, {uniform(random), uniform(random), uniform(random)});
  }
};

/// v = L x.
struct HomogeneousVelocity {
  Eigen::Matrix3d L;

  template <class N>
  void begin(N& nodes) const {
    for (std::size_t i = 0; i < nodes.size(); ++i) nodes.set_velocity(i, L * nodes.x(i));
  }
};

}  // namespace strike::free_tetrahedra
