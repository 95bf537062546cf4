#pragma once
#include <cmath>

namespace strike::testing {

/// Steady plane shock from rest at p = 0 behind which matter moves at v: the jump conditions
///   p = rho0 U v,   mu/(1 + mu) = v/U,   E = p mu/(2 (1 + mu)).
struct Shock {
  double mu, pressure, speed, energy;
};

/// The state that an equation of state reaches, by bisection: v^2 = p mu/(rho0 (1 + mu)) grows with mu up to the limit.
template <class Eos>
Shock shock(const Eos& eos, double v, double limit = 1) {
  const auto on_hugoniot = [&](double mu) -> Shock {
    const double half_eta = 0.5 * mu / (1 + mu);
    double B = 0;
    if constexpr (requires { eos.B(mu); }) B = eos.B(mu);
    const double p = eos.A(mu) / (1 - B * half_eta);
    return {mu, p, std::sqrt(p / (2 * half_eta) / eos.density), p * half_eta};
  };
  double lower = 0, upper = limit;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (lower + upper);
    const Shock s = on_hugoniot(middle);
    (2 * s.energy / eos.density < v * v ? lower : upper) = middle;
  }
  return on_hugoniot(lower);
}

/// -J dp/dJ at constant entropy, dE = -p dJ, by a difference over a small piece of the isentrope (error h^2).
template <class Eos>
double isentropic_bulk_modulus(const Eos& eos, double J, double E) {
  const auto pressure = [&](double volume, double energy) {
    double p = eos.A(1 / volume - 1);
    if constexpr (requires { eos.B(0.0); }) p += eos.B(1 / volume - 1) * energy;
    return p;
  };
  const double h = 1e-5 * J, p = pressure(J, E);
  const auto along = [&](double dv) {  // midpoint rule
    return pressure(J + dv, E - dv * pressure(J + dv / 2, E - p * dv / 2));
  };
  return -J * (along(h) - along(-h)) / (2 * h);
}

}  // namespace strike::testing
