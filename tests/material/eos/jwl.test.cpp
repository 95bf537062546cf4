#include <cmath>

#include <strike/material/eos/eos.hpp>
#include <strike/material/eos/jwl.hpp>
#include <strike/material/fluid.hpp>

#include "support/catch.hpp"
#include "support/shock.hpp"

using namespace strike;

static_assert(ThermalEquationOfState<Jwl>);

namespace {

/// Of Dobratz and Crawford (1985), with the D and p_CJ that stand beside them.
struct Row {
  Jwl products;
  double D, p_CJ;
};
const Row tnt{{.density = 1630,
               .A_products = 371.2e9,
               .B_products = 3.231e9,
               .R1 = 4.15,
               .R2 = .95,
               .omega = .30,
               .initial_energy = 7.0e9},
              6930,
              21.0e9};

}  // namespace

TEST_CASE("JWL: the detonation velocity and pressure of TNT follow from its other constants") {
  // Chapman and Jouguet: the slowest wave, rho0 D^2 = p/(1 - V), on the Hugoniot of the products, E = E0 + p (1 - V)/2
  const auto& [eos, D, p_CJ] = tnt;
  double slowest = 1e300, p_there = 0, V_there = 0;
  for (double V = .5; V < .99; V += 1e-5) {
    const double mu = 1 / V - 1;
    const double p = (eos.A(mu) + eos.B(mu) * eos.initial_energy) / (1 - eos.B(mu) * .5 * (1 - V));
    if (p / (1 - V) < slowest) slowest = p / (1 - V), p_there = p, V_there = V;
  }
  CHECK(std::sqrt(slowest / eos.density) == Approx(D).epsilon(2e-4));  // half a unit of the table's last digit
  CHECK(p_there == Approx(p_CJ).epsilon(2.5e-3));
  // there the wave is sonic: rho0 D^2 V = K
  const double E = eos.initial_energy + .5 * p_there * (1 - V_there);
  const EosState<Jwl, double> state{E};
  CHECK(bulk_modulus(eos, state, V_there, p_there) / V_there == Approx(slowest).epsilon(1e-3));
  CHECK(bulk_modulus(eos, state, V_there, p_there) ==
        Approx(testing::isentropic_bulk_modulus(eos, V_there, E)).epsilon(1e-7));
}

TEST_CASE("JWL: products expand along A exp(-R1 V) + B exp(-R2 V) + C V^(-1 - w)") {
  const Fluid fluid{tnt.products};
  const Jwl& eos = fluid.eos;
  const auto isentrope = [&](double V, double C) {
    return eos.A_products * std::exp(-eos.R1 * V) + eos.B_products * std::exp(-eos.R2 * V) +
           C * std::pow(V, -1 - eos.omega);
  };
  Fluid<Jwl>::State<double> state;
  fluid.begin(state);
  CHECK(state.pressure == Approx(eos.A(0.0) + .30 * 7e9).epsilon(1e-14));
  const double C = state.pressure - isentrope(1, 0);
  const int steps = 2000;
  const double theta = std::log(7) / steps;
  double V = 1;
  for (int i = 0; i < steps; ++i) {
    V *= (1 + theta / 2) / (1 - theta / 2);  // so that theta is the strain at mid-step
    fluid.stress(state, {SymmetricTensor<double>::isotropic(theta / 3), V}, 1.0);
    CHECK(state.pressure == Approx(isentrope(V, C)).epsilon(2e-6));  // a step of 1e-3, squared
  }
  CHECK(V == Approx(7).epsilon(1e-6));
}
