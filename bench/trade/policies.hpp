#pragma once
#include <strike/element/hex8.hpp>
#include <strike/element/hex8_full.hpp>

#include "problem.hpp"

// The policies in groups; each changes one thing of the usual.
namespace trade {

/// One point, physical hourglass control, the rotation of Hughes and Winget at mid-step, bulk viscosity, double in
/// the lanes of the machine, 0.9 of the stable step.
constexpr auto usual = [](auto& cases) { cases.add("usual", Hex8{}); };

constexpr auto numbers = [](auto& cases) {
  cases.add("float", Hex8{}, in<Pack<float>>);
  cases.add("mixed", Hex8{}, in<Pack<float>, double>);
  cases.add("double, one lane", Hex8{}, in<double>);
};

/// A metre from the origin, thirty times the size of the Taylor bar.
constexpr auto distances = [](auto& cases) {
  cases.add("double, a metre away", Hex8{}, in<Pack<double>>, Options{.distance = 1000});
  cases.add("float, a metre away", Hex8{}, in<Pack<float>>, Options{.distance = 1000});
  cases.add("mixed, a metre away", Hex8{}, in<Pack<float>, double>, Options{.distance = 1000});
};

constexpr auto elements = [](auto& cases) {
  cases.add("viscous hourglass 0.1", Hex8{ViscousHourglass{}});
  cases.add("8 points", Hex8Full{});
};

constexpr auto step_factors = [](auto& cases) {
  cases.add("step factor 0.5", Hex8{}, in<Pack<double>>, Options{.driver = {.step_factor = 0.5}});
};

constexpr auto hourglass_controls = [](auto& cases) {
  cases.add("no hourglass control", Hex8{NoHourglass{}});
  cases.add("viscous hourglass 0.05", Hex8{ViscousHourglass{.coefficient = 0.05}});
  cases.add("stiffness hourglass 0.001", Hex8{StiffnessHourglass{.coefficient = 0.001}});
  cases.add("stiffness hourglass 0.005", Hex8{StiffnessHourglass{.coefficient = 0.005}});
};

constexpr auto rotations = [](auto& cases) {
  constexpr PhysicalHourglass hourglass;
  constexpr BulkViscosity viscosity;
  cases.add("Jaumann", Hex8{hourglass, Jaumann{}});
  cases.add("end of step", Hex8{hourglass, HughesWinget{}, viscosity, EndStep{}});
  cases.add("Jaumann, end of step", Hex8{hourglass, Jaumann{}, viscosity, EndStep{}});
};

constexpr auto bulk_viscosities = [](auto& cases) {
  cases.add("bulk viscosity both ways", Hex8{PhysicalHourglass{}, HughesWinget{}, BulkViscosityBothWays{}});
  cases.add("no bulk viscosity", Hex8{PhysicalHourglass{}, HughesWinget{}, NoBulkViscosity{}});
};

}  // namespace trade
