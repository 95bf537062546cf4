#include <algorithm>
#include <cmath>
#include <numbers>

#include <strike/dynamics/explicit.hpp>
#include <strike/element/hex8.hpp>
#include <strike/load/prescribed_motion.hpp>
#include <strike/load/support.hpp>
#include <strike/material/eos/linear.hpp>
#include <strike/material/solid.hpp>
#include <strike/material/strength/von_mises.hpp>
#include <strike/mesh/box.hpp>
#include <strike/mesh/select.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {

constexpr double G = 1, K = 2, rho = 1;

/// Shears a cube to gamma in steps of at most 1e-3, every node as it is told; calls observe(gamma, stress) on the way.
template <class Observer>
void shear(double yield_stress, double gamma, Observer observe) {
  const Mesh cube = box({.size = {1, 1, 1}});
  const std::vector<Index> all = all_nodes(cube.nodes);
  const auto on = [&](double y) { return nodes_where(cube.nodes, on_plane(Axis::y, y)); };
  const double dt = 1e-3;
  Explicit run{Scene{cube.nodes,
                     Part{Hex8{},
                          Solid{LinearEos{.density = rho, .bulk_modulus = K},
                                VonMises{.shear_modulus = G, .yield_stress = yield_stress}},
                          cube.hexahedra},
                     PrescribedDisplacement{Axis::x, on(1), [](double t) { return t; }}, Symmetry{Axis::x, on(0)},
                     Symmetry{Axis::y, all}, Symmetry{Axis::z, all}},
               ExplicitOptions{.largest_step = dt}, in<double>};
  run.until(gamma, [&] {
    SymmetricTensor<double> sigma;
    run.template part<0>().field([&](const auto& state) { return sigma = state.stress, 0.0; });
    observe(run.time(), sigma);
  });
}

}  // namespace

// Jaumann's rate in simple shear (Dienes 1979): tau = G sin(gamma), s11 = -s22 = G (1 - cos(gamma)).
TEST_CASE("an elastic cube in simple shear to gamma = 10 oscillates as Jaumann's rate says") {
  double worst = 0;
  shear(1e9, 10, [&](double gamma, const SymmetricTensor<double>& sigma) {
    worst = std::max({worst, std::abs(sigma.xy - G * std::sin(gamma)), std::abs(sigma.xx - G * (1 - std::cos(gamma))),
                      std::abs(sigma.yy + G * (1 - std::cos(gamma))), std::abs(sigma.zz)});
  });
  CHECK(worst < 1e-6 * G);
}

TEST_CASE("a plastic cube in simple shear holds Y/sqrt(3) and does not oscillate") {
  const double Y = 1e-3 * G, yield = Y / std::sqrt(3);
  double worst = 0;
  shear(Y, 10, [&](double gamma, const SymmetricTensor<double>& sigma) {
    if (gamma > 0.01) worst = std::max(worst, std::abs(sigma.xy - yield));
  });
  CHECK(worst < 1e-6 * yield);
}
