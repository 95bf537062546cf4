#include <cmath>
#include <numeric>
#include <utility>

#include <strike/contact/rigid_wall.hpp>
#include <strike/element/hex8.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/material/eos/cubic.hpp>
#include <strike/material/eos/gruneisen.hpp>
#include <strike/material/eos/polynomial.hpp>
#include <strike/material/fluid.hpp>

#include "problems/column.hpp"
#include "support/catch.hpp"

using namespace strike;

namespace {

/// The state behind a shock that a rigid wall sends into matter of the speed v: p = rho0 U v, E = p mu/(2 (1 + mu)).
struct Shock {
  double speed;     ///< v [m/s]
  double pressure;  ///< [Pa]
  double U;         ///< [m/s], relative to the matter ahead
};

// The plateau within 0.5 %, the speed of the front within 1 %, its width 3 to 6 elements.
template <class Eos>
void check_shock(const Eos& eos, const Shock& shock) {
  INFO("rho " << eos.density << ", v " << shock.speed);
  const Index N = 200;
  const double h = 1e-3, v = shock.speed;
  const Mesh mesh = column(N, N * h, h);
  const std::vector<Index> all = all_nodes(mesh.nodes);
  Explicit run{Scene{mesh.nodes, Part{Hex8{}, Fluid{eos}, mesh.hexahedra}, InitialVelocity{{-v, 0, 0}},
                     Symmetry{Axis::y, all}, Symmetry{Axis::z, all}, RigidWall{{0, 0, 0}, {1, 0, 0}}}};
  const auto pressure = [&] { return run.template part<0>().field([](const auto& state) { return state.pressure; }); };
  const auto mean = [](const std::vector<double>& a) { return std::accumulate(&a[20], &a[120], 0.0) / 100; };

  double at_60 = 0, at_140 = 0;  // when the front, half way up, comes by two elements
  while (at_140 == 0) {
    run.step();
    const std::vector<double> p = pressure();
    if (at_60 == 0 && p[60] > 0.5 * shock.pressure) at_60 = run.time();
    if (at_140 == 0 && p[140] > 0.5 * shock.pressure) at_140 = run.time();
    REQUIRE(run.time() < N * h / shock.U);
  }
  const std::vector<double> p = pressure();
  CHECK(mean(p) == Approx(shock.pressure).epsilon(5e-3));
  CHECK(80 * h / (at_140 - at_60) == Approx(shock.U).epsilon(0.01));

  std::size_t foot = N - 1, top;  // the front from a thousandth of the pressure up to 95 % of it
  while (p[foot] < 1e-3 * shock.pressure) --foot;
  for (top = foot; p[top] < 0.95 * shock.pressure;) --top;
  CHECK(foot - top >= 3);
  CHECK(foot - top <= 6);

  if constexpr (requires { eos.C4; })  // the internal energy behind is the kinetic energy ahead
    CHECK(mean(run.template part<0>().field([](const auto& state) { return state.internal_energy; })) ==
          Approx(0.5 * eos.density * v * v).epsilon(0.01));
  CHECK(std::abs(run.energy().error()) < 5e-3);  // quarters with half the step
}

constexpr double knots_350 = 180.05555555555556;

constexpr CubicEos bird(double density) { return {.density = density, .C1 = 2.06e9, .C2 = 6.19e9, .C3 = 10.3e9}; }
/// The cubic that fits the shock velocity c + k u.
constexpr CubicEos cubic(double density, double c, double k) {
  const double C1 = density * c * c;
  return {.density = density, .C1 = C1, .C2 = (2 * k - 1) * C1, .C3 = (k - 1) * (3 * k - 1) * C1};
}

}  // namespace

TEST_CASE("shock states of the bird of Brockman and Held") {
  check_shock(bird(938), {100, 157.674e6, 1680.95});
  check_shock(bird(938), {knots_350, 310.219e6, 1836.79});
  check_shock(bird(938), {225, 405.760e6, 1922.58});
  check_shock(bird(950), {knots_350, 312.572e6, 1827.34});
}

TEST_CASE("shock states of water and copper, cubic fits to their shock velocity") {
  check_shock(cubic(1000, 1480, 1.92), {knots_350, 327.895e6, 1821.08});
  check_shock(cubic(1000, 1480, 1.92), {1000, 3195.27e6, 3195.27});
  check_shock(cubic(8930, 3940, 1.489), {500, 20901.0e6, 4681.1});
  check_shock(cubic(8930, 3940, 1.489), {1000, 48297.5e6, 5408.5});
}

TEST_CASE("shock states of water and copper whose shock velocity is linear") {
  const GruneisenEos water{.density = 1000, .sound_speed = 1480, .S1 = 1.92, .gamma = 0};
  const GruneisenEos copper{.density = 8930, .sound_speed = 3940, .S1 = 1.489, .gamma = 0};
  for (const auto& [eos, u] : {std::pair{water, 180.0}, {water, 1000.0}, {copper, 500.0}, {copper, 1000.0}}) {
    const double U = eos.sound_speed + eos.S1 * u;
    check_shock(eos, {u, eos.density * U * u, U});
  }
}

TEST_CASE("D10: the shock state of aluminium that meets its like at 10 km/s") {
  const GruneisenEos aluminium{.density = 2785, .sound_speed = 5328, .S1 = 1.338, .gamma = 0};
  const double u = 5000, U = aluminium.sound_speed + aluminium.S1 * u;  // half the speed against a plane of symmetry
  check_shock(aluminium, {u, aluminium.density * U * u, U});
}

TEST_CASE("shock states of water in which the energy stands") {
  const PolynomialEos water{.density = 1000, .C1 = 2.19e9, .C2 = 9.224e9, .C3 = 8.767e9, .C4 = 0.4934, .C5 = 1.3937};
  check_shock(water, {100, 173.434e6, 1734.34});
  check_shock(water, {knots_350, 345.606e6, 1919.44});
  check_shock(water, {1000, 3481.56e6, 3481.56});
}
