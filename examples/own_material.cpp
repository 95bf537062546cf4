// A strength law of your own, Voce's saturating hardening: verified at one point, then used in the Taylor bar.
//
//   bash examples/run own_material
#include <cmath>
#include <cstdio>

#include <strike/strike.hpp>
#include <strike/verify.hpp>

#include "support/options.hpp"

using namespace strike;

namespace {

// The law: an aggregate of named numbers and one formula, which runs on every kind of number.
struct Voce {
  double shear_modulus;
  double yield_stress, saturation_stress, saturation_strain;

  template <class T>
  T flow_stress(const T& plastic_strain) const {
    return saturation_stress - (saturation_stress - yield_stress) * exp(-plastic_strain / saturation_strain);
  }
};

// Millimetres, milliseconds, kilograms; so kN and GPa.
const Voce voce{.shear_modulus = 43.3, .yield_stress = 0.3, .saturation_stress = 0.55, .saturation_strain = 0.2};
const Solid copper{LinearEos{.density = 8.93e-6, .bulk_modulus = 130}, voce};

/// Pulls one point in uniaxial stress: above yield the axial stress must be the law's own flow stress.
double largest_error_at_a_point() {
  MaterialPoint point{copper};
  const auto history = point.run(uniaxial_stress({.strain = 0.5, .rate = 1}));
  write("own_material_curve.csv", history);
  double error = 0;
  for (const auto& record : history) {
    const double e = record.state.equivalent_plastic_strain;
    if (e > 0) error = std::max(error, std::abs(record.stress.xx / voce.flow_stress(e) - 1));
  }
  return error;
}

}  // namespace

int main(int count, char** arguments) {
  return examples::run(count, arguments, [](examples::Options& options) {
    options.check();
    const double error_at_a_point = largest_error_at_a_point();
    std::printf("one point in tension   the law's own formula to %.0e\n",
                std::pow(10, std::ceil(std::log10(error_at_a_point))));

    const Mesh bar = cylinder({.radius = 3.2, .length = 32.4});
    Explicit run{Scene{bar.nodes,                                                        //
                       Part{Hex8{}, copper, bar.hexahedra},                              //
                       InitialVelocity{{0, 0, -227}},                                    //
                       Symmetry{Axis::x, nodes_where(bar.nodes, on_plane(Axis::x, 0))},  //
                       Symmetry{Axis::y, nodes_where(bar.nodes, on_plane(Axis::y, 0))},  //
                       Symmetry{Axis::z, nodes_where(bar.nodes, on_plane(Axis::z, 0))}}};
    run.until(0.08);

    double length = 0;
    for (const auto& x : run.positions()) length = std::max(length, x.z());
    std::printf("Taylor bar             final length %.3f mm, energy error %.2f %%\n", length,
                100 * std::abs(run.energy().error()));

    Picture picture{{.title = "Voce copper at 80 us",
                     .quantity = "equivalent plastic strain",
                     .mirror = {Axis::x, Axis::y},
                     .length_unit = "mm"}};
    picture.add(surface(bar), run.positions(),
                run.thing<0>().field([](const auto& state) { return state.equivalent_plastic_strain; }));
    picture.write("own_material.svg");

    Results results;
    results.add({"largest error at a point", error_at_a_point, "1", 0, 1e-9, "the law's own formula"});
    results.add({"energy error", run.energy().error(), "1", 0, 1e-3, "balance"});
    results.add({"final length", length, "mm"});
    results.write("results.csv");
    std::printf("Written: own_material_curve.csv, own_material.svg, results.csv\n");
  });
}
