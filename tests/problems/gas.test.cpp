#include <cmath>

#include <strike/element/hex8.hpp>
#include <strike/load/prescribed_motion.hpp>
#include <strike/material/eos/ideal_gas.hpp>
#include <strike/material/fluid.hpp>
#include <strike/mesh/transform.hpp>

#include "problems/column.hpp"
#include "support/catch.hpp"

using namespace strike;

namespace {

constexpr double heat_ratio = 1.4;

Fluid<IdealGas> gas(double density, double pressure) {
  return Fluid{IdealGas{.density = density, .gamma = heat_ratio, .initial_energy = pressure / (heat_ratio - 1)}};
}

}  // namespace

// Sod (1978): gas at p = 1, rho = 1 beside gas at p = 0.1, rho = 0.125, at the time 0.2.
TEST_CASE("Sod's shock tube in 100 elements") {
  const Index N = 100;
  const double h = 1.0 / N, end = 0.2;
  const Mesh mesh = translated(column(N, 1, h), {-0.5, 0, 0});
  const std::vector<Index> all = all_nodes(mesh.nodes);
  const Cells<8> left(mesh.hexahedra.begin(), mesh.hexahedra.begin() + N / 2),
      right(mesh.hexahedra.begin() + N / 2, mesh.hexahedra.end());
  Explicit run{Scene{mesh.nodes, Part{Hex8{}, gas(1, 1), left}, Part{Hex8{}, gas(0.125, 0.1), right},
                     Symmetry{Axis::y, all}, Symmetry{Axis::z, all}, Symmetry{Axis::x, section(mesh, -0.5)},
                     Symmetry{Axis::x, section(mesh, 0.5)}}};
  run.until(end);

  // The exact solution (Toro 2009, section 4.2).
  const double p_star = 0.30313018, u_star = 0.92745262, rho_L = 0.42631943, rho_R = 0.26557371, shock = 1.75215573,
               tail = -0.070273, head = -1.183216, c = std::sqrt(heat_ratio);
  const auto density = [&](double x) {
    const double s = x / end;
    if (s < head) return 1.0;
    if (s < tail) return std::pow((2 - (heat_ratio - 1) * s / c) / (heat_ratio + 1), 2 / (heat_ratio - 1));
    return s < u_star ? rho_L : s < shock ? rho_R : 0.125;
  };
  std::vector<double> p = run.part<0>().field([](const auto& state) { return state.pressure; });
  for (const double q : run.item<1>().field([](const auto& state) { return state.pressure; })) p.push_back(q);

  // Means over the plateaus at both sides of the contact: at the left of the five elements next to it, for behind the
  // rarefaction, where viscosity is off, the start still rings; at the right of all up to the front of the shock.
  struct Plateau {
    double from, to, rho;
    double p_sum = 0, u_sum = 0, rho_sum = 0, count = 0;
  } left_plateau{u_star - 0.6, u_star, rho_L}, right_plateau{u_star + 0.15, shock - 0.15, rho_R};
  double L1 = 0;
  for (Index e = 0; e < N; ++e) {
    const double x0 = run.nodes().x(e).x(), x1 = run.nodes().x(e + 1).x(), x = 0.5 * (x0 + x1);
    const double rho = (e < N / 2 ? 1 : 0.125) * h / (x1 - x0);
    L1 += std::abs(rho - density(x)) * (x1 - x0);
    for (Plateau* plateau : {&left_plateau, &right_plateau})
      if (x > plateau->from * end && x < plateau->to * end) {
        plateau->p_sum += p[e], plateau->u_sum += 0.5 * (run.nodes().v(e).x() + run.nodes().v(e + 1).x());
        plateau->rho_sum += rho, plateau->count += 1;
      }
  }
  for (const Plateau& plateau : {left_plateau, right_plateau}) {
    REQUIRE(plateau.count >= 5);
    CHECK(plateau.p_sum / plateau.count == Approx(p_star).epsilon(0.01));
    CHECK(plateau.u_sum / plateau.count == Approx(u_star).epsilon(0.01));
    CHECK(plateau.rho_sum / plateau.count == Approx(plateau.rho).epsilon(0.01));
  }
  CHECK(L1 < 0.015);
  CHECK(std::abs(run.energy().error()) < 1e-3);
}

TEST_CASE("a gas that the driver compresses without a shock follows its isentrope") {
  const double mesh_volume = 1.0 / 16;
  const Mesh mesh = column(4, 1, 0.25);
  const std::vector<Index> all = all_nodes(mesh.nodes);
  // Smoothly to half the volume in 50 crossings of sound, so that hardly a wave is left.
  const double c = std::sqrt(heat_ratio), end = 50 / c;
  const auto displacement = [&](double t) {
    return -0.5 * std::pow(std::sin(1.5707963267948966 * std::min(1.0, t / end)), 2);
  };
  Explicit run{Scene{mesh.nodes,
                     Part{Hex8{ViscousHourglass{}, HughesWinget{}, NoBulkViscosity{}}, gas(1, 1), mesh.hexahedra},
                     Symmetry{Axis::y, all}, Symmetry{Axis::z, all}, Symmetry{Axis::x, section(mesh, 0)},
                     PrescribedDisplacement{Axis::x, section(mesh, 1), displacement}}};
  run.until(end);
  for (const double p : run.part<0>().field([](const auto& state) { return state.pressure; }))
    CHECK(p == Approx(2.639016).epsilon(1e-3));  // 2^gamma
  // The work p0 V0/(gamma - 1) (2^(gamma - 1) - 1), on top of the energy p0 V0/(gamma - 1) stored at the start.
  const double stored = mesh_volume / (heat_ratio - 1), work = stored * (std::pow(2, heat_ratio - 1) - 1);
  const Energy& energy = run.energy();
  CHECK(energy.initial == Approx(stored).epsilon(1e-6));
  CHECK(energy.external == Approx(work).epsilon(1e-4));
  CHECK(energy.internal - energy.initial == Approx(work).epsilon(1e-4));
}
