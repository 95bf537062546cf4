#pragma once
// Copper by several laws, and a flow law of a user's own: pieces of the materials that must conform.
#include <strike/material.hpp>

namespace strike::testing::laws {

inline constexpr double density = 8930, G = 43.3e9, Y = 400e6;
inline constexpr LinearEos linear{.density = density, .bulk_modulus = 130e9};
inline constexpr PolynomialEos hot{
    .density = density, .C1 = 130e9, .C2 = 120e9, .C3 = 100e9, .C4 = 2, .C5 = 2, .pressure_cutoff = -2e9};
inline constexpr GruneisenEos copper{.density = density, .sound_speed = 3940, .S1 = 1.489, .gamma = 1.99, .a = .47};

inline constexpr VonMises von_mises{.shear_modulus = G, .yield_stress = Y, .hardening_modulus = 100e6};
inline constexpr RateVonMises rate_von_mises{
    .shear_modulus = G, .yield_stress = Y, .hardening_modulus = 1e9, .rate_factor = .111, .rate_exponent = .25};
inline constexpr JohnsonCook johnson_cook{.shear_modulus = G,
                                          .A = 90e6,
                                          .B = 292e6,
                                          .n = .31,
                                          .C = .025,
                                          .m = .8,
                                          .initial_temperature = 294,
                                          .melting_temperature = 1356,
                                          .heating = 2.6e-7};

inline constexpr ElasticStrength elastic_strength{.shear_modulus = G};
inline constexpr PowerHardening power{.shear_modulus = G, .coefficient = 600e6, .exponent = .2, .initial_strain = .01};
inline const TabulatedHardening table{G, {{0, 90e6}, {.01, 150e6}, {.05, 220e6}, {.3, 300e6}, {.6, 290e6}}};
inline const TabulatedRates rates{G,
                                  {{1, {{0, 90e6}, {.01, 150e6}, {.3, 300e6}}}, {1e4, {{0, 200e6}, {.1, 350e6}}}},
                                  TabulatedRates::Between::logarithms};
inline constexpr ZerilliArmstrong zerilli_armstrong{.shear_modulus = G,
                                                    .C0 = 65e6,
                                                    .C1 = 100e6,
                                                    .C2 = 890e6,
                                                    .C3 = .0028,
                                                    .C4 = .000115,
                                                    .C5 = 50e6,
                                                    .n = .3,
                                                    .heating = 2.6e-7};

inline constexpr JohnsonCookFailure damage{.D1 = .54, .D2 = 4.89, .D3 = -3.03, .D4 = .014, .D5 = 1.12};
inline constexpr PrincipalStress brittle{.strength = 50e9};
inline constexpr TulerButcher delayed{.threshold = 1e9, .strength = 10e9, .duration = 2e-6, .exponent = 2};

/// A flow law of a user's own, as short as they come.
struct Voce {
  double shear_modulus, Y, Q, b;
  template <class T>
  T flow_stress(const T& e) const {
    return Y + Q * (1.0 - exp(-b * e));
  }
};

}  // namespace strike::testing::laws
