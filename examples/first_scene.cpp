// The scene of the README: thirty lines from the first include to a picture.
#include <strike/draw/picture.hpp>
#include <strike/strike.hpp>

using namespace strike;

int main() {  // millimetres, milliseconds, kilograms; so kN, GPa and J
  const Solid copper{LinearEos{.density = 8.93e-6, .bulk_modulus = 130},
                     VonMises{.shear_modulus = 43.3, .yield_stress = 0.4, .hardening_modulus = 0.1}};
  const Mesh bar = cylinder({.radius = 3.2, .length = 32.4});

  Explicit run{Scene{bar.nodes,  //
                     Part{Hex8{}, copper, bar.hexahedra}, InitialVelocity{{0, 0, -227}},
                     Symmetry{Axis::x, nodes_where(bar.nodes, on_plane(Axis::x, 0))},
                     Symmetry{Axis::y, nodes_where(bar.nodes, on_plane(Axis::y, 0))}, RigidWall{{0, 0, 0}, {0, 0, 1}}}};

  VtuSeries film{"bar"};
  run.until(0.08, Every{0.005, [&] { film.write(run); }}, Progress{{.unit = "ms"}});

  Picture picture{{.title = "Taylor bar at 80 us", .quantity = "plastic strain", .mirror = {Axis::x, Axis::y}}};
  picture.add(surface(bar), run.positions(), run.part<0>().field(PlasticStrain{}));
  picture.write("bar.svg");

  Results results;
  results.add({"energy error", run.energy().error(), "1", 0, 1e-3, "balance"});
  results.write("results.csv");
}
