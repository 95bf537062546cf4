// The scene of the README: from the first include to a film, a picture and a table.
#include <strike/draw.hpp>
#include <strike/strike.hpp>

using namespace strike;

int main() try {  // millimetres, milliseconds, kilograms; so kN, GPa and J
  const Solid copper{LinearEos{.density = 8.93e-6, .bulk_modulus = 130},
                     VonMises{.shear_modulus = 43.33, .yield_stress = 0.4, .hardening_modulus = 0.1}};
  const Mesh bar = cylinder({.radius = 3.2, .length = 32.4});  // a quarter: 1350 hexahedra

  Explicit run{Scene{bar.nodes, Part{Hex8{}, copper, bar.hexahedra}, InitialVelocity{{0, 0, -227}},
                     Symmetry{Axis::x, nodes_where(bar.nodes, on_plane(Axis::x, 0))},
                     Symmetry{Axis::y, nodes_where(bar.nodes, on_plane(Axis::y, 0))},
                     Symmetry{Axis::z, nodes_where(bar.nodes, on_plane(Axis::z, 0))}}};  // its foot on a rigid wall

  VtuSeries film{"bar"};
  run.until(0.08, Every{0.005, [&] { film.write(run); }}, Progress{{.unit = "ms"}});

  const auto strain = run.part<0>().field(PlasticStrain{});
  Picture picture{{.title = "Taylor bar at 80 us", .quantity = "plastic strain", .mirror = {Axis::x, Axis::y}}};
  picture.add(surface(bar), run.positions(), strain);
  picture.write("bar.svg");

  double length = 0, radius = 0;
  for (const Eigen::Vector3d& x : run.positions())
    length = std::max(length, x.z()), radius = std::max(radius, std::hypot(x.x(), x.y()));
  Results results;  // beside those of X3D (Brockman and Held 1991) and the limit of fine meshes
  results.add({"final length", length, "mm", 21.47, 0.08, "X3D"});
  results.add({"foot radius", radius, "mm", 7.22, 0.05, "fine meshes"});
  results.add({"largest plastic strain", *std::max_element(strain.begin(), strain.end()), "1", 2.95, 0.12, "X3D"});
  results.add({"energy error", run.energy().error(), "1", 0, 1e-3, "balance"});
  results.print(), results.write("results.csv");
} catch (const Error& error) {
  return std::fprintf(stderr, "%s\n", error.what()), 1;
}
