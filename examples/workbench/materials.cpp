// A material point under strain, stress and mixed control. The expected values are formulas.
#include <cmath>

#include <strike/material.hpp>

#include "studies.hpp"

using namespace strike;
using namespace strike::verify;

void study_materials(Workbench& bench, double strain, double rate) {
  const LinearEos eos{.density = density, .bulk_modulus = K};
  const Solid copper{eos, VonMises{.shear_modulus = G, .yield_stress = Y, .hardening_modulus = H}};
  const Solid elastic{eos, ElasticStrength{.shear_modulus = G}};
  const RateVonMises law{
      .shear_modulus = G, .yield_stress = Y, .hardening_modulus = H, .rate_factor = 0.111, .rate_exponent = 0.25};

  // While it flows, the axial stress is the flow stress.
  const auto flow_stress = [](const auto& record) {
    const double e = record.state.equivalent_plastic_strain;
    return e > 0 ? Y + H * e : NAN;
  };
  bench.follow("tension", copper, uniaxial_stress({.strain = strain, .rate = rate}), axial, flow_stress, 1e-9);
  bench.follow("tension by stress", copper, {{Segment{.duration = 1, .stress = {.xx = 1.02 * Y, .yy = 0, .zz = 0}}}},
               axial, flow_stress, 1e-9);
  bench.follow(
      "compression beside a pressure", copper,  // mixed: first all around, then along x
      {{Segment{.duration = 1, .stress = {.xx = -1, .yy = -1, .zz = -1}},
        Segment{.duration = strain / rate,
                .velocity_gradient = Matrix3<double>{{-rate, 0, 0}, {0, 0, 0}, {0, 0, 0}},
                .stress = {.yy = -1, .zz = -1}}}},
      axial, [&](const auto& record) { return -1 - flow_stress(record); }, 1e-9);

  // sigma = -p + 2/3 of the flow stress; p = K (rho/rho0 - 1).
  bench.follow(
      "uniaxial strain", copper, uniaxial_strain({.strain = -0.1, .rate = rate, .steps = 1000}), axial,
      [&](const auto& record) { return -K * (1 / record.relative_volume() - 1) - 2. / 3 * flow_stress(record); }, 1e-9);
  bench.follow(
      "hydrostatic", copper, hydrostatic({.strain = -strain, .rate = rate}), volumetric,
      [](double volumetric_strain) { return K * std::expm1(-volumetric_strain); }, 1e-9);

  // Jaumann's rate: tau = G sin(gamma) of an elastic body, to second order in the step.
  bench.follow(
      "simple shear", elastic, simple_shear({.strain = 1, .rate = rate, .steps = 1000}), shear,
      [](double gamma) { return G * std::sin(gamma); }, 1e-6);

  bench.follow("cycles", copper, cyclic(uniaxial_stress({.strain = 0.02, .rate = rate}), 3), axial);
  bench.follow(
      "rate jumps", Solid{eos, law},
      rate_jumps(uniaxial_stress, {.strain = 0.05}, {1e-3 * rate, 1e3 * rate, 1e-3 * rate}), axial,
      [&](const auto& record) {  // once the strain is plastic but for a thousandth
        const double e = record.state.equivalent_plastic_strain, D = record.rate_of_deformation.xx;
        const double part = std::fmod(record.strain().xx, 0.05);
        return part > 0.04 ? law.flow_stress(e, D) : NAN;
      },
      2e-3);
}
