#include <algorithm>
#include <cmath>
#include <numeric>

#include <strike/element/hex8.hpp>
#include <strike/load/support.hpp>
#include <strike/material/eos/jwl.hpp>
#include <strike/material/explosive.hpp>

#include "problems/column.hpp"
#include "support/catch.hpp"
#include "support/tnt.hpp"

using namespace strike;

TEST_CASE("a slab of TNT detonates from its rigid end: front, pressure behind it, and the state at rest in its wake") {
  const Jwl eos = tnt::products;
  const double D = tnt::detonation_velocity, p_CJ = tnt::pressure_CJ, u_CJ = p_CJ / (eos.density * D),
               V_CJ = 1 - u_CJ / D;
  // Behind the front matter expands along the isentrope, u = u_CJ - int sqrt(-p'/rho0) dV, until it is at rest (Taylor
  // 1950).
  const auto on_isentrope = [&](double V) {
    const auto cold = [&](double v) {
      return eos.A_products * std::exp(-eos.R1 * v) + eos.B_products * std::exp(-eos.R2 * v);
    };
    return cold(V) + (p_CJ - cold(V_CJ)) * std::pow(V / V_CJ, -1 - eos.omega);
  };
  double V = V_CJ;
  for (double u = u_CJ, dV = 1e-5; u > 0; V += dV)
    u -= std::sqrt((on_isentrope(V) - on_isentrope(V + dV)) / dV / eos.density) * dV;
  const double p_rest = on_isentrope(V);

  const Index N = 200;
  const double h = 1e-3;
  const Mesh mesh = column(N, N * h, h);
  const std::vector<Index> all = all_nodes(mesh.nodes);
  const Explosive tnt{eos,
                      DetonationPlane{{0, 0, 0}, {1, 0, 0}},
                      {.detonation_velocity = D, .front_width = 4 * h, .pressure_CJ = p_CJ}};
  Explicit run{Scene{mesh.nodes, Part{Hex8{}, tnt, mesh.hexahedra}, Symmetry{Axis::x, section(mesh, 0)},
                     Symmetry{Axis::y, all}, Symmetry{Axis::z, all}}};
  const auto pressure = [&] { return run.part<0>().field([](const auto& state) { return state.pressure; }); };
  double at_80 = 0, at_160 = 0, highest = 0;  // when the front, half way up, comes by
  while (at_160 == 0) {
    run.step();
    const std::vector<double> p = pressure();
    if (at_80 == 0 && p[80] > .5 * p_CJ) at_80 = run.time();
    if (p[160] > .5 * p_CJ) at_160 = run.time();
    REQUIRE(run.time() < N * h / D);
    if (at_80 > 0) highest = std::max(highest, *std::max_element(p.begin(), p.end()));
  }
  const std::vector<double> p = pressure();
  CHECK(80 * h / (at_160 - at_80) == Approx(D).epsilon(.01));
  CHECK(highest < p_CJ);
  CHECK(highest >
        .95 * p_CJ);  // behind the front it falls at once: what its width cuts off, 8 % on half as many elements
  CHECK(std::accumulate(&p[20], &p[60], 0.0) / 40 == Approx(p_rest).epsilon(.01));
  CHECK(std::abs(run.energy().error()) < 5e-3);
}
