#include "conformance/ranges.hpp"

#include <array>
#include <limits>

#include <strike/calibrate/uniaxial_stresses.hpp>
#include <strike/verify/laminate.hpp>
#include <strike/verify/material_point.hpp>
#include <strike/verify/path.hpp>
#include <strike/verify/workbench.hpp>

#include "support/plies.hpp"
#include "support/tnt.hpp"

using namespace strike;

namespace {

constexpr LinearEos linear{.density = 2700, .bulk_modulus = 71e9};
constexpr VonMises von_mises{.shear_modulus = 27e9, .yield_stress = 3e6, .hardening_modulus = 1e9};
constexpr Elastic elastic{.density = 2500, .youngs_modulus = 70e9, .poissons_ratio = .22};
const TabulatedHardening tabulated{27e9, {{0, 3e6}, {.001, 4e6}, {.1, 5e6}}};
const DetonationPoint start{{.1, .2, .3}, -1e-3};
constexpr Burn burn{
    .detonation_velocity = tnt::detonation_velocity, .front_width = .01, .pressure_CJ = tnt::pressure_CJ};

/// An elastic routine for numbers Real: properties are lambda and 2 G.
template <class Real>
void elastic_routine(const int* nblock, const int*, const int*, const int*, const int*, const int*, const int*,
                     const Real*, const Real*, const Real*, const char*, const Real*, const Real*, const Real* props,
                     const Real*, const Real* strainInc, const Real*, const Real*, const Real*, const Real*,
                     const Real*, const Real* stressOld, const Real*, const Real*, const Real*, const Real*,
                     const Real*, const Real*, const Real*, Real* stressNew, Real*, Real*, Real*, std::size_t) {
  for (int k = 0; k < *nblock; ++k)
    for (int c = 0; c < 6; ++c) {
      const int n = *nblock, i = c * n + k;
      const Real volume = strainInc[k] + strainInc[n + k] + strainInc[2 * n + k];
      stressNew[i] = stressOld[i] + props[1] * strainInc[i] + (c < 3 ? props[0] * volume : Real(0));
    }
}

}  // namespace

