// Two bodies, contact and erosion: a ball of steel perforates a plate of aluminium.
//
//   bash examples/run ball_on_plate
#include <cstdio>

#include <strike/strike.hpp>

using namespace strike;

int main() try {  // millimetres, milliseconds, kilograms; so kN, GPa and J
  const Mesh plate = box({.lower = {-16, -16, -3}, .size = {32, 32, 3}, .cells = {32, 32, 3}});
  Mesh both = plate;
  append(both, translated(sphere({.radius = 5}), {0, 0, 5.1}));  // its cells follow those of the plate
  const Cells<8> target = plate.hexahedra, ball(both.hexahedra.begin() + std::ssize(target), both.hexahedra.end());

  const Solid aluminium{LinearEos{.density = 2.7e-6, .bulk_modulus = 70},
                        VonMises{.shear_modulus = 27, .yield_stress = 0.35, .hardening_modulus = 0.5},
                        FailureStrain{0.6}};
  const Elastic steel{.density = 7.85e-6, .youngs_modulus = 210, .poissons_ratio = 0.3};
  const auto above = nodes_where(both.nodes, [](const auto& x) { return x.z() > 0.05; });
  const auto edge = nodes_where(both.nodes, [](const auto& x) { return x.cwiseAbs().maxCoeff() > 15.99; });

  Explicit run{Scene{both.nodes, Part{Hex8{}, aluminium, target, Erosion{}}, Part{Hex8{}, steel, ball},
                     InitialVelocity{{0, 0, -400}, above}, Clamped{edge},
                     Contact{Everything{}, Penalty{}, Coulomb{0.1}}}};
  VtuSeries film{"ball"};
  run.until(0.08, Every{0.004, [&] { film.write(run); }}, Progress{{.unit = "ms"}});

  double speed = 0;
  for (const Index i : above) speed -= run.nodes().v(i).z() / static_cast<double>(above.size());
  std::printf("The ball goes on at %.0f m/s; %zu of %zu cells are gone; energy error %.2g\n", speed,
              run.part<0>().deleted(), target.size(), run.energy().error());
} catch (const Error& error) {
  return std::fprintf(stderr, "%s\n", error.what()), 1;
}
