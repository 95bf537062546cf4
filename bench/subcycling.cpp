// What subcycling saves, and where impulses of slow parts make fast ones unstable: chains of masses whose growth is
// that of the worst eigenvalue of a cycle, a block of two parts that shivers, and one that strikes with and without.
//
//   build/bench/bench/subcycling
//   build/bench/bench/subcycling repeats=9
//
// Written into out/subcycling: time.md, shivering.md, stability.md.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <string>
#include <vector>

#include <Eigen/Eigenvalues>

#include <strike/dynamics/explicit.hpp>
#include <strike/element/hex8.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/load/support.hpp>
#include <strike/material/eos/linear.hpp>
#include <strike/material/solid.hpp>
#include <strike/material/strength/von_mises.hpp>
#include <strike/mesh/box.hpp>
#include <strike/mesh/select.hpp>
#include <strike/mesh/transform.hpp>
#include <strike/output/file.hpp>

#include "support/options.hpp"

namespace {

using namespace strike;

std::string number(const char* format, double x) {
  char text[32];
  std::snprintf(text, sizeof text, format, x);
  return text;
}

/// A free chain of `fast` springs that a wave crosses in the time 1 and seven that it crosses in `multiple`; those
/// beyond `layers` act as impulses once in `multiple` steps.
struct Chain {
  Eigen::Index fast;
  std::size_t multiple, layers;
  double impedance, viscosity;  // of the slow springs over the fast; linear bulk viscosity of both

  /// What the worst vibration grows by in a cycle of steps of this share of the stable one: the spectral radius of the
  /// map of (x, v) over a cycle, less 1.
  double growth(double share) const {
    const auto m = static_cast<double>(multiple);
    const Eigen::Index springs = fast + 7, n = springs + 1;
    Eigen::VectorXd mass = Eigen::VectorXd::Zero(n);
    Eigen::MatrixXd K[2]{Eigen::MatrixXd::Zero(n, n), Eigen::MatrixXd::Zero(n, n)};
    Eigen::MatrixXd C[2]{K[0], K[1]};
    for (Eigen::Index e = 0; e < springs; ++e) {
      const bool coarse = e >= fast;
      const std::size_t impulse = e >= fast + static_cast<Eigen::Index>(layers);
      const double Z = coarse ? impedance : 1, length = coarse ? m : 1;
      mass.segment<2>(e).array() += 0.5 * Z * length;
      const Eigen::Matrix2d difference{{1, -1}, {-1, 1}};
      K[impulse].block<2, 2>(e, e) += Z / length * difference;
      C[impulse].block<2, 2>(e, e) += viscosity * Z * difference;
    }
    const double dt = share * (std::sqrt(1 + viscosity * viscosity) - viscosity);
    Eigen::MatrixXd map(2 * n, 2 * n);
    for (Eigen::Index k = 0; k < 2 * n; ++k) {
      Eigen::VectorXd state = Eigen::VectorXd::Unit(2 * n, k), x = state.head(n), v = state.tail(n);
      const Eigen::VectorXd before = x;
      for (std::size_t step = 1; step <= multiple; ++step) {
        x += dt * v;
        Eigen::VectorXd f = -(K[0] * x + C[0] * v);
        if (step == multiple) f -= m * (K[1] * x + C[1] * (x - before) / (m * dt));
        v += dt * f.cwiseQuotient(mass);
      }
      map.col(k) << x, v;
    }
    return map.eigenvalues().cwiseAbs().maxCoeff() - 1;
  }
};

std::string stability() {
  std::string table =
      "| step, multiple | no layer | 1 layer | 2 layers | 3 layers | no layer, viscous | 1 layer, viscous | 2 layers, "
      "viscous |\n|---|--:|--:|--:|--:|--:|--:|--:|\n";
  std::printf("%s", table.c_str());
  for (const auto& [from, to] : {std::pair{0.5, 0.7}, std::pair{0.7, 0.9}, std::pair{0.9, 0.95}})
    for (const std::size_t multiple : {2u, 3u, 4u, 5u, 6u, 8u}) {
      std::string row =
          detail::joined({"| ", number("%.2f", from), " to ", number("%.2f", to), ", ", std::to_string(multiple)});
      for (const auto& [viscosity, layers] : {std::pair{0., 0}, std::pair{0., 1}, std::pair{0., 2}, std::pair{0., 3},
                                              std::pair{0.06, 0}, std::pair{0.06, 1}, std::pair{0.06, 2}}) {
        double worst = 0;
        int unstable = 0, all = 0;
        for (const double impedance : {0.1, 1.0, 10.0})
          for (const int fast : {5, 9, 13, 17})
            for (int k = 0; k < 10; ++k, ++all) {
              const Chain chain{fast, multiple, static_cast<std::size_t>(layers), impedance, viscosity};
              const double growth = chain.growth(from + (to - from) * (k + 0.5) / 10);
              if (growth < 1e-6) continue;  // rounding of what only moves
              ++unstable;
              worst = std::max(worst, growth);
            }
        row +=
            unstable == 0
                ? " | stable"
                : detail::joined({" | ", number("%.0e", worst), " in ", number("%.1f", 100. * unstable / all), " %"});
      }
      row += " |\n";
      std::printf("%s", row.c_str());
      std::fflush(stdout);
      table += row;
    }
  return table;
}

/// A block of steel in flat layers whose face z = 0 is stopped: there a tenth of them is a part of its own, the rest
/// are `ratio` times as high. Metres, seconds, kilograms.
struct Block {
  Index cells, layers;
  double ratio, speed;

