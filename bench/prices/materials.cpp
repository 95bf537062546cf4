#include <strike/material/eos/polynomial.hpp>
#include <strike/material/vumat.hpp>

#include "feature.hpp"
#include "vumat/copper_vumat.h"

namespace prices {

using namespace bench;

Group strengths() {
  return {"Strength",
          {hexahedra.of_material("none: elastic", elastic),
           hexahedra.of_material("none: a Solid with ElasticStrength",
                                 Solid{linear, ElasticStrength{.shear_modulus = 43.3e9}}),
           hexahedra.of_material("VonMises, perfectly plastic", Solid{linear, perfectly_plastic}),
           hexahedra.of_material("PowerHardening", Solid{linear, power_hardening}),
           hexahedra.of_material("TabulatedHardening, four points", Solid{linear, tabulated}),
           hexahedra.of_material("TabulatedRates, at two rates", Solid{linear, tabulated_rates}),
           hexahedra.of_material("RateVonMises", Solid{linear, rate_dependent}),
           hexahedra.of_material("CowperSymonds of the table", Solid{linear, cowper_symonds}),
           hexahedra.of_material("JohnsonCook, with its temperature", Solid{linear, johnson_cook}),
           hexahedra.of_material("ZerilliArmstrong, with its temperature", Solid{linear, zerilli_armstrong}),
           hexahedra.of_material("the usual law as a routine in C: Vumat",
                                 Vumat<1>{{.routine = copper_vumat,
                                           .density = linear.density,
                                           .properties = {linear.density, linear.bulk_modulus, hardening.shear_modulus,
                                                          hardening.yield_stress, hardening.hardening_modulus}}})}};
}

Group failures() {
  return {
      "Failure",
      {hexahedra.of_material("UltimateStress", Solid{linear, hardening, UltimateStress{.ultimate_stress = 1e12}}),
       hexahedra.of_material("FailureStrain", Solid{linear, hardening, FailureStrain{.failure_strain = 100}}),
       hexahedra.of_material("none, given as NoFailure", Solid{linear, hardening, NoFailure{}}),
       feature("Erosion of the part", [] {
         return started(Scene{bar.nodes, Part{Hex8{ViscousHourglass{}}, copper, bar.hexahedra, Erosion{.strain = 100}},
                              bench::Squeeze{}});
       })}};
}

Group equations_of_state() {
  return {"Equation of state",
          {hexahedra.of_material("PolynomialEos, with energy",
                                 Solid{PolynomialEos{.density = 8930, .C1 = 130e9}, hardening}),
           hexahedra.of_material("GruneisenEos, with energy", Solid{gruneisen, hardening}),
           hexahedra.of_material("fluid, CubicEos", water),
           hexahedra.of_material("fluid, CubicEos, Newtonian", Fluid{water.eos, Newtonian{.viscosity = 1e-3}}),
           hexahedra.of_material("fluid, IdealGas, with energy", air)}};
}

}  // namespace prices
