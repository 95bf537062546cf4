#pragma once
#include <strike/material/elastic.hpp>
#include <strike/material/eos/cubic.hpp>
#include <strike/material/eos/gruneisen.hpp>
#include <strike/material/eos/ideal_gas.hpp>
#include <strike/material/eos/linear.hpp>
#include <strike/material/fluid.hpp>
#include <strike/material/solid.hpp>
#include <strike/material/strength/cowper_symonds.hpp>
#include <strike/material/strength/johnson_cook.hpp>
#include <strike/material/strength/power_hardening.hpp>
#include <strike/material/strength/rate_von_mises.hpp>
#include <strike/material/strength/tabulated_hardening.hpp>
#include <strike/material/strength/tabulated_rates.hpp>
#include <strike/material/strength/von_mises.hpp>
#include <strike/material/strength/zerilli_armstrong.hpp>

// Copper by all laws, water and air, in SI units.
namespace bench {

inline constexpr strike::LinearEos linear{.density = 8930, .bulk_modulus = 130e9};
/// Steinberg (1996).
inline constexpr strike::GruneisenEos gruneisen{
    .density = 8930, .sound_speed = 3940, .S1 = 1.489, .gamma = 2.02, .a = 0.47};

inline constexpr strike::VonMises hardening{.shear_modulus = 43.3e9, .yield_stress = 400e6, .hardening_modulus = 100e6};
inline constexpr strike::VonMises perfectly_plastic{.shear_modulus = 43.3e9, .yield_stress = 400e6};
inline constexpr strike::RateVonMises rate_dependent{.shear_modulus = 43.3e9,
                                                     .yield_stress = 400e6,
                                                     .hardening_modulus = 100e6,
                                                     .rate_factor = 0.05,
                                                     .rate_exponent = 0.2};
/// Johnson and Cook (1983), OFHC copper.
inline constexpr strike::JohnsonCook johnson_cook{.shear_modulus = 43.3e9,
                                                  .A = 90e6,
                                                  .B = 292e6,
                                                  .n = 0.31,
                                                  .C = 0.025,
                                                  .m = 1.09,
                                                  .melting_temperature = 1356,
                                                  .heating = 0.9 / (8930 * 383.0)};

/// Zerilli and Armstrong (1987), OFHC copper.
inline constexpr strike::ZerilliArmstrong zerilli_armstrong{
    .shear_modulus = 43.3e9, .C0 = 65e6, .C2 = 890e6, .C3 = 0.0028, .C4 = 0.000115, .heating = 0.9 / (8930 * 383.0)};
inline constexpr strike::PowerHardening power_hardening{
    .shear_modulus = 43.3e9, .coefficient = 500e6, .exponent = 0.1, .initial_strain = 0.02};
inline const strike::TabulatedHardening tabulated{43.3e9, {{0, 400e6}, {0.02, 420e6}, {0.1, 450e6}, {1, 500e6}}};
inline const strike::CowperSymonds cowper_symonds{tabulated, 6500, 4};
inline const strike::TabulatedRates tabulated_rates{
    43.3e9,
    {{1, {{0, 400e6}, {0.02, 420e6}, {0.1, 450e6}, {1, 500e6}}}, {1e4, {{0, 600e6}, {1, 750e6}}}},
    strike::TabulatedRates::Between::logarithms};

inline constexpr strike::Elastic elastic{.density = 8930, .youngs_modulus = 117e9, .poissons_ratio = 0.35};
inline const strike::Fluid water{strike::CubicEos{.density = 1000, .C1 = 2.2e9, .C2 = 5.5e9}};
inline const strike::Fluid air{strike::IdealGas{.density = 1.2, .gamma = 1.4, .initial_energy = 250e3}};

}  // namespace bench
