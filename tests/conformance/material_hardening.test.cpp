// The laws of the Material concept, for laws of hardening with criteria of failure, in solids and in plane stress.
#include <strike/material.hpp>

#include "conformance/laws.hpp"
#include "conformance/material.hpp"

using namespace strike;
using namespace strike::testing::laws;
using testing::conforms;

static_assert(SolidMaterial<Solid<LinearEos, ZerilliArmstrong, JohnsonCookFailure>>);
static_assert(PlaneMaterial<PlaneStress<Solid<LinearEos, TabulatedHardening, TulerButcher>>>);

// What is remembered: only what a law asks for. In numbers:
template <class M>
constexpr std::size_t numbers = sizeof(typename M::template State<double>) / sizeof(double);
static_assert(numbers<Solid<LinearEos, PowerHardening, PrincipalStress>> == 8);          // a flag
static_assert(numbers<Solid<LinearEos, TabulatedHardening, TulerButcher>> == 9);         // and damage
static_assert(numbers<Solid<LinearEos, ZerilliArmstrong, JohnsonCookFailure>> == 10);    // and temperature
static_assert(numbers<Solid<LinearEos, VonMises, BecomesFluid<PrincipalStress>>> == 8);  // a flag of another name
static_assert(numbers<Solid<LinearEos, VonMises, BecomesFluid<TulerButcher>>> == 9);
static_assert(numbers<PlaneStress<Solid<LinearEos, PowerHardening, PrincipalStress>>> == 5);

TEST_CASE("conformance: Solid of CowperSymonds and PowerHardening") {
  conforms(Solid{linear, CowperSymonds{power, 1e5, 4}});
}
TEST_CASE("conformance: Solid of TabulatedRates") { conforms(Solid{linear, rates}); }
TEST_CASE("conformance: Solid of ZerilliArmstrong and JohnsonCookFailure") {
  conforms(Solid{linear, zerilli_armstrong, damage});
}
TEST_CASE("conformance: Solid of ElasticStrength and TulerButcher") {
  conforms(Solid{linear, elastic_strength, delayed});
}
TEST_CASE("conformance: PlaneStress of ElasticStrength and PrincipalStress") {
  conforms(PlaneStress{Solid{linear, elastic_strength, brittle}});
}
TEST_CASE("conformance: PlaneStress of TabulatedHardening and JohnsonCookFailure") {
  conforms(PlaneStress{Solid{linear, table, damage}});
}
