// The laws of the Material concept, for the solids of the library and a flow law of this test.
#include <strike/material.hpp>

#include "conformance/laws.hpp"
#include "conformance/material.hpp"

using namespace strike;
using namespace strike::testing::laws;
using testing::conforms;

TEST_CASE("conformance: Elastic") {
  conforms(Elastic{.density = density, .youngs_modulus = 117e9, .poissons_ratio = .35});
}
TEST_CASE("conformance: Solid of LinearEos and ElasticStrength") {
  conforms(Solid{linear, ElasticStrength{.shear_modulus = G}});
}
TEST_CASE("conformance: Solid of LinearEos and VonMises") { conforms(Solid{linear, von_mises}); }
TEST_CASE("conformance: Solid of LinearEos and RateVonMises") { conforms(Solid{linear, rate_von_mises}); }
TEST_CASE("conformance: Solid of LinearEos, VonMises and UltimateStress") {
  conforms(Solid{linear, von_mises, UltimateStress{.ultimate_stress = 450e6}});
}
TEST_CASE("conformance: Solid of PolynomialEos, VonMises and FailureStrain") {
  conforms(Solid{hot, von_mises, FailureStrain{.failure_strain = 1}});
}
TEST_CASE("conformance: Solid of GruneisenEos and JohnsonCook") { conforms(Solid{copper, johnson_cook}); }
TEST_CASE("conformance: Solid of LinearEos and a law of this test") {
  conforms(Solid{linear, Voce{G, 100e6, 200e6, 10}});
}
TEST_CASE("conformance: Solid of LinearEos and Sensitive") {
  const std::array p{Dual<double, 2>::variable(von_mises.yield_stress, 0)};
  conforms(Solid{linear, Sensitive{von_mises, p, &VonMises::yield_stress}});
}
