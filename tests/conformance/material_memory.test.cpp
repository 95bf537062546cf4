// The laws of the Material concept, for strengths that remember more than a plastic strain.
#include <strike/material.hpp>

#include "conformance/laws.hpp"
#include "conformance/material.hpp"

using namespace strike;
using namespace strike::testing::laws;
using testing::conforms;

namespace {

constexpr Prony<2> prony{.shear_modulus = G, .terms = {{.share = .7, .time = 1e-5}, {.share = .2, .time = 1e-7}}};
constexpr KinematicHardening kinematic{
    .shear_modulus = G, .yield_stress = Y, .hardening_modulus = 10e9, .isotropic_share = .3};

}  // namespace

TEST_CASE("conformance: Solid of LinearEos and Prony") { conforms(Solid{linear, prony}); }
TEST_CASE("conformance: Solid of LinearEos, KinematicHardening and FailureStrain") {
  conforms(Solid{linear, kinematic, FailureStrain{.failure_strain = 1}});
}
TEST_CASE("conformance: ZeroNormalStress of LinearEos and Prony") { conforms(ZeroNormalStress{Solid{linear, prony}}); }
TEST_CASE("conformance: ZeroNormalStress of LinearEos and KinematicHardening") {
  conforms(ZeroNormalStress{Solid{linear, kinematic}});
}
