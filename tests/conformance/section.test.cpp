#include "conformance/section.hpp"

#include <strike/material.hpp>
#include <strike/section.hpp>

#include "support/plies.hpp"

using namespace strike;
using testing::conforms;

namespace {

const PlaneStress glass{Elastic{.density = 2500, .youngs_modulus = 70e9, .poissons_ratio = .22}};
const PlaneStress interlayer{Elastic{.density = 1070, .youngs_modulus = 70e6, .poissons_ratio = .45}};
const PlaneStress aluminium{Solid{LinearEos{.density = 2700, .bulk_modulus = 71e9},
                                  VonMises{.shear_modulus = 27e9, .yield_stress = 300e6, .hardening_modulus = 1e9}}};
const PlaneStress brittle{Solid{LinearEos{.density = 2500, .bulk_modulus = 42e9},
                                ElasticStrength{.shear_modulus = 29e9}, UltimateStress{200e6}}};

}  // namespace

TEST_CASE("conformance: a section of one elastic layer") { conforms(Homogeneous{glass, 3e-3}); }
TEST_CASE("conformance: a section of one plastic layer") { conforms(Homogeneous{aluminium, 3e-3, Gauss<4>{}}); }
TEST_CASE("conformance: a section off the surface of its nodes") {
  conforms(Homogeneous{glass, 3e-3, Offset{2e-3}, FiveSixthsShear{}});
}
TEST_CASE("conformance: a section of stiff and soft layers") {
  conforms(Layered{Layer{glass, 3e-3}, Layer{interlayer, .76e-3, Simpson<3>{}}, Layer{aluminium, 2e-3},
                   EffectiveShear{.length = .3}});
}
TEST_CASE("conformance: a section of plies") { conforms(Layered{Plies{Layer{glass, 1e-3, Gauss<2>{}}, 7}}); }
TEST_CASE("conformance: a section of any solid") {
  const ZeroNormalStress copper{Solid{GruneisenEos{.density = 8930, .sound_speed = 3940, .S1 = 1.489, .gamma = 1.99},
                                      VonMises{.shear_modulus = 43.3e9, .yield_stress = 400e6}}};
  conforms(Layered{Layer{copper, 1e-3}, Layer{glass, 1e-3, Gauss<3>{}}});
}
TEST_CASE("conformance: a section whose layers fail") {
  conforms(Layered{Layer{brittle, 1e-3}, Layer{brittle, 2e-3, Simpson<3>{}}});
}
TEST_CASE("conformance: a section whose shear follows its layers") {
  conforms(Layered{Layer{aluminium, 1e-3}, Layer{glass, 2e-3}, InstantaneousShear{}});
}
TEST_CASE("conformance: sections of fibres") {
  conforms(testing::of_four(testing::carbon, .125, {0, 45, -45, 90}));
  conforms(testing::of_four(FailingPly{testing::carbon, testing::carbon_hashin}, .125, {0, 90, 30, 10}));
  conforms(Layered{Layer{testing::carbon, .3}, Layer{PlaneStress{Elastic{1e-9, 3e3, .4}}, .1},
                   FibreDirection{{0, 1, 0}}, FiveSixthsShear{}, Offset{.2}});
}
