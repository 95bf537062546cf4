// A user material in the shape of Abaqus's VUMAT, a routine in C, beside the native law that says the same.
//
//   bash examples/run vumat
#include <chrono>
#include <cstdio>

#include <strike/strike.hpp>
#include <strike/verify.hpp>

#include "../support/options.hpp"
#include "copper_vumat.h"

using namespace strike;
using namespace strike::verify;

namespace {

// Millimetres, milliseconds, kilograms; so kN and GPa.
const Solid native{LinearEos{.density = 8.93e-6, .bulk_modulus = 130},
                   VonMises{.shear_modulus = 43.3, .yield_stress = 0.4, .hardening_modulus = 0.1}};
const Vumat<1> user{{.routine = copper_vumat, .density = 8.93e-6, .properties = {8.93e-6, 130, 43.3, 0.4, 0.1}}};

double tension(const auto& material) {
  MaterialPoint point{material};
  return point.run(uniaxial_stress({.strain = 0.5, .rate = 1})).back().stress.xx;
}

struct Foot {
  double radius, strain, seconds;
};

/// The Taylor bar after 20 us.
Foot foot(const auto& material, auto plastic_strain) {
  const Mesh bar = cylinder({.radius = 3.2, .length = 32.4});
  Explicit run{Scene{bar.nodes,                                                        //
                     Part{Hex8{}, material, bar.hexahedra},                            //
                     InitialVelocity{{0, 0, -227}},                                    //
                     Symmetry{Axis::x, nodes_where(bar.nodes, on_plane(Axis::x, 0))},  //
                     Symmetry{Axis::y, nodes_where(bar.nodes, on_plane(Axis::y, 0))},  //
                     Symmetry{Axis::z, nodes_where(bar.nodes, on_plane(Axis::z, 0))}}};
  const auto begin = std::chrono::steady_clock::now();
  run.until(0.02);
  Foot foot{.radius = 0,
            .strain = 0,
            .seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count()};
  for (const auto& x : run.positions()) foot.radius = std::max(foot.radius, x.x());
  for (const double e : run.template part<0>().field(plastic_strain)) foot.strain = std::max(foot.strain, e);
  return foot;
}

}  // namespace

int main(int count, char** arguments) {
  return examples::run(count, arguments, [](examples::Options& options) {
    options.check();
    const double stress = tension(user), expected_stress = tension(native);
    const Foot ours = foot(user, [](const auto& state) { return state.variable[0]; });
    const Foot expected = foot(native, PlasticStrain{});

    std::printf("                                   VUMAT     native\n");
    std::printf("stress at a strain of 0.5 [GPa]  %7.4f    %7.4f\n", stress, expected_stress);
    std::printf("foot radius after 20 us [mm]     %7.4f    %7.4f\n", ours.radius, expected.radius);
    std::printf("largest plastic strain           %7.4f    %7.4f\n", ours.strain, expected.strain);
    std::fprintf(stderr, "seconds                          %7.2f    %7.2f\n", ours.seconds, expected.seconds);

    Results results;
    results.add({"stress at a strain of 0.5", stress, "GPa", expected_stress, 1e-9, "the native law"});
    results.add({"foot radius", ours.radius, "mm", expected.radius, 1e-3, "the native law"});
    results.add({"largest plastic strain", ours.strain, "1", expected.strain, 1e-2, "the native law"});
    results.write("results.csv");
  });
}
