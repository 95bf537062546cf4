#pragma once
#include <string_view>

#include <strike/cxx20.hpp>

namespace strike {

/// Names of the units of a consistent system, for tables, axes and heads of columns; and the size of its three base
/// units in SI, from which all others follow (force = mass length / time^2, ...).
struct Units {
  std::string_view name;
  std::string_view length, time, mass, force, stress, energy, velocity, density;
  double metre = 1;     ///< unit of length [m]
  double second = 1;    ///< unit of time [s]
  double kilogram = 1;  ///< unit of mass [kg]

  constexpr double newton() const { return kilogram * metre / (second * second); }  ///< unit of force [N]
  constexpr double pascal() const { return kilogram / (metre * second * second); }  ///< unit of stress [Pa]
  constexpr double joule() const { return newton() * metre; }                       ///< unit of energy [J]
  constexpr double kilogram_per_cubic_metre() const { return kilogram / (metre * metre * metre); }  ///< of density
};

/// Five systems in use. 1 in = 0.0254 m, 1 lb = 0.45359237 kg, standard gravity 9.80665 m/s^2, all by definition.
namespace units {

inline constexpr Units si{.name = "m-s-kg",
                          .length = "m",
                          .time = "s",
                          .mass = "kg",
                          .force = "N",
                          .stress = "Pa",
                          .energy = "J",
                          .velocity = "m/s",
                          .density = "kg/m3"};

inline constexpr Units mm_ms_kg{.name = "mm-ms-kg",
                                .length = "mm",
                                .time = "ms",
                                .mass = "kg",
                                .force = "kN",
                                .stress = "GPa",
                                .energy = "J",
                                .velocity = "m/s",
                                .density = "kg/mm3",
                                .metre = 1e-3,
                                .second = 1e-3};

inline constexpr Units mm_s_t{.name = "mm-s-t",
                              .length = "mm",
                              .time = "s",
                              .mass = "t",
                              .force = "N",
                              .stress = "MPa",
                              .energy = "mJ",
                              .velocity = "mm/s",
                              .density = "t/mm3",
                              .metre = 1e-3,
                              .kilogram = 1e3};

inline constexpr Units cm_us_g{.name = "cm-us-g",
                               .length = "cm",
                               .time = "us",
                               .mass = "g",
                               .force = "Mbar cm2",
                               .stress = "Mbar",
                               .energy = "Mbar cm3",
                               .velocity = "cm/us",
                               .density = "g/cm3",
                               .metre = 1e-2,
                               .second = 1e-6,
                               .kilogram = 1e-3};

inline constexpr Units in_s_lbf{.name = "in-s-lbf",
                                .length = "in",
                                .time = "s",
                                .mass = "lbf s2/in",
                                .force = "lbf",
                                .stress = "psi",
                                .energy = "in lbf",
                                .velocity = "in/s",
                                .density = "lbf s2/in4",
                                .metre = 0.0254,
                                .kilogram = 0.45359237 * 9.80665 / 0.0254};

}  // namespace units
}  // namespace strike