TEST_CASE("conformance: wrong numbers of materials are refused") {
  testing::WrongNumbers tried;
  const auto refuses = [&](const auto& model) { testing::refuses_wrong_numbers(model, tried); };
  refuses(linear);
  refuses(CubicEos{.density = 938, .C1 = 2.06e9, .C2 = 6.19e9, .C3 = 10.3e9, .pressure_cutoff = -1e5});
  refuses(PolynomialEos{.density = 1000,
                        .C0 = 1e5,
                        .C1 = 2.19e9,
                        .C2 = 9.224e9,
                        .C3 = 8.767e9,
                        .C4 = .4934,
                        .C5 = 1.3937,
                        .C6 = .1,
                        .initial_energy = 1e5,
                        .pressure_cutoff = -1e7});
  refuses(GruneisenEos{.density = 8930,
                       .sound_speed = 3940,
                       .S1 = 1.489,
                       .S2 = .1,
                       .S3 = .1,
                       .gamma = 1.99,
                       .a = .47,
                       .initial_energy = 1e5});
  refuses(TabulatedEos{1000, {{0, 0, .1}, {-.1, 1e9, .2}, {-.2, 3e9, .4}, {-.3, 7e9, .8}}, .5, 1e5, -1e7});
  refuses(IdealGas{.density = 1.2, .gamma = 1.4, .initial_energy = 2.5e5});
  refuses(tnt::products);

  refuses(ElasticStrength{.shear_modulus = 27e9});
  refuses(von_mises);
  refuses(RateVonMises{
      .shear_modulus = 27e9, .yield_stress = 3e6, .hardening_modulus = 1e9, .rate_factor = .3, .rate_exponent = .2});
  refuses(CowperSymonds{tabulated, 40.4, 5});
  refuses(tabulated);
  refuses(TabulatedRates{27e9, {{1, {{0, 3e6}, {.1, 4e6}}}, {100, {{0, 5e6}}}}});
  refuses(PowerHardening{.shear_modulus = 27e9, .coefficient = 5e6, .exponent = .2, .initial_strain = 1e-3});
  refuses(
      KinematicHardening{.shear_modulus = 27e9, .yield_stress = 3e6, .hardening_modulus = 1e9, .isotropic_share = .5});
  refuses(JohnsonCook{.shear_modulus = 47.7e9,
                      .A = 9e6,
                      .B = 2.92e6,
                      .n = .31,
                      .C = .025,
                      .m = 1.09,
                      .initial_temperature = 300,
                      .melting_temperature = 1356,
                      .heating = 2.6e-7});
  refuses(ZerilliArmstrong{.shear_modulus = 80e9,
                           .C0 = 6.5e6,
                           .C1 = 10e6,
                           .C2 = 1e6,
                           .C3 = .00698,
                           .C4 = .000415,
                           .C5 = 2.66e6,
                           .n = .289,
                           .heating = 2.5e-7});
  refuses(Prony<2>{.shear_modulus = 1e9, .terms = {{.share = .9, .time = 1e-3}, {.share = .09, .time = 1}}});
  refuses(MooneyRivlin{.C10 = 1e6, .C01 = 2e5});
  refuses(Sensitive{von_mises, std::array{Dual<double, 1>::variable(3e6, 0)}, &VonMises::yield_stress});

  refuses(UltimateStress{20e6});
  refuses(FailureStrain{.3});
  refuses(PrincipalStress{30e6});
  refuses(JohnsonCookFailure{.D1 = .05, .D2 = 3.44, .D3 = -2.12, .D4 = .002, .D5 = .61, .melting_temperature = 1793});
  refuses(TulerButcher{.threshold = 1e6, .strength = 30e6, .duration = 1e-5, .exponent = 2});
  refuses(BecomesFluid{UltimateStress{20e6}});

  refuses(elastic);
  refuses(Solid{linear, von_mises, FailureStrain{.3}});
  refuses(Fluid{CubicEos{.density = 938, .C1 = 2.06e9}, Newtonian{.viscosity = 1e-3}});
  refuses(Explosive{tnt::products, start, burn});
  refuses(Explosive{tnt::products, DetonationPoints{{start, start}}, burn});
  refuses(Explosive{tnt::products, DetonationPlane{{.1, .2, .3}, {1, 2, 2}, -1e-3}, burn});
  refuses(PlaneStress{Solid{linear, von_mises, UltimateStress{20e6}}});
  refuses(ZeroNormalStress{Solid{linear, von_mises}});
  const OrthotropicPly carbon{.density = 1600, .E1 = 140e9, .E2 = 9e9, .nu12 = .3, .G12 = 5e9, .G13 = 5e9, .G23 = 3e9};
  refuses(carbon);
  refuses(FailingPly{carbon, MaximumStress{.Xt = 2e9, .Xc = 1e9, .Yt = 50e6, .Yc = 200e6, .S = 90e6}});
  refuses(FailingPly{carbon, Hashin{.Xt = 2e9, .Xc = 1e9, .Yt = 50e6, .Yc = 200e6, .SL = 90e6, .ST = 70e6}});
  refuses(FailingPly{carbon, ChangChang{.Xt = 2e9, .Xc = 1e9, .Yt = 50e6, .Yc = 200e6, .S = 90e6, .beta = .5}});
  const auto user = [](const auto& options) { return testing::detail::works(Vumat<2>{options}); };
  testing::refuses_wrong_numbers(VumatOptions<double>{.routine = elastic_routine<double>,
                                                      .density = 2700,
                                                      .properties = {40e9, 54e9},
                                                      .initial_variables = {1, 2},
                                                      .temperature = 20,
                                                      .characteristic_length = .1},
                                 tried, user);
  tried.print("materials");
}

TEST_CASE("conformance: wrong numbers of sections are refused") {
  testing::WrongNumbers tried;
  const PlaneStress glass{elastic};
  const Layer layer{glass, .1};
  const auto refuses = [&](const auto& piece, const auto&... others) {
    testing::refuses_wrong_numbers(piece, tried, [&](const auto& changed) {
      return testing::detail::works(Layered{others..., changed});
    });
  };
  refuses(layer);
  refuses(Plies{layer, 3});
  refuses(Offset{.02}, layer);
  refuses(EnergyShear{.length = 1}, layer);
  refuses(EffectiveShear{.length = 1}, layer, layer);
  refuses(InstantaneousShear{.length = 1}, layer);
  testing::refuses_wrong_numbers(Delamination{.shear_strength = 60e6}, tried, [](const auto& indicator) {
    testing::detail::check_ranges(indicator);
    return true;
  });
  refuses(FibreDirection{{1, 2, 0}}, LayUp{testing::carbon, .1, {0, 45}});
  refuses(LayUp{testing::carbon, .1, {0, 45}}, FibreDirection{{1, 2, 0}});
  refuses(PlyStack{{Ply{testing::carbon, .1}, Ply{testing::carbon, .2, 45}}}, FibreDirection{{1, 2, 0}});
  tried.print("sections");
}

