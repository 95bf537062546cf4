// The laws of the Material concept, for strengths that remember more than a plastic strain, and for burnt explosives.
#include <strike/material.hpp>

#include "conformance/laws.hpp"
#include "conformance/material.hpp"
#include "support/tnt.hpp"

using namespace strike;
using namespace strike::testing::laws;
using testing::conforms;

namespace {

constexpr Prony<2> prony{.shear_modulus = G, .terms = {{.share = .7, .time = 1e-5}, {.share = .2, .time = 1e-7}}};
constexpr KinematicHardening kinematic{
    .shear_modulus = G, .yield_stress = Y, .hardening_modulus = 10e9, .isotropic_share = .3};
constexpr Jwl products = tnt::products;

}  // namespace

// What is remembered, in numbers.
template <class M>
constexpr std::size_t numbers = sizeof(typename M::template State<double>) / sizeof(double);
static_assert(numbers<Solid<LinearEos, Prony<2>>> == 6 + 2 * 6);
static_assert(numbers<Solid<LinearEos, KinematicHardening>> == 6 + 1 + 6);
static_assert(numbers<Solid<LinearEos, MooneyRivlin>> == 6 + 6);
static_assert(numbers<ZeroNormalStress<Solid<LinearEos, Prony<1>>>> == 6 + 6 + 2);
static_assert(numbers<Fluid<Jwl>> == 2);
static_assert(numbers<Explosive<Jwl, DetonationPoint>> == 4);

TEST_CASE("conformance: Solid of LinearEos and Prony") { conforms(Solid{linear, prony}); }
TEST_CASE("conformance: Solid of LinearEos and MooneyRivlin") {
  conforms(Solid{linear, MooneyRivlin{.C10 = .3 * G, .C01 = .2 * G}});
}
TEST_CASE("conformance: Fluid of Jwl") { conforms(Fluid{products}); }
TEST_CASE("conformance: Solid of LinearEos, KinematicHardening and FailureStrain") {
  conforms(Solid{linear, kinematic, FailureStrain{.failure_strain = 1}});
}
TEST_CASE("conformance: ZeroNormalStress of LinearEos and Prony") { conforms(ZeroNormalStress{Solid{linear, prony}}); }
