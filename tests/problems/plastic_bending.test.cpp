// One layer of hexahedra yields in bending as the material says: the moment of a layer by every flow law, and the limit
// loads of beams.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include <strike/strike.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {

// Thickness, width and yield stress are 1.
constexpr double E = 1000, nu = 0.3, G = E / (2 * (1 + nu)), K = E / (3 * (1 - 2 * nu));
const Hex8 physical{PhysicalHourglass{}};
constexpr auto everywhere = [](const Eigen::Vector3d&) { return true; };

/// The moment of a cube that is bent to the curvature at this rate, from the work; what inertia there is, is small.
template <class S>
double moment(const S& strength, double curvature, double rate) {
  const Mesh mesh = box({.lower = {0, -0.5, -0.5}, .size = {1, 1, 1}, .cells = {1, 1, 1}});
  const auto on = [&](Axis axis, double at) { return nodes_where(mesh.nodes, on_plane(axis, at)); };
  const auto edge = [&](double x, double z) {
    return nodes_where(mesh.nodes, [=](const Eigen::Vector3d& p) { return p.x() == x && p.z() == z; });
  };
  const auto at = [&](double z) { return [=](double) { return z * rate; }; };
  Explicit run{
      Scene{mesh.nodes,
            Part{physical, Solid{LinearEos{.density = 1e-6 / (rate * rate), .bulk_modulus = K}, strength},
                 mesh.hexahedra},
            Symmetry{Axis::x, on(Axis::x, 0)}, Symmetry{Axis::y, on(Axis::y, -0.5)}, Symmetry{Axis::z, edge(0, -0.5)},
            PrescribedVelocity{Axis::x, edge(1, 0.5), at(0.5)}, PrescribedVelocity{Axis::x, edge(1, -0.5), at(-0.5)}},
      ExplicitOptions{}, in<double>};
  const double end = curvature / rate;
  run.until(0.8 * end);
  const double before = run.energy().external, start = run.time();
  run.until(end);
  return (run.energy().external - before) / (rate * (run.time() - start));
}

/// The exact moment, 2 int sigma(z) z dz, of stresses sigma(e, r) at the strain kappa z and the rate r z.
double exact(double curvature, double rate, const std::function<double(double, double)>& sigma) {
  double sum = 0;
  const int n = 2000;
  for (int i = 0; i < n; ++i) {
    const double z = 0.5 * (i + 0.5) / n;
    sum += 2 * sigma(curvature * z, rate * z) * z * 0.5 / n;
  }
  return sum;
}

/// The mean force, over that of rigid-plastic hinges in the middle of their elements, by which the tip of a cantilever
/// moves on to the deflection, or the tip of one that may not turn; in plane strain, 20 times as long as thick.
double limit_load(Index cells, Index layers, bool turns, double deflection) {
  constexpr double length = 20;
  const Mesh mesh = box({.lower = {0, -0.5, -0.5}, .size = {length, 1, 1}, .cells = {cells, 1, layers}});
  const auto on = [&](double at) { return nodes_where(mesh.nodes, on_plane(Axis::x, at)); };
  const auto lower = [&](double at) {
    return nodes_where(mesh.nodes, [=](const Eigen::Vector3d& x) { return x.x() == at && x.z() == -0.5; });
  };
  const Solid metal{LinearEos{.density = 1, .bulk_modulus = K}, VonMises{.shear_modulus = G, .yield_stress = 1}};
  const double end = 400, speed = deflection / end;  // five of its periods
  const auto force = [&](const auto&... conditions) {
    Explicit run{Scene{mesh.nodes, Part{physical, metal, mesh.hexahedra}, Symmetry{Axis::x, on(0)},
                       Symmetry{Axis::z, lower(0)}, Symmetry{Axis::y, nodes_where(mesh.nodes, everywhere)},
                       PrescribedVelocity{Axis::z, lower(length), [=](double) { return speed; }}, conditions...},
                 ExplicitOptions{}, in<Pack<double>>};
    run.until(0.7 * end);
    const double before = run.energy().external, start = run.time();
    run.until(end);
    return (run.energy().external - before) / (speed * (run.time() - start));
  };
  const double moment = 2 / std::numbers::sqrt3 * 0.25, element = length / double(cells);
  return turns ? force() / (moment / (length - element / 2))
               : force(Symmetry{Axis::x, on(length)}) / (2 * moment / (length - element));
}

}  // namespace

TEST_CASE("plastic bending: a layer has the moment of its flow law, at any rate") {
  const double kappa = 0.1, plastic = kappa - 2.0 / E;
  const auto check = [&](const char* name, const auto& law, double rate,
                         const std::function<double(double, double)>& s) {
    CAPTURE(name, rate);
    CHECK(moment(law, kappa, rate) == Approx(exact(plastic, rate, s)).epsilon(0.04));
  };
  check("perfect", VonMises{G, 1}, 1, [](double, double) { return 1; });
  check("linear", VonMises{G, 1, 5}, 1, [](double e, double) { return 1 + 5 * e; });
  check("power", PowerHardening{G, 2, 0.2, 0.01}, 1, [](double e, double) { return 2 * std::pow(0.01 + e, 0.2); });
  for (const double rate : {1.0, 1e3, 1e6}) {
    check("X3D", RateVonMises{G, 1, 0, 0.5, 0.2}, rate, [](double, double r) { return 1 + 0.5 * std::pow(r, 0.2); });
    check("Johnson and Cook", JohnsonCook{.shear_modulus = G, .A = 1, .B = 2, .n = 0.4, .C = 0.05, .reference_rate = 1},
          rate,
          [](double e, double r) { return (1 + 2 * std::pow(e, 0.4)) * (1 + 0.05 * std::log(std::max(1.0, r))); });
    check("Zerilli and Armstrong",
          ZerilliArmstrong{.shear_modulus = G, .C0 = 0.2, .C1 = 2, .C3 = 0.00698, .C4 = 0.000415, .C5 = 1, .n = 0.3},
          rate, [](double e, double r) {
            return 0.2 + 2 * std::exp(293 * (0.000415 * std::log(r) - 0.00698)) + std::pow(e, 0.3);
          });
  }
}

TEST_CASE("plastic bending: the limit loads of a cantilever and of a beam with both ends clamped") {
  for (const auto& [cells, layers] : {std::pair<Index, Index>{10, 1}, {20, 1}, {20, 2}}) {
    CAPTURE(cells, layers);
    CHECK(limit_load(cells, layers, true, 2) == Approx(1).epsilon(0.04));  // seen: .98, .97, 1.00
    CHECK(limit_load(cells, layers, false, 0.4) ==
          Approx(1).epsilon(0.13));  // seen: 1.06, 1.06, 1.12, of membranes too
  }
}
