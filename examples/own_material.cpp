// A strength law of your own, Voce's saturating hardening: verified at one point, then used in the Taylor bar.
#include <cmath>
#include <cstdio>

#include <strike/draw/picture.hpp>
#include <strike/strike.hpp>
#include <strike/verify/workbench.hpp>

using namespace strike;
using namespace strike::verify;

struct Voce {
  double shear_modulus;
  double yield_stress, saturation_stress, saturation_strain;

  template <class T>
  T flow_stress(const T& plastic_strain) const {
    return saturation_stress - (saturation_stress - yield_stress) * exp(-plastic_strain / saturation_strain);
  }
};

int main() try {  // millimetres, milliseconds, kilograms; so kN and GPa
  const Voce voce{.shear_modulus = 43.3, .yield_stress = 0.3, .saturation_stress = 0.55, .saturation_strain = 0.2};
  const Solid copper{LinearEos{.density = 8.93e-6, .bulk_modulus = 130}, voce};

  // One point in tension: where it flows, the stress must be what the formula says.
  Workbench bench;
  const auto formula = [&](const auto& point) {
    const double e = point.state.equivalent_plastic_strain;
    return e > 0 ? voce.flow_stress(e) : NAN;
  };
  bench.follow("tension", copper, uniaxial_stress({.strain = 0.5}), axial, formula, 1e-9);

  const Mesh bar = cylinder({.radius = 3.2, .length = 32.4});
  Explicit run{Scene{bar.nodes,                                                        //
                     Part{Hex8{}, copper, bar.hexahedra},                              //
                     InitialVelocity{{0, 0, -227}},                                    //
                     Symmetry{Axis::x, nodes_where(bar.nodes, on_plane(Axis::x, 0))},  //
                     Symmetry{Axis::y, nodes_where(bar.nodes, on_plane(Axis::y, 0))},  //
                     RigidWall{{0, 0, 0}, {0, 0, 1}}}};
  run.until(0.08);

  Picture picture{{.title = "Voce copper at 80 us", .quantity = "plastic strain", .mirror = {Axis::x, Axis::y}}};
  picture.add(surface(bar), run.positions(),
              run.part<0>().field([](const auto& state) { return state.equivalent_plastic_strain; }));
  picture.write("bar.svg");

  double length = 0;
  for (const auto& x : run.positions()) length = std::max(length, x.z());
  bench.expect({"length of the bar", length, "mm"});
  bench.expect({"energy error", run.energy().error(), "1", 0, 1e-3, "balance"});
  return bench.finish();
} catch (const Error& error) {
  return std::fprintf(stderr, "%s\n", error.what()), 1;
}
