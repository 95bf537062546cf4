#include <cmath>
#include <string>

#include <strike/dynamics.hpp>
#include <strike/element.hpp>
#include <strike/load.hpp>
#include <strike/material.hpp>
#include <strike/mesh.hpp>

#include "support/catch.hpp"

using namespace strike;

TEST_CASE("mass scaling of one thin layer: the step, what was added, and the mean velocity follow from its factor") {
  // Cubes of edge 1 and in the middle a layer of 1/4.
  Mesh bar = box({.size = {1, 1, 4.25}, .cells = {1, 1, 5}});
  for (Eigen::Vector3d& x : bar.nodes) {
    const double layer = std::round(x.z() / 0.85);
    x.z() = layer < 3 ? layer : layer - 0.75;
  }
  const Elastic law{.density = 2, .youngs_modulus = 8, .poissons_ratio = 0};
  const auto step_of_one = [&](double height) {
    const Mesh one = box({.size = {1, 1, height}, .cells = {1, 1, 1}});
    return Explicit{Scene{one.nodes, Part{Hex8{}, law, one.hexahedra}}, {}, in<double>}.stable_step().dt;
  };
  const double target = step_of_one(1), factor = std::pow(target / step_of_one(0.25), 2);
  CHECK(factor > 4);
  Explicit run{Scene{bar.nodes, Part{MassScaled{Hex8{}, target}, law, bar.hexahedra}, InitialVelocity{{0, 0, 3}}},
               {},
               in<double>};
  CHECK(run.stable_step().dt == Approx(target).epsilon(1e-12));
  const double mass = 2 * 4.25, added = 2 * 0.25 * (factor - 1);
  CHECK(run.part<0>().added_mass() == Approx(added).epsilon(1e-12));
  CHECK(run.momentum().z() == Approx(3 * (mass + added)).epsilon(1e-12));
  CHECK(run.energy().kinetic == Approx(0.5 * 9 * (mass + added)).epsilon(1e-12));
  CHECK(run.warnings().at(0) == "Mass scaling has added " + detail::text(added) + " to part 0, " +
                                    detail::text(100 * added / mass) + " % of its mass; most to element 2, which has " +
                                    detail::text(factor) + " times its own.");
}

TEST_CASE("an element with scaled mass swings at its frequency over the root of the factor") {
  // Between two faces of half the mass m each, w = 2 c/a; central differences: sin(w_d dt/2) = w dt/2.
  const Mesh cube = box({.size = {1, 1, 1}, .cells = {1, 1, 1}});
  const Elastic law{.density = 2, .youngs_modulus = 8, .poissons_ratio = 0};
  const Hex8<ViscousHourglass, HughesWinget, NoBulkViscosity> element{};
  const double own = Explicit{Scene{cube.nodes, Part{element, law, cube.hexahedra}}, {}, in<double>}.stable_step().dt;
  const double ratio = 5, w = 2 * 2 / ratio, v = 1e-7;
  Explicit run{Scene{cube.nodes, Part{MassScaled{element, ratio * own}, law, cube.hexahedra},
                     InitialVelocityField{[&](const auto& x) { return Eigen::Vector3d(0, 0, x.z() > 0.5 ? v : -v); }}},
               ExplicitOptions{.step_factor = 0.1}, in<double>};
  double highest = 0;
  run.until(1.7 / w, [&] { highest = std::max(highest, run.nodes().x(7).z() - 1); });
  // The amplitude v/w sqrt(1 - (w dt/2)^2)^-1, met within a step, and strains of 1e-7.
  const double half = 0.5 * w * run.dt();
  CHECK(highest == Approx(v / w / std::sqrt(1 - half * half)).epsilon(half * half));
}
