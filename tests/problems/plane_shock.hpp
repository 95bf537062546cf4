#pragma once
// A plane shock that a rigid wall sends along z into the water of birds, in layers of cells of the height 1.
#include <cstddef>
#include <vector>

#include <strike/dynamics/explicit.hpp>

#include "problems/particle_jet.hpp"

namespace strike::plane_shock {

/// Behind a shock that stops matter of this speed: p, and its speed from the wall.
struct Shock {
  double pressure, speed;
};
/// By the jump conditions, p = rho0 U v and v/U = mu/(1 + mu).
inline Shock stopping(double v) {
  using particle_jet::water;
  double low = 0, high = 1;  // of mu; p mu/(1 + mu) = rho0 v^2
  for (int k = 0; k < 60; ++k) {
    const double mu = 0.5 * (low + high);
    (water.A(mu) * mu / (1 + mu) < water.density * v * v ? low : high) = mu;
  }
  return {water.A(low), v / low};  // U - v
}

/// Means of a quantity of part 0 over the layers, a cell's by the middle of its nodes at the start.
template <class Cells>
class Layers {
 public:
  Layers(const std::vector<Eigen::Vector3d>& nodes, const Cells& cells, std::size_t count) : cells_(cells), of_(count) {
    for (std::size_t e = 0; e < cells.size(); ++e) {
      double z = 0;
      for (const Index i : cells[e]) z += nodes[i].z() / static_cast<double>(cells[e].size());
      of_[static_cast<std::size_t>(z)].push_back(e);
    }
  }

  template <class Run>
  std::vector<double> pressures(const Run& run) const {
    const auto p = run.template part<0>().field([](const auto& state) { return state.pressure; });
    return means([&](std::size_t e) { return p[e]; });
  }
  template <class Run>
  std::vector<double> heights(const Run& run) const {
    return means([&](std::size_t e) {
      double z = 0;
      for (const Index i : cells_[e]) z += run.nodes().x(i).z() / static_cast<double>(cells_[e].size());
      return z;
    });
  }

 private:
  std::vector<double> means(const auto& value) const {
    std::vector<double> means;
    for (const auto& layer : of_) {
      double& mean = means.emplace_back(0);
      for (const std::size_t e : layer) mean += value(e) / static_cast<double>(layer.size());
    }
    return means;
  }

  const Cells& cells_;
  std::vector<std::vector<std::size_t>> of_;
};

/// Results of a run over the exact ones.
struct Found {
  double pressure, speed;
};
/// Runs until the front has come to layer 26, the water being at least 40 high. The layers that it has passed, less
/// those that it smears and five at the wall.
template <class Run, class Cells>
Found found(Run& run, const Layers<Cells>& layers, double v) {
  const Shock exact = stopping(v);
  const auto front = [&] {
    const std::vector<double> p = layers.pressures(run), z = layers.heights(run);
    std::size_t k = p.size() - 1;
    while (k > 0 && p[k] < 0.5 * exact.pressure) --k;
    return z[k] + (p[k] - 0.5 * exact.pressure) / (p[k] - p[k + 1]) * (z[k + 1] - z[k]);
  };
  run.until(12 / exact.speed);
  const double first = front(), before = run.time();
  run.until(26 / exact.speed);
  const std::vector<double> p = layers.pressures(run);
  double mean = 0;
  for (std::size_t k = 5; k < 20; ++k) mean += p[k] / 15;
  return {mean / exact.pressure, (front() - first) / (run.time() - before) / exact.speed};
}

}  // namespace strike::plane_shock
