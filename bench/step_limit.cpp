// How near the step of GlobalStep comes to the exact limit of the mesh, from the exact derivatives of its forces:
// random meshes of hexahedra, tetrahedra and plates, distorted, graded and warped, elastic and plastic, that strike a
// wall at 1e-3 to 0.1 of their wave speed, at their start and every 20 steps up to 80.
//
//   build/bench/bench/step_limit
//   build/bench/bench/step_limit meshes=16
//
// Prints the largest and least eigenvalue of K dt^2/4 + C dt/2 over the masses at the step allowed: stable up to 1.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <random>

#include <strike/strike.hpp>

#include "conformance/plate.hpp"
#include "dynamics/assembled.hpp"
#include "support/options.hpp"

namespace {

using namespace strike;

/// The eigenvalues that were seen.
struct Seen {
  std::size_t looks = 0;
  double largest = 0, least = 10, least_at_start = 10;

  template <class Run>
  void watch(Run run) {
    const auto look = [&] {
      const double mu = testing::eigenvalue(testing::vibration(run), run.stable_step().dt);
      ++looks, largest = std::max(largest, mu), least = std::min(least, mu);
      if (run.steps() == 0) least_at_start = std::min(least_at_start, mu);
    };
    look();
    try {
      run.until(1e9, StopWhen{[&] { return run.steps() >= 80; }}, [&] {
        if (run.steps() > 0 && run.steps() % 20 == 0) look();
      });
    } catch (const Error&) {  // a plate that is crushed is inverted
    }
  }
};

}  // namespace

int main(int count, char** arguments) {
  return examples::run(count, arguments, [](examples::Options& options) {
    const std::size_t meshes = options.count("meshes", 4);
    options.check();
    std::mt19937 random(11);
    std::uniform_real_distribution<double> unit(0, 1);
    Seen seen;
    for (std::size_t s = 0; s < meshes; ++s) {
      const double nu = std::array{0.0, 0.3, 0.45, 0.499}[s % 4], distortion = 0.2 * unit(random);
      const double grading = s % 2 ? 1 + 5 * unit(random) : 1, speed = std::pow(10, -3 + 2 * unit(random));
      const auto moved = [&](Mesh mesh, double size, double warp) {
        for (Eigen::Vector3d& x : mesh.nodes)
          x += size * Eigen::Vector3d(distortion * (2 * unit(random) - 1), distortion * (2 * unit(random) - 1),
                                      warp * (2 * unit(random) - 1));
        return mesh;
      };
      const auto strike = [&](const auto& element, const auto& material, const Mesh& mesh, const auto& cells,
                              const RigidWall& wall) {
        seen.watch(Explicit{
            Scene{mesh.nodes, Part{element, material, cells}, InitialVelocity{{0, -0.3 * speed, -speed}}, wall},
            ExplicitOptions{.print_warnings = false}, in<double>, GlobalStep{}});
      };
      const auto cube = [&](Index n) {
        return moved(box({.size = {1, 1, 1}, .cells = {n, n, n}, .grading = {grading, 1, grading}}), 1 / (n * grading),
                     distortion);
      };
      const RigidWall below{{0, 0, -0.1}, {0, 0, 1}}, inclined{{0, -0.2, -0.06}, {0, 0.5, 1}};

      const Mesh bricks = cube(3), split = tetrahedralized(cube(2));
      strike(Hex8{}, Elastic{1, 1, nu}, bricks, bricks.hexahedra, below);
      strike(Hex8{}, testing::metal, bricks, bricks.hexahedra, below);
      strike(Hex8{StiffnessHourglass{0.05}}, testing::metal, bricks, bricks.hexahedra, below);
      strike(Hex8Full{}, Elastic{1, 1, nu}, bricks, bricks.hexahedra, below);
      strike(Hex8Full{}, testing::metal, bricks, bricks.hexahedra, below);
      strike(Tet4{}, Elastic{1, 1, nu}, split, split.tetrahedra, below);
      strike(Tet4{}, testing::metal, split, split.tetrahedra, below);
      strike(Tet4{ElementPressure{}}, testing::metal, split, split.tetrahedra, below);

      const Mesh sheet = moved(rectangle({.size = {1, 1}, .cells = {4, 4}}), 0.25, 0.1 * unit(random));
      const double h = 0.25 * std::pow(10, 1 - 3 * unit(random));
      const Homogeneous plastic{PlaneStress{testing::metal}, h, Gauss<3>{}};
      const Layered stiff_on_soft{
          Layer{PlaneStress{Elastic{1, 1, nu}}, 0.3 * h, Gauss<3>{}},
          Layer{PlaneStress{Elastic{0.5, std::pow(10, -3 * unit(random)), 0.3}}, 0.7 * h, Gauss<3>{}}};
      strike(Plate4{}, plastic, sheet, sheet.quadrilaterals, inclined);
      strike(Plate4{}, stiff_on_soft, sheet, sheet.quadrilaterals, inclined);
      strike(Plate4{PhysicalHourglass{}}, plastic, sheet, sheet.quadrilaterals, inclined);
      strike(Plate4{PhysicalHourglass{}}, stiff_on_soft, sheet, sheet.quadrilaterals, inclined);
      strike(Plate4{PlateHourglass{}, RigidOffset{}, ThicknessChange{}}, plastic, sheet, sheet.quadrilaterals,
             inclined);
    }
    std::printf("%zu meshes and times: the eigenvalue is %.3f to %.4f, at the start at least %.3f\n", seen.looks,
                seen.least, seen.largest, seen.least_at_start);
  });
}
