#include <strike/dynamics/explicit.hpp>
#include <strike/element/hex8.hpp>
#include <strike/load/nodal_force.hpp>
#include <strike/mesh/box.hpp>

#include "support/catch.hpp"

using namespace strike;

TEST_CASE("nodal forces with a history: their impulse is the trapezoidal sum, and their work balances") {
  const Mesh mesh = box({.size = {0.2, 0.3, 0.1}, .cells = {2, 3, 1}});
  const Elastic rubber{.density = 1000, .youngs_modulus = 1e8, .poissons_ratio = 0.3};
  const Eigen::Vector3d force(1, -2, 3);
  const double T = 0.01;
  const Curve triangle{{{0, 0}, {T / 2, 1}, {T, 0}}};
  Explicit run{Scene{mesh.nodes, Part{Hex8{}, rubber, mesh.hexahedra}, NodalForce{force, {0, 5, 7}, triangle}},
               ExplicitOptions{.largest_step = T / 200}};  // the corners of the curve are times of steps
  double drift = 0;
  run.until(2 * T, [&] { drift = std::max(drift, std::abs(run.energy().imbalance())); });
  const Eigen::Vector3d impulse = 3 * T / 2 * force;
  CHECK((run.momentum() - impulse).norm() < 1e-12 * impulse.norm());
  CHECK(run.energy().external > 0.5 * impulse.squaredNorm() / 6);  // of the mass 6, which turns and swings as well
  CHECK(drift < 1e-3 * run.energy().external);
}

TEST_CASE("a constant nodal force moves a free body as half the acceleration times time squared") {
  const Mesh mesh = box({.size = {1, 1, 1}});
  const Elastic rubber{.density = 2, .youngs_modulus = 1e3};
  std::vector<Index> all{0, 1, 2, 3, 4, 5, 6, 7};
  Explicit run{Scene{mesh.nodes, Part{Hex8{}, rubber, mesh.hexahedra}, NodalForce{{0.1, 0, 0}, all}}, {}, in<double>};
  run.until(1);
  for (const Index i : all) CHECK(run.nodes().x(i).x() - mesh.nodes[i].x() == Approx(0.5 * 0.8 / 2).epsilon(1e-12));
}
