#pragma once
// Two equal steel bars along x that meet: a wave runs through each and back, and they part with velocities exchanged.
// Metres, seconds, kilograms. Without Poisson's effect the waves are plane.
#include <cmath>
#include <vector>

#include <strike/contact/surface.hpp>
#include <strike/material/elastic.hpp>
#include <strike/mesh/box.hpp>
#include <strike/mesh/surface.hpp>
#include <strike/mesh/transform.hpp>

namespace examples {

struct TwoBars {
  static constexpr double length = 1, width = 0.01, speed = 10;
  static constexpr strike::Elastic steel{.density = 7850, .youngs_modulus = 200e9, .poissons_ratio = 0};
  static inline const double c = std::sqrt(steel.youngs_modulus / steel.density);
  static inline const double duration = 2 * length / c, stress = steel.density * c * speed / 2;  ///< of the contact

  double gap;
  strike::Mesh bar, mesh;  ///< one bar, both

  TwoBars(strike::Index cells, double apart)
      : gap(apart), bar(strike::box({.size = {length, width, width}, .cells = {cells, 1, 1}})), mesh(bar) {
    append(mesh, translated(bar, {length + gap, 0, 0}));
  }

  strike::Surface left_end() const { return end_at(length); }
  strike::Surface right_end() const { return end_at(length + gap); }

  /// Half of the speed for each bar, towards the other.
  auto approach() const {
    return [middle = length + gap / 2](const Eigen::Vector3d& x) {
      return Eigen::Vector3d(x.x() < middle ? speed / 2 : -speed / 2, 0, 0);
    };
  }

  /// Mean velocity along x of the left bar, or of the right one.
  template <class Run>
  double left_velocity(const Run& run) const {
    return velocity(run, 0);
  }
  template <class Run>
  double right_velocity(const Run& run) const {
    return velocity(run, bar.nodes.size());
  }

 private:
  strike::Surface end_at(double x) const {
    std::vector<strike::Face> faces = surface(mesh);
    std::erase_if(faces, [&](const auto& face) { return std::abs(centroid(mesh.nodes, face).x() - x) > gap / 4; });
    return strike::Surface{faces};
  }

  template <class Run>
  double velocity(const Run& run, std::size_t from) const {
    double momentum = 0, mass = 0;
    for (std::size_t i = from; i < from + bar.nodes.size(); ++i)
      momentum += run.nodes().mass(i) * run.nodes().v(i).x(), mass += run.nodes().mass(i);
    return momentum / mass;
  }
};

}  // namespace examples
