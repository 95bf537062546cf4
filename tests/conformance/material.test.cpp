#include "conformance/material.hpp"

#include <string>

#include <strike/material.hpp>

using namespace strike;
using testing::conforms;

namespace {

constexpr LinearEos linear{.density = 1000, .bulk_modulus = 2.2e9};
constexpr CubicEos bird_eos{.density = 938, .C1 = 2.06e9, .C2 = 6.19e9, .C3 = 10.3e9};
constexpr PolynomialEos water{
    .density = 1000, .C1 = 2.19e9, .C2 = 9.224e9, .C3 = 8.767e9, .C4 = .4934, .C5 = 1.3937, .pressure_cutoff = -1e7};
constexpr GruneisenEos copper{.density = 8930, .sound_speed = 3940, .S1 = 1.489, .gamma = 1.99, .a = .47};
constexpr IdealGas air{.density = 1.2, .gamma = 1.4, .initial_energy = 2.5e5};

/// A material of a user's own from the ground up: Maxwell's fluid, elastic fast and viscous slowly.
struct Maxwell {
  double bulk_modulus, shear_modulus, relaxation_time;

  using Kinematics = SolidKinematics;
  template <class T>
  struct State {
    SymmetricTensor<T> s{};
    T p{};
    auto spatial_tensors() { return std::tie(s); }
  };

  double density() const { return 1000; }
  template <class T>
  SymmetricTensor<T> stress(State<T>& state, const SolidKinematics::Rate<T>& rate, double dt) const {
    const double decay = 1 / (1 + dt / relaxation_time);
    state.s = T(decay) * (state.s + T(2 * shear_modulus * dt) * deviator(rate.rate_of_deformation));
    state.p = bulk_modulus * (1.0 / rate.relative_volume - 1.0);
    return stress(std::as_const(state));
  }
  template <class T>
  SymmetricTensor<T> stress(const State<T>& state) const {
    return state.s - SymmetricTensor<T>::isotropic(state.p);
  }
  template <class T>
  Moduli<T> moduli(const State<T>&, const SolidKinematics::Rate<T>& rate) const {
    return {bulk_modulus / rate.relative_volume, T(shear_modulus)};
  }
};

// Materials that break one law each.
struct NeverTurned : Maxwell {
  template <class T>
  struct State : Maxwell::State<T> {
    void spatial_tensors() = delete;
  };
};
struct StifferThanItSays : Maxwell {
  template <class T>
  Moduli<T> moduli(const State<T>& state, const SolidKinematics::Rate<T>& rate) const {
    return {0.9 * Maxwell::moduli(state, rate).bulk, T(0.9 * shear_modulus)};
  }
};
struct GrowsAtRest : Maxwell {
  using Maxwell::stress;
  template <class T>
  SymmetricTensor<T> stress(State<T>& state, const SolidKinematics::Rate<T>& rate, double dt) const {
    Maxwell::stress(state, rate, dt);
    state.s = T(1 + 2 * dt / relaxation_time) * state.s;
    return stress(std::as_const(state));
  }
};

struct WithoutPoint : Elastic {
  bool intact() const { return true; }
};
struct OfState : Elastic {
  template <class T>
  T viscosity(const State<T>&) const {
    return T(1.0);
  }
};
struct WithNumber : Elastic {
  int warning() const { return 0; }
};
struct GivesState : Elastic {
  template <class T>
  State<T> begin() const {
    return {};
  }
};
struct Fixed : Elastic {
  template <class T>
  struct State : Elastic::State<T> {
    auto spatial_tensors() const { return std::tie(this->stress); }
  };
};
template <class M>
struct Wrapped : M {
  std::string warning() const
    requires requires(M m) { m.warning(); }
  {
    return M::warning();
  }
  template <class T>
    requires requires(M m, typename M::template State<T> state) { m.intact(state); }
  T intact(const typename M::template State<T>& state) const {
    return M::intact(state);
  }
};
struct WithoutModuli : Maxwell {
  void moduli() const {}
};
struct WithoutState {
  using Kinematics = SolidKinematics;
  double density() const { return 1; }
};

}  // namespace

// The concept, in both directions.
static_assert(Material<Elastic> && SolidMaterial<Elastic>);
static_assert(SolidMaterial<Solid<LinearEos, VonMises>> && SolidMaterial<Fluid<CubicEos>> && SolidMaterial<Maxwell>);
static_assert(!Material<int> && !Material<std::string> && !Material<LinearEos> && !Material<VonMises>);
static_assert(!Material<WithoutState> && !Material<WithoutModuli>);
static_assert(Material<Maxwell, Pack<double>>);

