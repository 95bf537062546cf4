// A thick, simply supported beam in plane strain, elastic, swings in its first mode. That is the standing flexural wave
// of a plate, for which elasticity has an exact solution.
#include <cmath>
#include <numbers>

#include <strike/dynamics/every.hpp>
#include <strike/load/support.hpp>
#include <strike/material/elastic.hpp>
#include <strike/mesh/box.hpp>
#include <strike/mesh/select.hpp>

#include "policies.hpp"

namespace trade {

namespace {

// Thickness, density and Young's modulus are 1; the supports are 8 apart.
constexpr double span = 8, poissons_ratio = 0.3, amplitude = 1e-3;

/// The antisymmetric wave of Lamb (1917) with the potentials sinh(a z) sin(k x) and B cosh(b z) cos(k x):
///   a^2 = k^2 - w^2/c_L^2,   b^2 = k^2 - w^2/c_T^2,   4 k^2 a b tanh(b/2) = (k^2 + b^2)^2 tanh(a/2)
/// in a plate of thickness 1. It carries no bending moment and does not deflect where sin(k x) = 0.
struct FlexuralWave {
  double k = std::numbers::pi / span, frequency, a, b, B, height;

  FlexuralWave() {
    const double G = 0.5 / (1 + poissons_ratio), M = 2 * G * (1 - poissons_ratio) / (1 - 2 * poissons_ratio);
    double low = 0, high = 0.9 * k * std::sqrt(G);  // slower than a surface wave
    for (int i = 0; i < 100; ++i) {
      frequency = 0.5 * (low + high);
      a = std::sqrt(k * k - frequency * frequency / M), b = std::sqrt(k * k - frequency * frequency / G);
      const double s = (k * k + b * b) * (k * k + b * b);
      (4 * k * k * a * b * std::tanh(b / 2) > s * std::tanh(a / 2) ? low : high) = frequency;
    }
    B = -2 * k * a * std::cosh(a / 2) / ((k * k + b * b) * std::cosh(b / 2));
    height = a + k * B;
  }
  /// Displacement where the centre line deflects by sin(k x).
  Eigen::Vector3d operator()(const Eigen::Vector3d& x) const {
    const double u = k * std::sinh(a * x.z()) + B * b * std::sinh(b * x.z()),
                 w = a * std::cosh(a * x.z()) + B * k * std::cosh(b * x.z());
    return Eigen::Vector3d(u * std::cos(k * x.x()), 0, w * std::sin(k * x.x())) / height;
  }
};

/// Begins in the undeformed shape with the velocities of the wave.
struct Swing {
  FlexuralWave wave;

  template <class N>
  void begin(N& nodes) const {
    for (std::size_t i = 0; i < nodes.size(); ++i) nodes.set_velocity(i, amplitude * wave.frequency * wave(nodes.x(i)));
  }
};

constexpr auto swing = [](const auto& element, auto numbers, const Setting& setting) -> Outcome {
  const FlexuralWave wave;
  const Index n = Index{1} << setting.mesh;
  const Mesh half = box({.lower = {0, -0.5, -0.5}, .size = {span / 2, 1, 1}, .cells = {4 * n, n, n}});
  const auto plane = [&](Axis axis, double at) { return nodes_where(half.nodes, on_plane(axis, at)); };
  const Elastic material{.density = 1, .youngs_modulus = 1, .poissons_ratio = poissons_ratio};
  Explicit run{Scene{half.nodes,                                                                            //
                     Part{element, material, half.hexahedra},                                               //
                     Swing{wave},                                                                           //
                     Symmetry{Axis::z, plane(Axis::x, 0)},                                                  //
                     Symmetry{Axis::x, plane(Axis::x, span / 2)}, Symmetry{Axis::y, plane(Axis::y, -0.5)},  //
                     Symmetry{Axis::y, plane(Axis::y, 0.5)}},
               setting.options, numbers};

  double deviation = 0, motion = 0;
  const double period = 2 * std::numbers::pi / wave.frequency;
  const auto compare = [&] {
    const auto x = run.positions();
    double q = 0, norm = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const Eigen::Vector3d mode = static_cast<double>(run.nodes().mass(i)) * wave(half.nodes[i]);
      q += mode.dot(x[i] - half.nodes[i]), norm += mode.dot(wave(half.nodes[i]));
    }
    const double exact = amplitude * std::sin(wave.frequency * run.time());
    deviation += std::pow(q / norm - exact, 2), motion += exact * exact;
  };
  const double seconds = cpu_seconds([&] { run.until(period, Every{period / 32, compare}); });
  return {.error = std::sqrt(deviation / motion),
          .seconds = seconds,
          .steps = run.steps(),
          .elements = half.hexahedra.size()};
};

}  // namespace

Problem beam() {
  return problem({.name = "beam",
                  .title = "Thick beam that swings",
                  .error = "deflection against the exact flexural wave (Lamb 1917), root mean square over one period",
                  .meshes = {"1 layer", "2 layers", "4 layers", "8 layers"}},
                 swing, usual, elements, numbers, step_factors, hourglass_controls);
}

}  // namespace trade
