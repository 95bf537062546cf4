#include <strike/material/failing_ply.hpp>
#include <strike/material/orthotropic_ply.hpp>

#include "feature.hpp"

namespace prices {

namespace {

using namespace bench;

constexpr double h = sheet_thickness;
const PlaneStress plane{copper};

/// One layer of another rule, shear policy or offset.
template <class... Options>
Feature section(std::string name, const Options&... options) {
  return plates.of_material(std::move(name), Homogeneous{plane, h, options...});
}
/// One layer of another material.
template <class M>
Feature of(std::string name, const M& material) {
  return plates.of_material(std::move(name), Homogeneous{material, h});
}

/// Eight plies of fibres, [0/45/-45/90]s.
template <class P>
Feature plies(std::string name, const P& ply) {
  constexpr double angles[] = {0, 45, -45, 90, 90, -45, 45, 0};
  return plates.of_material(std::move(name), Layered{LayUp{ply, h / 8, angles}, FibreDirection{{1, 0, 0}}});
}

}  // namespace

Group plate_laminates() {
  constexpr OrthotropicPly carbon{
      .density = 1600, .E1 = 140e9, .E2 = 9e9, .nu12 = 0.3, .G12 = 5e9, .G13 = 5e9, .G23 = 3e9};
  constexpr double Xt = 2e9, Xc = 1.2e9, Yt = 50e6, Yc = 200e6, S = 90e6;
  return {"Plates: laminates of eight plies, two points each",
          {plates.of_material("8 Plies of copper, for comparison", Layered{Plies{Layer{plane, h / 8, Gauss<2>{}}, 8}}),
           plies("OrthotropicPly", carbon),
           plies("FailingPly of MaximumStress", FailingPly{carbon, MaximumStress{Xt, Xc, Yt, Yc, S}}),
           plies("FailingPly of Hashin", FailingPly{carbon, Hashin{Xt, Xc, Yt, Yc, S, 70e6}}),
           plies("FailingPly of ChangChang", FailingPly{carbon, ChangChang{Xt, Xc, Yt, Yc, S}})}};
}

Group plate_sections() {
  const Layer half{plane, h / 2}, third{plane, h / 3};
  return {
      "Plates: points and layers",
      {section("Simpson<3>", Simpson<3>{}), section("Simpson<7>", Simpson<7>{}), section("Simpson<9>", Simpson<9>{}),
       section("Gauss<5>", Gauss<5>{}), plates.of_material("2 layers of five points", Layered{half, half}),
       plates.of_material("3 layers of five points", Layered{third, third, third}),
       plates.of_material("3 Plies of five points", Layered{Plies{third, 3}}),
       section("Offset", Simpson<5>{}, Offset{h / 2})}};
}

Group plate_shears() {
  return {"Plates: transverse shear",
          {section("FiveSixthsShear", Simpson<5>{}, FiveSixthsShear{}),
           section("EffectiveShear", Simpson<5>{}, EffectiveShear{.length = 0.1}),
           section("InstantaneousShear", Simpson<5>{}, InstantaneousShear{})}};
}

Group plate_materials() {
  return {"Plates: material",
          {of("elastic", PlaneStress{elastic}),
           of("VonMises, perfectly plastic", PlaneStress{Solid{linear, perfectly_plastic}}),
           of("RateVonMises", PlaneStress{Solid{linear, rate_dependent}}),
           of("JohnsonCook, with its temperature", PlaneStress{Solid{linear, johnson_cook}}),
           of("FailureStrain", PlaneStress{Solid{linear, hardening, FailureStrain{.failure_strain = 100}}})}};
}

Group plate_elements() {
  constexpr PlateHourglass hourglass;
  constexpr BelytschkoWongChiang warping;
  constexpr ConstantThickness constant;
  return {"Plates: element",
          {plates.of_element("no hourglass control", Plate4{NoPlateHourglass{}}),
           plates.of_element("physical hourglass control", Plate4{PhysicalHourglass{}}),
           plates.of_element("NoWarping", Plate4{hourglass, NoWarping{}}),
           plates.of_element("RigidOffset", Plate4{hourglass, RigidOffset{}}),
           plates.of_element("ThicknessChange", Plate4{hourglass, warping, ThicknessChange{}}),
           plates.of_element("FreeDrilling", Plate4{hourglass, warping, constant, FreeDrilling{}}),
           plates.of_element("the least: no control, NoWarping, FreeDrilling",
                             Plate4{NoPlateHourglass{}, NoWarping{}, constant, FreeDrilling{}})}};
}

Group triangle_choices() {
  return {"Triangles",
          {triangles.of_element("ThicknessChange", Plate3{ThicknessChange{}}),
           triangles.of_element("FreeDrilling", Plate3{ConstantThickness{}, FreeDrilling{}}),
           triangles.of_material("elastic", Homogeneous{PlaneStress{elastic}, h})}};
}

Group plate_numbers() {
  return {"Plates: numbers",
          {plates.by("double, one lane", in<double>), plates.by("Pack<float>", in<Pack<float>>),
           plates.by("mixed: Pack<float> in the elements, double at the nodes", in<Pack<float>, double>)}};
}

}  // namespace prices
