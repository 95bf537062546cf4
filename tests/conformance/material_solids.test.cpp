// The laws of the Material concept, for the solids of the library and a flow law of this test.
#include <strike/material.hpp>

#include "conformance/material.hpp"

using namespace strike;
using testing::conforms;

namespace {

constexpr double density = 8930, G = 43.3e9, Y = 400e6;
constexpr LinearEos linear{.density = density, .bulk_modulus = 130e9};
constexpr PolynomialEos hot{
    .density = density, .C1 = 130e9, .C2 = 120e9, .C3 = 100e9, .C4 = 2, .C5 = 2, .pressure_cutoff = -2e9};
constexpr GruneisenEos copper{.density = density, .sound_speed = 3940, .S1 = 1.489, .gamma = 1.99, .a = .47};

constexpr VonMises von_mises{.shear_modulus = G, .yield_stress = Y, .hardening_modulus = 100e6};
constexpr RateVonMises rate_von_mises{
    .shear_modulus = G, .yield_stress = Y, .hardening_modulus = 1e9, .rate_factor = .111, .rate_exponent = .25};
constexpr JohnsonCook johnson_cook{.shear_modulus = G,
                                   .A = 90e6,
                                   .B = 292e6,
                                   .n = .31,
                                   .C = .025,
                                   .m = .8,
                                   .initial_temperature = 294,
                                   .melting_temperature = 1356,
                                   .heating = 2.6e-7};

/// A flow law of a user's own, as short as they come.
struct Voce {
  double shear_modulus, Y, Q, b;
  template <class T>
  T flow_stress(const T& e) const {
    return Y + Q * (1.0 - exp(-b * e));
  }
};

}  // namespace

TEST_CASE("conformance: Elastic") {
  conforms(Elastic{.reference_density = density, .youngs_modulus = 117e9, .poissons_ratio = .35});
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