  Mesh mesh() const {
    const double h = 1e-3, width = 10 * ratio * h;
    return transformed(box({.size = {cells * width, cells * width, 1. * layers}, .cells = {cells, cells, layers}}),
                       [&](const Eigen::Vector3d& x) {
                         const double k = std::round(x.z()), fine = layers / 10;
                         return Eigen::Vector3d(x.x(), x.y(), h * (std::min(k, fine) + ratio * std::max(k - fine, 0.)));
                       });
  }
  auto scene() const {
    const Mesh mesh = this->mesh();
    const Solid steel{LinearEos{.density = 7850, .bulk_modulus = 167e9},
                      VonMises{.shear_modulus = 77e9, .yield_stress = 400e6, .hardening_modulus = 1e9}};
    const auto middle = mesh.hexahedra.begin() + mesh.hexahedra.size() / 10;
    return Scene{mesh.nodes, Part{Hex8{ViscousHourglass{}}, steel, Cells<8>(mesh.hexahedra.begin(), middle)},
                 Part{Hex8{ViscousHourglass{}}, steel, Cells<8>(middle, mesh.hexahedra.end())},
                 InitialVelocity{{0, 0, -speed}}, Symmetry{Axis::z, nodes_where(mesh.nodes, on_plane(Axis::z, 0))}};
  }
};

struct Outcome {
  double seconds = 0, height = 0, drift = 0;
  std::size_t steps = 0;
};
template <class Scene, class... Policies>
Outcome outcome(const Scene& scene, std::size_t steps, const Policies&... policies) {
  Explicit run{scene, ExplicitOptions{}, policies...};
  Outcome o;
  const std::clock_t begin = std::clock();
  for (; o.steps < steps; ++o.steps) {
    run.step();
    o.drift = std::max(o.drift, std::abs(run.energy().error()));
  }
  o.seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC / run.time();
  for (const Eigen::Vector3d& x : run.positions()) o.height = std::max(o.height, x.z());
  return o;
}

std::string time(std::size_t repeats) {
  std::string table =
      "| block | multiple | elements advanced a step | time: median | least | most | energy error: without, with "
      "|\n|---|--:|--:|--:|--:|--:|---|\n";
  std::printf("%s", table.c_str());
  for (const Block& block : {Block{16, 40, 2.1, 10}, Block{16, 40, 4.1, 10}, Block{16, 40, 8.2, 10},
                             Block{32, 40, 4.1, 10}, Block{16, 40, 4.1, 100}}) {
    const auto scene = block.scene();
    std::vector<double> ratios;
    Outcome usual, cycled;
    const std::size_t steps = 240;
    for (std::size_t i = 0; i < repeats; ++i) {
      usual = outcome(scene, steps);
      cycled = outcome(scene, steps, Subcycling{});
      ratios.push_back(cycled.seconds / usual.seconds);
    }
    std::sort(ratios.begin(), ratios.end());
    Explicit run{scene, ExplicitOptions{}, Subcycling{}};
    const double all = static_cast<double>(block.cells) * block.cells * block.layers,
                 share = 1 - static_cast<double>(run.cycle().slow(run.item<1>())) / all *
                                 (1 - 1 / static_cast<double>(run.cycle().multiple()));
    const std::string row = detail::joined({"| ",
                                            number("%g", all),
                                            " elements, 1 to ",
                                            number("%g", block.ratio),
                                            ", ",
                                            number("%g", block.speed),
                                            " m/s | ",
                                            std::to_string(run.cycle().multiple()),
                                            " | ",
                                            number("%.2f", share),
                                            " | ",
                                            number("%.2f", ratios[ratios.size() / 2]),
                                            " | ",
                                            number("%.2f", ratios.front()),
                                            " | ",
                                            number("%.2f", ratios.back()),
                                            " | ",
                                            number("%.1e", usual.drift),
                                            ", ",
                                            number("%.1e", cycled.drift),
                                            " |\n"});
    std::printf("%s", row.c_str());
    std::fflush(stdout);
    table += row;
  }
  return table;
}

/// What the energy of a free elastic block is off by at most while it shivers, from wild velocities on.
template <class Viscosity>
std::string shivering(const Block& block, std::size_t cycles) {
  const Mesh mesh = block.mesh();
  const auto middle = mesh.hexahedra.begin() + mesh.hexahedra.size() / 10;
  const auto worst = [&](double factor, std::size_t layers) {
    const Elastic steel{.density = 7850, .youngs_modulus = 200e9, .poissons_ratio = 0.3};
    const Hex8 element{StiffnessHourglass{}, HughesWinget{}, Viscosity{}};
    const auto wild = [](const Eigen::Vector3d& x) {
      const double k = 1e6 * (x.x() + 1.7 * x.y() + 2.3 * x.z());
      return Eigen::Vector3d{std::sin(k), std::sin(1.3 * k + 1), std::sin(1.9 * k + 2)};
    };
    Explicit run{Scene{mesh.nodes, Part{element, steel, Cells<8>(mesh.hexahedra.begin(), middle)},
                       Part{element, steel, Cells<8>(middle, mesh.hexahedra.end())}, InitialVelocityField{wild}},
                 {.step_factor = factor, .energy_tolerance = 10},
                 in<double>,
                 Subcycling{.layers = layers}};
    double error = 0;
    try {
      while (run.steps() < cycles * run.cycle().multiple()) {
        run.step();
        error = std::max(error, std::abs(run.energy().error()));
      }
    } catch (const Error&) {
      return std::string("grows");
    }
    return number("%.1f %%", 100 * error);
  };
  std::string rows;
  for (const double factor : {0.5, 0.7, 0.8, 0.9, 0.95}) {
    std::string row =
        detail::joined({"| ", number("%g", block.ratio), ", ",
                        std::is_same_v<Viscosity, NoBulkViscosity> ? "without" : "with", ", ", number("%.2f", factor)});
    for (const std::size_t layers : {0u, 1u, 2u, 3u}) row += " | " + worst(factor, layers);
    row += " |\n";
    std::printf("%s", row.c_str());
    std::fflush(stdout);
    rows += row;
  }
  return rows;
}
std::string shivering() {
  std::string table =
      "| ratio, bulk viscosity, step factor | no layer | 1 layer | 2 layers | 3 layers |\n|---|--:|--:|--:|--:|\n";
  std::printf("%s", table.c_str());
  for (const double ratio : {2.1, 4.1, 8.2}) {
    table += shivering<NoBulkViscosity>({4, 20, ratio, 0}, 1000);
    table += shivering<BulkViscosity>({4, 20, ratio, 0}, 1000);
  }
  return table;
}

}  // namespace

int main(int count, char** arguments) {
  return examples::run(count, arguments, [](examples::Options& options) {
    const std::size_t repeats = options.count("repeats", 5);
    options.check();
    detail::replace_file("out/subcycling/time.md", time(repeats));
    detail::replace_file("out/subcycling/shivering.md", shivering());
    detail::replace_file("out/subcycling/stability.md", stability());
    std::printf("\nWritten: out/subcycling/time.md, shivering.md, stability.md\n");
  });
}
