#include <cmath>

#include <strike/dynamics/dynamic_relaxation.hpp>
#include <strike/dynamics/explicit.hpp>
#include <strike/element/hex8.hpp>
#include <strike/element/plate4.hpp>
#include <strike/load/body_force.hpp>
#include <strike/load/nodal_force.hpp>
#include <strike/load/support.hpp>
#include <strike/material/plane_stress.hpp>
#include <strike/mesh/sheet.hpp>
#include <strike/section/layered.hpp>

#include "problems/column.hpp"
#include "support/catch.hpp"

using namespace strike;

namespace {

constexpr Elastic soft{.density = 1000, .youngs_modulus = 1e7, .poissons_ratio = 0};
constexpr double L = 2, g = 10;
constexpr Index cells = 20;

/// A column that stands on x = 0 under its weight, in which each cell bears the weight above its middle.
template <class... Policies>
auto standing(Policies... policies) {
  const Mesh mesh = column(cells, L, L / cells);
  return Explicit{
      Scene{mesh.nodes, Part{Hex8{}, soft, mesh.hexahedra}, Pinned{section(mesh, 0)}, BodyForce{{-g, 0, 0}}},
      {},
      policies...};
}

}  // namespace

TEST_CASE("a column under its weight relaxes to u = -rho g L^2/(2 E)") {
  auto run = standing(DynamicRelaxation{});
  CHECK(!run.damping().is_at_rest());
  double worst = 0;
  run.until(at_rest, [&] { worst = std::max(worst, std::abs(run.energy().error())); });
  CHECK(run.damping().is_at_rest());
  CHECK(run.damping().peaks() > 1);
  CHECK(worst < 1e-3);  // with what the damping took, at any time

  const double weight = 1000 * g;
  const auto stress = run.part<0>().field([](const auto& s) { return s.stress.xx; });
  for (std::size_t e = 0; e < cells; ++e)
    CHECK(stress[e] == Approx(-weight * L * (1 - (static_cast<double>(e) + 0.5) / cells)).margin(1e-3 * weight * L));
  CHECK(L - run.nodes().x(cells).x() == Approx(weight * L * L / 2 / 1e7).epsilon(2e-3));  // strains of 2e-3
  // a load that acts at once does twice the work that the column stores; the damping has the other half
  CHECK(run.energy().damping + run.energy().bulk_viscosity == Approx(run.energy().internal).epsilon(2e-3));
  CHECK(run.energy().kinetic < 1e-7 * run.energy().internal);
}

TEST_CASE("without damping the same column swings to twice that and back") {
  auto run = standing();
  const double period = 4 * L / std::sqrt(1e7 / 1000);
  run.until(period / 2);
  CHECK(L - run.nodes().x(cells).x() == Approx(2 * 1000 * g * L * L / 2 / 1e7).epsilon(0.02));
  run.until(period);
  CHECK(std::abs(L - run.nodes().x(cells).x()) < 0.02 * 1000 * g * L * L / 1e7);
  CHECK(run.energy().damping == 0);
}

TEST_CASE("a cantilever of plates relaxes to F L^3/(3 E I)(1 - 1/(4 n^2)) + F L/K") {
  const Index n = 8;
  const double h = 0.1, b = 0.25, E = 1e7, F = 0.01;
  const Mesh mesh = rectangle({.size = {L, b}, .cells = {n, 1}});
  Explicit run{Scene{mesh.nodes, Part{Plate4{}, Homogeneous{PlaneStress{soft}, h}, mesh.quadrilaterals},
                     Clamped{section(mesh, 0)}, NodalForce{{0, 0, F / 2}, section(mesh, L)}},
               {},
               DynamicRelaxation{}};
  run.until(at_rest);
  const double EI = E * b * h * h * h / 12, K = 5. / 6 * E / 2 * h * b;
  // one point an element: the curvature of its middle is that of a moment which is linear
  const double deflection = F * L * L * L / (3 * EI) * (1 - 1 / (4. * n * n)) + F * L / K;
  CHECK(run.nodes().x(n).z() == Approx(deflection).epsilon(1e-3));
  CHECK(std::abs(run.energy().error()) < 1e-4);
  CHECK(run.energy().damping == Approx(run.energy().internal).epsilon(5e-3));
}
