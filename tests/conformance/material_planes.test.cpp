// The laws of the Material concept, for plane stress in closed form, by the strain across, and of a law of this test.
#include <type_traits>

#include <strike/material.hpp>

#include "conformance/laws.hpp"
#include "conformance/material.hpp"
#include "support/plies.hpp"

using namespace strike;
using namespace strike::testing::laws;
using testing::carbon, testing::carbon_chang, testing::carbon_hashin, testing::carbon_maximum;
using testing::conforms;

namespace {

constexpr CubicEos cubic{.density = density, .C1 = 130e9, .C2 = 120e9, .C3 = 100e9};

constexpr Elastic elastic{.density = density, .youngs_modulus = 117e9, .poissons_ratio = .35};
constexpr VonMises perfect{.shear_modulus = G, .yield_stress = Y};
constexpr VonMises softening{.shear_modulus = G, .yield_stress = Y, .hardening_modulus = -1e9};
constexpr Voce voce{G, 100e6, 200e6, 10};

/// A plane material of a user's own: fabric, which resists along its threads only, elastic.
struct Fabric {
  double stiffness, shear_stiffness;

  using Kinematics = PlaneStressKinematics;
  template <class T>
  struct State {
    PlaneTensor<T> stress{};
  };

  double density() const { return 1000; }
  template <class T>
  PlaneTensor<T> stress(State<T>& state, const PlaneStressKinematics::Rate<T>& rate, double dt) const {
    const PlaneTensor<T> d = T(dt) * rate.rate_of_deformation;
    state.stress += PlaneTensor<T>{stiffness * d.xx, stiffness * d.yy, 2.0 * shear_stiffness * d.xy};
    return state.stress;
  }
  template <class T>
  PlaneTensor<T> stress(const State<T>& state) const {
    return state.stress;
  }
  template <class T>
  PlaneModuli<T> moduli(const State<T>&, const PlaneStressKinematics::Rate<T>&) const {
    return {T(stiffness), T(shear_stiffness)};
  }
  /// d_zz of the step that changed the stress so, from which the thickness follows: here as of nu = 0.
  template <class T>
  T normal_rate(const State<T>&, const PlaneStressKinematics::Rate<T>&, double, const PlaneTensor<T>&) const {
    return T(0.0);
  }
};

}  // namespace

// The concept, in both directions.
static_assert(PlaneMaterial<PlaneStress<Elastic>> && PlaneMaterial<PlaneStress<Solid<LinearEos, VonMises>>>);
static_assert(PlaneMaterial<ZeroNormalStress<Elastic>> && PlaneMaterial<ZeroNormalStress<Solid<CubicEos, VonMises>>>);
static_assert(PlaneMaterial<Fabric> && PlaneMaterial<OrthotropicPly> && PlaneMaterial<FailingPly<Hashin>>);
static_assert(!PlaneMaterial<Elastic> && !PlaneMaterial<Solid<LinearEos, VonMises>> && !PlaneMaterial<int>);
static_assert(!SolidMaterial<PlaneStress<Elastic>> && !PlateSection<PlaneStress<Elastic>>);

// What is remembered: only what a law asks for. In numbers:
template <class M>
constexpr std::size_t numbers = sizeof(typename M::template State<double>) / sizeof(double);
static_assert(numbers<PlaneStress<Elastic>> == 3);  // stress
static_assert(numbers<PlaneStress<Solid<LinearEos, ElasticStrength>>> == 3);
static_assert(numbers<PlaneStress<Solid<LinearEos, VonMises>>> == 4);                 // and plastic strain
static_assert(numbers<PlaneStress<Solid<LinearEos, JohnsonCook>>> == 5);              // and temperature
static_assert(numbers<PlaneStress<Solid<LinearEos, VonMises, FailureStrain>>> == 5);  // and whether it is intact
static_assert(numbers<OrthotropicPly> == 3 && numbers<FailingPly<Hashin>> == 5);      // and of fibres and matrix
static_assert(numbers<ZeroNormalStress<Solid<LinearEos, VonMises>>> == 7 + 2);  // the solid's, volume and rate across
static_assert(sizeof(PlaneStress<Solid<LinearEos, VonMises>>) == sizeof(Solid<LinearEos, VonMises>));

TEST_CASE("conformance: PlaneStress of Elastic") { conforms(PlaneStress{elastic}); }
TEST_CASE("conformance: PlaneStress of ElasticStrength") { conforms(PlaneStress{Solid{linear, elastic_strength}}); }
TEST_CASE("conformance: PlaneStress of VonMises, perfectly plastic") { conforms(PlaneStress{Solid{linear, perfect}}); }
TEST_CASE("conformance: PlaneStress of VonMises") { conforms(PlaneStress{Solid{linear, von_mises}}); }
TEST_CASE("conformance: PlaneStress of VonMises that softens") { conforms(PlaneStress{Solid{linear, softening}}); }
TEST_CASE("conformance: PlaneStress of RateVonMises") { conforms(PlaneStress{Solid{linear, rate_von_mises}}); }
TEST_CASE("conformance: PlaneStress of JohnsonCook") { conforms(PlaneStress{Solid{linear, johnson_cook}}); }
TEST_CASE("conformance: PlaneStress of a law of this test") { conforms(PlaneStress{Solid{linear, voce}}); }
TEST_CASE("conformance: PlaneStress of VonMises and UltimateStress") {
  conforms(PlaneStress{Solid{linear, von_mises, UltimateStress{.ultimate_stress = 450e6}}});
}
TEST_CASE("conformance: PlaneStress of JohnsonCook and FailureStrain") {
  conforms(PlaneStress{Solid{linear, johnson_cook, FailureStrain{.failure_strain = 1}}});
}

TEST_CASE("conformance: ZeroNormalStress of Elastic") { conforms(ZeroNormalStress{elastic}); }
TEST_CASE("conformance: ZeroNormalStress of CubicEos and ElasticStrength") {
  conforms(ZeroNormalStress{Solid{cubic, elastic_strength}});
}
TEST_CASE("conformance: ZeroNormalStress of LinearEos and VonMises, perfectly plastic") {
  conforms(ZeroNormalStress{Solid{linear, perfect}});
}
TEST_CASE("conformance: ZeroNormalStress of LinearEos and RateVonMises") {
  conforms(ZeroNormalStress{Solid{linear, rate_von_mises}});
}
TEST_CASE("conformance: ZeroNormalStress of PolynomialEos, VonMises and FailureStrain") {
  conforms(ZeroNormalStress{Solid{hot, von_mises, FailureStrain{.failure_strain = 1}}});
}
TEST_CASE("conformance: ZeroNormalStress of GruneisenEos and JohnsonCook") {
  conforms(ZeroNormalStress{Solid{copper, johnson_cook}});
}
TEST_CASE("conformance: ZeroNormalStress of LinearEos and a law of this test") {
  conforms(ZeroNormalStress{Solid{linear, voce}});
}

TEST_CASE("conformance: a plane material of this test") { conforms(Fabric{50e9, 1e9}); }

TEST_CASE("conformance: OrthotropicPly") { conforms(carbon); }
TEST_CASE("conformance: FailingPly of MaximumStress") { conforms(FailingPly{carbon, carbon_maximum}); }
TEST_CASE("conformance: FailingPly of Hashin") { conforms(FailingPly{carbon, carbon_hashin}); }
TEST_CASE("conformance: FailingPly of ChangChang") { conforms(FailingPly{carbon, carbon_chang}); }
