#pragma once
#include <strike/element/plate4.hpp>
#include <strike/section/thickness_rule.hpp>

#include "problem.hpp"

// The policies of plates in groups; each changes one thing of the usual.
namespace trade {

/// What a policy decides: the element, and of what else the scene makes its section.
template <class Element = Plate4<>, class Choice = Gauss<5>>
struct Plate {
  Element element{};
  Choice choice{};
};
template <class Element>
Plate(Element) -> Plate<Element>;
template <class Element, class Choice>
Plate(Element, Choice) -> Plate<Element, Choice>;

/// One point, hourglass control 0.03, the warp of Belytschko, Wong and Chiang, constant thickness, a drilling stiffness
/// of 1e-3, five points of Gauss, double in the lanes of the machine, 0.9 of the stable step.
constexpr auto usual_plate = [](auto& cases) { cases.add("usual", Plate{}); };

constexpr auto rules = [](auto& cases) {
  cases.add("Gauss 3", Plate{Plate4{}, Gauss<3>{}});
  cases.add("Simpson 3", Plate{Plate4{}, Simpson<3>{}});
  cases.add("Simpson 5", Plate{Plate4{}, Simpson<5>{}});
  cases.add("Simpson 7", Plate{Plate4{}, Simpson<7>{}});
};

/// Each with the usual rule.
struct TwoLayers {};
constexpr auto layers = [](auto& cases) { cases.add("2 layers", Plate{Plate4{}, TwoLayers{}}); };

constexpr auto warpings = [](auto& cases) {
  cases.add("no warping", Plate{Plate4{PlateHourglass{}, NoWarping{}}});
  cases.add("rigid offset", Plate{Plate4{PlateHourglass{}, RigidOffset{}}});
};

constexpr auto thickness_changes = [](auto& cases) {
  cases.add("thickness change", Plate{Plate4{PlateHourglass{}, BelytschkoWongChiang{}, ThicknessChange{}}});
};

/// With each of the warps: the last is Belytschko, Lin and Tsay's own element.
constexpr auto drillings = [](auto& cases) {
  constexpr PlateHourglass hourglass;
  constexpr ConstantThickness thickness;
  cases.add("free drilling", Plate{Plate4{hourglass, BelytschkoWongChiang{}, thickness, FreeDrilling{}}});
  cases.add("free drilling, rigid offset", Plate{Plate4{hourglass, RigidOffset{}, thickness, FreeDrilling{}}});
  cases.add("free drilling, no warping", Plate{Plate4{hourglass, NoWarping{}, thickness, FreeDrilling{}}});
};

constexpr auto physical_plate = [](auto& cases) {
  cases.add("physical hourglass", Plate{Plate4{PhysicalHourglass{}}});
};

constexpr auto plate_hourglass_controls = [](auto& cases) {
  cases.add("hourglass 0.01", Plate{Plate4{PlateHourglass{.membrane = 0.01, .bending = 0.01, .shear = 0.01}}});
  cases.add("hourglass 0.1", Plate{Plate4{PlateHourglass{.membrane = 0.1, .bending = 0.1, .shear = 0.1}}});
};

constexpr auto plate_numbers = [](auto& cases) {
  cases.add("float", Plate{}, in<Pack<float>>);
  cases.add("mixed", Plate{}, in<Pack<float>, double>);
  cases.add("double, one lane", Plate{}, in<double>);
};

}  // namespace trade