TEST_CASE("conformance: wrong numbers of elements are refused") {
  testing::WrongNumbers tried;
  const auto refuses = [&](const auto& model) { testing::refuses_wrong_numbers(model, tried); };
  refuses(Hex8{});
  refuses(Hex8{StiffnessHourglass{}, Jaumann{}, BulkViscosity{}, EndStep{}});
  refuses(Hex8{ViscousHourglass{}, Jaumann{}, BulkViscosityBothWays{}, EndStep{}});
  refuses(Hex8Full{});
  refuses(Tet4{});
  refuses(Plate4{}), refuses(Plate3{});
  refuses(MassScaled{Hex8{}, 1e-4});
  tried.print("elements");
}

// Those of sweeps and fits stand in verify/workbench and calibrate/fit, which instantiate them anyway.
TEST_CASE("conformance: wrong numbers of verifiers are refused") {
  testing::WrongNumbers tried;
  using namespace strike::verify;
  const auto refuses = [&](const auto& model, const auto& works) {
    testing::refuses_wrong_numbers(model, tried, works);
  };
  const auto runs = [](const Path& path) { return std::isfinite(MaterialPoint{elastic}.run(path).back().work); };
  refuses(Ramp{.strain = 1e-3, .rate = 2}, [&](const Ramp& ramp) { return runs(uniaxial_strain(ramp)); });
  refuses(Segment{.duration = 1e-3}, [&](const Segment& segment) { return runs({{segment}}); });
  refuses(ElasticLayer{.thickness = .1, .youngs_modulus = 70e9, .poissons_ratio = .22, .density = 2500},
          [](const ElasticLayer& layer) { return std::isfinite(Laminate{{layer}}.deflection(3)); });
  refuses(MindlinPlate{.bending = 3, .shear_stiffness = 4, .density = 5, .rotary_inertia = 6},
          [](const MindlinPlate& plate) { return std::isfinite(plate.deflection(3)); });
  refuses(ElementTolerances{}, [](const ElementTolerances& tolerances) {
    strike::detail::check_ranges(tolerances);
    return true;
  });

  refuses(calibrate::UniaxialTest{}, [](const calibrate::UniaxialTest& test) {
    return std::isfinite(calibrate::uniaxial_stresses(elastic, std::array{1e-3, 2e-3}, test).back());
  });
  tried.print("verifiers");
}

TEST_CASE("ranges: the sentence names class, member, value and what is allowed") {
  using testing::refusal;
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(refusal(VonMises{.shear_modulus = 1, .yield_stress = nan}) ==
        "strike: the yield_stress of VonMises is nan; it must be zero or positive.");
  CHECK(refusal(LinearEos{.density = 1, .bulk_modulus = 1e300}) ==
        "strike: the bulk_modulus of LinearEos is 1e+300; it must be positive and at most 1e+100 in size.");
  CHECK(refusal(Prony<2>{.shear_modulus = 1, .terms = {{.share = .9, .time = 1}, {.share = .2, .time = 1}}}) ==
        "strike: the terms[1].share of Prony is 0.2; it must be zero or positive and at most 0.1: all shares together "
        "are at most 1.");
  CHECK(refusal(DetonationPlane{.place = {0, 0, 0}, .normal = {0, 0, 0}}) ==
        "strike: the normal of DetonationPlane is (0, 0, 0); it must be finite and not zero.");
  CHECK(refusal(verify::SweepOptions{.aspects = {1, -2}}) ==
        "strike: the aspects[1] of SweepOptions is -2; it must be positive.");
  CHECK(refusal(Layered{Layer{PlaneStress{elastic}, .1},
                        Layer{PlaneStress{Elastic{.density = 0, .youngs_modulus = 1}}, 1}}) ==
        "strike: the density of Elastic, in layer 1, is 0; it must be positive.");
  CHECK(refusal(Fluid{CubicEos{.density = 1, .C1 = 1}, Newtonian{-3}}) ==
        "strike: the viscosity of Newtonian is -3; it must be zero or positive.");
}

TEST_CASE("ranges: a sum of shares of one is not refused for its rounding") {
  CHECK(testing::refusal(
            Prony<3>{.shear_modulus = 1,
                     .terms = {{.share = .1, .time = 1}, {.share = .2, .time = 1}, {.share = .7, .time = 1}}}) == "");
}

namespace {

/// A law of a user's own joins the suite in one line.
struct Squared {
  double shear_modulus, factor;

  void ranges(const auto& number) const {
    number("shear_modulus", shear_modulus, range::positive);
    number("factor", factor, range::not_negative);
  }
  template <class T>
  T flow_stress(const T& e) const {
    return factor * (1.0 + e * e);
  }
};

}  // namespace

TEST_CASE("conformance: wrong numbers of a law of a user's own") {
  testing::refuses_wrong_numbers(Squared{.shear_modulus = 27e9, .factor = 3e6});
}
