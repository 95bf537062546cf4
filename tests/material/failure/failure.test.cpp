#include <cmath>
#include <limits>

#include <strike/material/eos/ideal_gas.hpp>
#include <strike/material/eos/linear.hpp>
#include <strike/material/eos/polynomial.hpp>
#include <strike/material/failure/failure.hpp>
#include <strike/material/failure/johnson_cook_failure.hpp>
#include <strike/material/failure/principal_stress.hpp>
#include <strike/material/failure/tuler_butcher.hpp>
#include <strike/material/solid.hpp>
#include <strike/material/strength/johnson_cook.hpp>
#include <strike/material/strength/prony.hpp>
#include <strike/material/strength/von_mises.hpp>
#include <strike/verify/material_point.hpp>

#include "support/catch.hpp"

using namespace strike;
using namespace strike::verify;

namespace {

constexpr LinearEos eos{.density = 7850, .bulk_modulus = 160e9};
constexpr VonMises strength{.shear_modulus = 80e9, .yield_stress = 400e6, .hardening_modulus = 1e9};

template <class M>
concept CanFail = requires(const M m, const typename M::template State<double> state) { m.intact(state); };

}  // namespace

static_assert(CanFail<Solid<LinearEos, VonMises, UltimateStress>> &&
              CanFail<Solid<LinearEos, VonMises, FailureStrain>>);
static_assert(!CanFail<Solid<LinearEos, VonMises>> && !CanFail<Solid<LinearEos, VonMises, NoFailure>>);

namespace {

struct Flag {
  template <class T>
  struct State {
    T intact{1.0};
  };
};
struct Fails : Flag {
  template <class T, class S>
  auto fails(const T& equivalent_stress, const S&) const {
    return equivalent_stress >= 1.0;
  }
};
struct Misspelt : Flag {
  template <class T, class S>
  auto fail(const T& equivalent_stress, const S&) const {
    return equivalent_stress >= 1.0;
  }
};
struct StressAlone : Flag {
  template <class T>
  auto fails(const T& equivalent_stress) const {
    return equivalent_stress >= 1.0;
  }
};
struct InDouble : Flag {
  template <class S>
  bool fails(double equivalent_stress, const S&) const {
    return equivalent_stress >= 1;
  }
};
struct WithoutFlag : Fails {
  template <class T>
  struct State {};
};
struct NeverGathers : Fails {
  template <class T>
  struct State : strike::detail::Intact<T>, strike::detail::Damage<T> {};
};
struct GathersWithoutStrain : NeverGathers {
  template <class T, class S>
  void accumulate(S& state, const T& equivalent_stress, double dt) const {
    state.damage += dt * equivalent_stress;
  }
};

template <class F>
constexpr auto flaw = strike::detail::failure_flaw<F>();
using strike::detail::FailureFlaw;

}  // namespace

static_assert(FailureCriterion<NoFailure> && FailureCriterion<UltimateStress> && FailureCriterion<FailureStrain> &&
              FailureCriterion<PrincipalStress> && FailureCriterion<TulerButcher> &&
              FailureCriterion<JohnsonCookFailure> && FailureCriterion<BecomesFluid<UltimateStress>> &&
              FailureCriterion<BecomesFluid<TulerButcher>> && FailureCriterion<Fails>);
static_assert(!FailureCriterion<int> && !FailureCriterion<VonMises> && !FailureCriterion<Prony<1>> &&
              !FailureCriterion<Flag> && !FailureCriterion<Misspelt> && !FailureCriterion<StressAlone> &&
              !FailureCriterion<WithoutFlag>);
static_assert(FailureCriterion<TulerButcher, Pack<double>> && !FailureCriterion<InDouble, Pack<double>>);
static_assert(flaw<NoFailure> == FailureFlaw::none && flaw<Fails> == FailureFlaw::none &&
              flaw<JohnsonCookFailure> == FailureFlaw::none && flaw<BecomesFluid<TulerButcher>> == FailureFlaw::none);
static_assert(flaw<int> == FailureFlaw::absent && flaw<Prony<1>> == FailureFlaw::absent);
static_assert(flaw<Misspelt> == FailureFlaw::fail && flaw<Flag> == FailureFlaw::fail);
static_assert(flaw<StressAlone> == FailureFlaw::fails && flaw<InDouble> == FailureFlaw::in_double);
static_assert(flaw<WithoutFlag> == FailureFlaw::flag);
static_assert(flaw<NeverGathers> == FailureFlaw::memory && flaw<GathersWithoutStrain> == FailureFlaw::accumulate);

