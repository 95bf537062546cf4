// Faces that deleted elements leave bare join the surface of a contact while a run goes on.
#include <algorithm>

#include <strike/contact.hpp>
#include <strike/dynamics.hpp>
#include <strike/element.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/load/support.hpp>
#include <strike/material.hpp>
#include <strike/mesh.hpp>

#include "support/catch.hpp"

using namespace strike;

TEST_CASE("what breaks through a deleted element meets the one behind it") {
  // A hard cube of 0.5 falls on two of 1, of which the upper one, squeezed between both, fails first.
  const Solid brittle{LinearEos{.density = 1, .bulk_modulus = 10}, VonMises{.shear_modulus = 4, .yield_stress = 0.2},
                      UltimateStress{0.199}};
  const Elastic hard{.density = 8, .youngs_modulus = 100, .poissons_ratio = 0.3};
  Mesh scene = box({.size = {1, 1, 2}, .cells = {1, 1, 2}});
  const Mesh cube = box({.lower = {0.25, 0.25, 2.01}, .size = {0.5, 0.5, 0.5}});
  const Index first = append(scene, cube);
  std::vector<Index> falling;
  for (Index i = 0; i < cube.nodes.size(); ++i) falling.push_back(first + i);
  const Cells<8> column(scene.hexahedra.begin(), scene.hexahedra.begin() + 2),
      ball(scene.hexahedra.begin() + 2, scene.hexahedra.end());

  Explicit run{Scene{scene.nodes, Part{Hex8{}, brittle, column, Erosion{}}, Part{Hex8{}, hard, ball},
                     InitialVelocity{{0, 0, -0.4}, falling}, Clamped{nodes_where(scene.nodes, on_plane(Axis::z, 0))},
                     Contact{NodeToSurface{falling, solid_surface(column, 0)}}},
               ExplicitOptions{.energy_tolerance = 0.1}, in<double>};
  const auto& block = run.part<0>();
  const auto& contact = run.item<4>();
  const auto lowest = [&] {
    double z = 10;
    for (const Index i : falling) z = std::min(z, run.nodes().x(i).z());
    return z;
  };
  double impulse_on_first = 0, broke_at = 0;
  run.until(8, [&] {
    if (block.deleted() == 0) impulse_on_first = contact.impulse().z();
    if (block.deleted() > 0 && broke_at == 0) broke_at = run.time();
  });
  CAPTURE(broke_at, impulse_on_first, contact.impulse().z(), lowest(), block.deleted());
  CHECK(block.deleted() >= 1);
  CHECK(!block.alive()[1]);
  CHECK(impulse_on_first > 0);
  CHECK(contact.impulse().z() > 1.5 * impulse_on_first);
  CHECK(lowest() > 0.5);
}