// Materials with something nearly right.
using detail::MaterialFlaw;
static_assert(detail::material_flaw<Maxwell>() == MaterialFlaw::none);
static_assert(detail::material_flaw<Elastic>() == MaterialFlaw::none);
static_assert(detail::material_flaw<WithoutPoint>() == MaterialFlaw::intact);
static_assert(detail::material_flaw<OfState>() == MaterialFlaw::viscosity);
static_assert(detail::material_flaw<WithNumber>() == MaterialFlaw::warning);
static_assert(detail::material_flaw<GivesState>() == MaterialFlaw::begin);
static_assert(detail::material_flaw<Fixed>() == MaterialFlaw::tensors);
static_assert(detail::material_flaw<Wrapped<Maxwell>>() == MaterialFlaw::none);  // what its `requires` takes away

// What is remembered: only what a law asks for. In numbers:
template <class M>
constexpr std::size_t numbers = sizeof(typename M::template State<double>) / sizeof(double);
static_assert(numbers<Elastic> == 6);                                     // stress
static_assert(numbers<Solid<LinearEos, ElasticStrength>> == 6);           // stress; no energy, no plastic strain
static_assert(numbers<Solid<LinearEos, VonMises>> == 7);                  // and plastic strain
static_assert(numbers<Solid<LinearEos, RateVonMises>> == 7);              // the rate is not remembered
static_assert(numbers<Solid<PolynomialEos, VonMises>> == 8);              // and energy
static_assert(numbers<Solid<LinearEos, JohnsonCook>> == 8);               // and temperature
static_assert(numbers<Solid<LinearEos, VonMises, UltimateStress>> == 8);  // and whether it is intact
static_assert(numbers<Solid<GruneisenEos, JohnsonCook, FailureStrain>> == 10);
static_assert(numbers<Fluid<LinearEos>> == 1);            // pressure; no tensor
static_assert(numbers<Fluid<CubicEos, Newtonian>> == 1);  // no memory of the viscous stress
static_assert(numbers<Fluid<IdealGas>> == 2);             // and energy
static_assert(sizeof(Solid<LinearEos, VonMises>::State<Pack<float, 16>>) == 7 * sizeof(Pack<float, 16>));

// Absent physics takes no place in the material either.
static_assert(sizeof(Solid<LinearEos, VonMises>) == 5 * sizeof(double));
static_assert(sizeof(Fluid<LinearEos>) == 2 * sizeof(double));

TEST_CASE("conformance: Fluid of LinearEos") { conforms(Fluid{linear}); }
TEST_CASE("conformance: Fluid of CubicEos and Newtonian") { conforms(Fluid{bird_eos, Newtonian{.viscosity = 100}}); }
TEST_CASE("conformance: Fluid of PolynomialEos") { conforms(Fluid{water}); }
TEST_CASE("conformance: Fluid of TabulatedEos") {
  conforms(Fluid{TabulatedEos{1000, {{-.4, 4e9, .3}, {-.1, .4e9, .4}, {0, 0, .5}, {.3, -.5e9, .3}}}});
}
TEST_CASE("conformance: Fluid of GruneisenEos") { conforms(Fluid{copper}); }
TEST_CASE("conformance: Fluid of IdealGas and Newtonian") { conforms(Fluid{air, Newtonian{.viscosity = 1}}); }
TEST_CASE("conformance: a material of this test") { conforms(Maxwell{2e9, 1e9, 1e-5}); }

TEST_CASE("conformance: a stress that is never turned is found", "[!shouldfail]") {
  testing::is_frame_indifferent(NeverTurned{{2e9, 1e9, 1e-5}}, {});
}
TEST_CASE("conformance: a material stiffer than its moduli is found", "[!shouldfail]") {
  testing::bounds_its_tangent(StifferThanItSays{{2e9, 1e9, 1e-5}}, {});
}
TEST_CASE("conformance: a stress that grows at rest is found", "[!shouldfail]") {
  testing::rests(GrowsAtRest{{2e9, 1e9, 1e-5}}, {});
}
TEST_CASE("conformance: energy from a closed cycle is found", "[!shouldfail]") {
  testing::gives_no_energy(GrowsAtRest{{2e9, 1e9, 1e-5}}, {});
}
