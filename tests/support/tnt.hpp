#pragma once
#include <strike/material/eos/jwl.hpp>

/// TNT of Dobratz and Crawford (1985) [SI].
namespace tnt {

inline constexpr strike::Jwl products{.density = 1630,
                                      .A_products = 371.2e9,
                                      .B_products = 3.231e9,
                                      .R1 = 4.15,
                                      .R2 = .95,
                                      .omega = .30,
                                      .initial_energy = 7.0e9};
inline constexpr double detonation_velocity = 6930, pressure_CJ = 21e9;

}  // namespace tnt
