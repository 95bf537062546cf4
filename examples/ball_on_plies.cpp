// A ball of gelatine, in particles, strikes a plate of eight plies of carbon.
#include <numeric>

#include <strike/draw.hpp>
#include <strike/strike.hpp>

using namespace strike;

int main() try {  // millimetres, tonnes, seconds; so N, MPa and mJ
  const OrthotropicPly carbon{
      .density = 1.6e-9, .E1 = 140e3, .E2 = 9e3, .nu12 = 0.3, .G12 = 5e3, .G13 = 5e3, .G23 = 3e3};
  const Hashin strengths{.Xt = 2000, .Xc = 1200, .Yt = 50, .Yc = 200, .SL = 90, .ST = 70};
  constexpr double angles[] = {0, 45, -45, 90, 90, -45, 45, 0};  // from the back to the side that is struck
  const Layered laminate{LayUp{FailingPly{carbon, strengths}, 0.125, angles}, FibreDirection{{1, 0, 0}}};
  const Fluid gelatine{CubicEos{.density = 0.95e-9, .C1 = 2060, .C2 = 6190, .C3 = 10300, .pressure_cutoff = 0}};

  constexpr double radius = 12, spacing = 2, speed = 80e3;  // of the ball, of its particles; 80 m/s
  const double h = laminate.thickness();
  const Mesh plate = translated(rectangle({.size = {120, 120}, .cells = {60, 60}}), {-60, -60, 0});
  Mesh mesh = plate;
  append(mesh, translated(particles(sphere({.radius = radius, .cells = 6}), spacing), {0, 0, radius + h}));
  const std::vector<Index> edge =
                               nodes_where(plate.nodes, [](const auto& x) { return x.cwiseAbs().maxCoeff() > 59.9; }),
                           ball = nodes_where(mesh.nodes, [](const auto& x) { return x.z() > 0.1; });

  Explicit run{Scene{mesh.nodes, Part{Plate4{}, laminate, plate.quadrilaterals, Erosion{}},
                     Part{Particle{}, gelatine, mesh.particles}, InitialVelocity{{0, 0, -speed}, ball}, Clamped{edge},
                     Contact{NodeToSurface{ball, plate_surface(plate.quadrilaterals, h, 0), spacing}}}};
  double worst = 0;
  run.until(6e-4, [&] { worst = std::max(worst, std::abs(run.energy().error())); });

  const auto mean = [](const std::vector<double>& of) {
    return std::accumulate(of.begin(), of.end(), 0.0) / static_cast<double>(of.size());
  };
  std::vector<double> velocities, heights;
  for (const Index i : ball) velocities.push_back(run.nodes().v(i).z()), heights.push_back(run.nodes().x(i).z());
  std::printf("%zu particles fly at %.1f m/s, the lowest is at %.1f mm\n", ball.size(), mean(velocities) / 1e3,
              *std::min_element(heights.begin(), heights.end()));
  std::printf("energy error %.1e, hourglass energy %.1f J\n", worst, run.energy().hourglass / 1e3);
  const auto& panel = run.part<0>();
  for (std::size_t k = 0; k < laminate.layers(); ++k)
    std::printf("ply %zu, %3g degrees: matrix failed %3.0f %%, fibres %.1f %%\n", k, angles[k],
                100 * mean(panel.field(k, MatrixFailed{})), 100 * mean(panel.field(k, Failed{})));

  Picture picture{{.title = "Ball of gelatine on eight plies", .quantity = "matrix failed", .from = {-1, -2, 1}}};
  picture.add(quadrilateral_surface(plate.quadrilaterals), run.positions(), panel.field(MatrixFailed{}), Sides::both);
  picture.add(mesh.particles, run.positions());
  picture.write("ball.svg");
} catch (const Error& error) {
  return std::fprintf(stderr, "%s\n", error.what()), 1;
}
