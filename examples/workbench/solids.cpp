// The one-point hexahedron, an edge of 1 mm.
#include <cmath>

#include <strike/element/hex8.hpp>
#include <strike/material/eos/linear.hpp>
#include <strike/material/solid.hpp>
#include <strike/material/strength/von_mises.hpp>

#include "studies.hpp"

using namespace strike;
using namespace strike::verify;

void study_solids(Workbench& bench) {
  const Solid copper{LinearEos{.density = density, .bulk_modulus = K},
                     VonMises{.shear_modulus = G, .yield_stress = Y, .hardening_modulus = H}};
  bench.element("Hex8", Hex8{}, copper);

  // A cube of one point, U the volume's mode and 5 of shape: w^2 = 12 K/(rho a^2) and 8 G/(rho a^2).
  const auto modes = eigenmodes(SingleElement{Hex8{}, copper, unit_cube()});
  const double w_K = std::sqrt(12 * K / density), w_G = std::sqrt(8 * G / density);
  bench.expect({"Hex8: highest frequency", modes[23].frequency, "1/ms", w_K, 1e-6 * w_K, "sqrt(12 K/rho)/a"});
  bench.expect({"Hex8: next frequency", modes[22].frequency, "1/ms", w_G, 1e-6 * w_G, "sqrt(8 G/rho)/a"});
}
