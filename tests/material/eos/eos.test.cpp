#include <random>
#include <string>

#include <strike/material/eos/eos.hpp>
#include <strike/material/eos/gruneisen.hpp>
#include <strike/material/eos/linear.hpp>
#include <strike/material/eos/polynomial.hpp>
#include <strike/material/material.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {
struct WithoutDensity {
  double A(double mu) const { return mu; }
};
struct Murnaghan {  // an equation of a user's own, complete with its one formula
  double density, K, n;
  template <class T>
  T A(const T& mu) const {
    return K / n * (pow(1.0 + mu, T(n)) - 1.0);
  }
};
struct InDouble {
  double density;
  double A(double mu) const { return mu; }
};
struct BOfEnergy : Murnaghan {
  template <class T>
  T B(const T& mu, const T& E) const {
    return mu * E;
  }
};
struct EnergyAlone : Murnaghan {
  double initial_energy;
};
struct Tait : Murnaghan {
  double B;  // a parameter, no function
};
}  // namespace

using detail::EosFlaw;
static_assert(detail::eos_flaw<Murnaghan>() == EosFlaw::none && detail::eos_flaw<Tait>() == EosFlaw::none);
static_assert(detail::eos_flaw<PolynomialEos>() == EosFlaw::none && detail::eos_flaw<int>() == EosFlaw::absent);
static_assert(detail::eos_flaw<WithoutDensity>() == EosFlaw::absent);
static_assert(detail::eos_flaw<InDouble>() == EosFlaw::A_in_double);
static_assert(detail::eos_flaw<BOfEnergy>() == EosFlaw::B && detail::eos_flaw<EnergyAlone>() == EosFlaw::energy);

static_assert(EquationOfState<Murnaghan> && !ThermalEquationOfState<Murnaghan>);
static_assert(!EquationOfState<int> && !EquationOfState<std::string> && !EquationOfState<WithoutDensity>);
static_assert(!ThermalEquationOfState<WithoutDensity>);

// Only what stands in the formula is remembered.
static_assert(std::is_empty_v<EosState<LinearEos, double>> && std::is_empty_v<EosState<Murnaghan, double>>);
static_assert(sizeof(EosState<PolynomialEos, double>) == sizeof(double));

TEST_CASE("EOS: the energy update closes p = A + B E and the balance of energy, exactly") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(-1, 1);
  const PolynomialEos eos{.density = 1, .C0 = .1, .C1 = 1, .C2 = 2, .C3 = 3, .C4 = 1.5, .C5 = 1.7, .C6 = .3};
  for (int i = 0; i < 100; ++i) {
    EosState<PolynomialEos, double> state{unit(random)};
    const double E0 = state.internal_energy, p0 = unit(random), J = 1 + 0.5 * unit(random), dv = 0.1 * unit(random),
                 work = unit(random);
    const double p = advance_pressure(eos, state, J, dv, p0, work), mu = 1 / J - 1;
    CHECK(p == Approx(eos.A(mu) + eos.B(mu) * state.internal_energy).epsilon(1e-13));
    CHECK(state.internal_energy == Approx(E0 + work - 0.5 * (p0 + p) * dv).epsilon(1e-13));
  }
}

TEST_CASE("EOS: where the cut-off holds the pressure, the energy knows that pressure") {
  const GruneisenEos eos{
      .density = 1, .sound_speed = 1, .S1 = 1.5, .gamma = 2, .initial_energy = .01, .pressure_cutoff = -.1};
  EosState<GruneisenEos, double> state;
  const double p0 = begin_eos(eos, state), p = advance_pressure(eos, state, 1.5, .2, p0, .03);
  CHECK(p == -.1);
  CHECK(state.internal_energy == Approx(.01 + .03 - .5 * (.02 - .1) * .2).epsilon(1e-14));
}

TEST_CASE("EOS: a user's equation needs no derivative, and Murnaghan's bulk modulus is K (1 + mu)^n") {
  const Murnaghan eos{.density = 1, .K = 3, .n = 4};
  struct {
  } nothing;
  for (const double J : {0.5, 1.0, 1.5})
    CHECK(bulk_modulus(eos, nothing, J, eos.A(1 / J - 1)) == Approx(3 * std::pow(J, -4)).epsilon(1e-14));
}

TEST_CASE("EOS: the change of volume from the strain at mid-step") {
  for (const double theta : {-1.0, -0.1, 1e-9, 0.1, 1.0}) {
    const double old = 1.3, now = old * (1 + theta / 2) / (1 - theta / 2);  // theta = (new - old)/mean, along one axis
    CHECK(volume_increment(now, theta) == Approx(now - old).margin(1e-15).epsilon(1e-14));
    const double small = theta / 100, log = old * std::exp(small);
    CHECK(volume_increment(log, small) ==
          Approx(log - old).margin(1e-15).epsilon(small * small / 10));  // third order: /12
  }
}