TEST_CASE("failure: by ultimate stress, in the first step that reaches it, for ever") {
  const Solid solid{eos, strength, UltimateStress{.ultimate_stress = 500e6}};
  MaterialPoint point{solid};
  bool failed = false;
  point.run(simple_shear({.strain = 1, .steps = 1000}), [&](const auto& now) {
    const double without = 400e6 + 1e9 * now.state.equivalent_plastic_strain;
    if (!failed && now.state.intact == 0) {
      failed = true;
      CHECK(without >= 500e6);
      CHECK(without < 501e6);  // a step strains 1e-3/sqrt 3
    }
    CHECK(now.state.intact == (failed ? 0 : 1));
    CHECK((equivalent_stress(deviator(now.stress)) == 0) == failed);
  });
  REQUIRE(failed);

  const auto before = point.now();
  point.run(uniaxial_strain({.strain = -1, .steps = 10}) + uniaxial_strain({.strain = 2, .steps = 10}));
  CHECK(point.now().stress.matrix().norm() == 0);
  CHECK(point.now().work == before.work);
  CHECK(point.now().state.equivalent_plastic_strain == before.state.equivalent_plastic_strain);
  CHECK(point.now().relative_volume() == Approx(std::exp(1)).epsilon(1e-2));  // what is left still moves
}

TEST_CASE("failure: an elastic strength under its ultimate stress stays whole") {
  MaterialPoint point{Solid{eos, ElasticStrength{.shear_modulus = 80e9}, UltimateStress{.ultimate_stress = 500e6}}};
  const double strain = 500e6 / (std::sqrt(3) * 80e9);
  point.run(simple_shear({.strain = 0.999 * strain}));
  CHECK(point.now().state.intact == 1);
  point.run(simple_shear({.strain = 0.002 * strain}));
  CHECK(point.now().state.intact == 0);
}

TEST_CASE("failure: by plastic strain, and not by pressure") {
  const Solid solid{eos, strength, FailureStrain{.failure_strain = 0.2}};
  MaterialPoint pressed{solid};
  pressed.run(hydrostatic({.strain = -0.5}));
  CHECK(pressed.now().state.intact == 1);

  MaterialPoint point{solid};
  point.run(uniaxial_stress({.strain = 0.21, .steps = 1000}) + hold(1, 1));
  CHECK(point.now().state.intact == 0);
  CHECK(point.now().state.equivalent_plastic_strain == Approx(0.2).epsilon(1e-2));
  CHECK(point.now().stress.matrix().norm() == 0);
}

TEST_CASE("failure: what has failed keeps its energy, and no motion brings a number that is none") {
  const Solid gas_like{PolynomialEos{.density = 1, .C1 = 2, .C4 = .5, .C5 = .5, .initial_energy = 1},
                       VonMises{.shear_modulus = 1, .yield_stress = .1}, FailureStrain{.failure_strain = .1}};
  using State = decltype(gas_like)::State<double>;
  State state;
  gas_like.begin(state);
  for (int i = 0; i < 10; ++i) gas_like.stress(state, {{.xy = .1}, 1.0}, 1.0);
  REQUIRE(state.intact == 0);
  const double energy = state.internal_energy, strain = state.equivalent_plastic_strain;
  const double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  for (const double wild : {0.0, -1.0, 1e300, infinity, -infinity, nan}) {
    const SolidKinematics::Rate<double> rate{{wild, wild, wild, wild, wild, wild}, wild};
    CHECK(gas_like.stress(state, rate, 1.0).matrix().norm() == 0);
    CHECK(std::isfinite(gas_like.moduli(state, rate).wave()));
  }
  CHECK(state.internal_energy == energy);
  CHECK(state.equivalent_plastic_strain == strain);
  CHECK(state.intact == 0);
}

TEST_CASE("failure: each lane on its own") {
  const Solid solid{eos, strength, UltimateStress{.ultimate_stress = 450e6}};
  using P = Pack<double, 4>;
  decltype(solid)::State<P> state;
  for (int i = 0; i < 100; ++i)
    solid.stress(state, {{.xy = P::generate([](std::size_t l) { return 1e-3 * double(l); })}, P(1.0)}, 1.0);
  for (std::size_t l = 0; l < 4; ++l) {
    decltype(solid)::State<double> alone;
    for (int i = 0; i < 100; ++i) solid.stress(alone, {{.xy = 1e-3 * double(l)}, 1.0}, 1.0);
    CHECK(state.intact[l] == alone.intact);
    CHECK(state.stress.xy[l] == Approx(alone.stress.xy).epsilon(1e-12));
  }
  CHECK(state.intact[0] == 1);
  CHECK(state.intact[3] == 0);
}
