#include <algorithm>
#include <cmath>

#include <strike/contact/contact.hpp>
#include <strike/element/hex8.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/mesh/surface.hpp>
#include <strike/mesh/transform.hpp>

#include "problems/column.hpp"
#include "support/catch.hpp"

using namespace strike;

namespace {

struct Shot {
  double speed;     ///< of the light block along the way of what strikes it
  double momentum;  ///< drift relative to what there was
  double energy;    ///< error of the balance
};

/// A block of 1 kg and one of a millionth of that, of one size and of moduli as unequal, so that sound is as fast in
/// both; one of them rests.
template <class... Policies>
Shot shoot(bool light_strikes, bool light_on_heavy, Policies... policies) {
  Mesh heavy = box({.lower = {0, 0, 0}, .size = {1, 1, 1}, .cells = {2, 2, 2}});
  Mesh light = box({.lower = {0.25, 0.25, 1.001}, .size = {0.5, 0.5, 0.5}, .cells = {2, 2, 2}});
  const double density = 8e-6;  // of the light one: 1e-6 kg
  Mesh mesh = heavy;
  const Index first = append(mesh, light);
  std::vector<Index> light_nodes;
  for (Index i = first; i < mesh.nodes.size(); ++i) light_nodes.push_back(i);
  Cells<8> of_light(mesh.hexahedra.end() - 8, mesh.hexahedra.end());
  Mesh light_mesh{mesh.nodes, of_light};
  const std::vector<Face> light_faces = surface(light_mesh), heavy_faces = surface(heavy);
  const auto pairing = light_on_heavy ? NodeToSurface{surface_nodes(light_faces), Surface{heavy_faces}}
                                      : NodeToSurface{surface_nodes(heavy_faces), Surface{light_faces}};
  const double v = 1;
  Explicit run{Scene{mesh.nodes, Part{Hex8{}, Elastic{1, 1e6, 0.3}, heavy.hexahedra},
                     Part{Hex8{}, Elastic{density, 1e6 * density, 0.3}, of_light}, Contact{pairing, policies...},
                     InitialVelocity{{0, 0, light_strikes ? 0 : v}},
                     InitialVelocity{{0, 0, light_strikes ? -v : 0}, light_nodes}},
               ExplicitOptions{}, in<double>};
  const double p = run.momentum().norm();
  Shot shot{};
  run.until(6e-3, [&] {
    if (run.time() < 5.9e-3) shot.energy = std::max(shot.energy, std::abs(run.energy().error()));  // not of a cut step
  });
  double m = 0;
  for (const Index i : light_nodes) shot.speed += run.nodes().mass(i) * run.nodes().v(i).z(), m += run.nodes().mass(i);
  shot.speed /= m;
  shot.momentum = std::abs(run.momentum().norm() - p) / p;
  return shot;
}

}  // namespace

TEST_CASE("D11: a mass ratio of 1e6, both ways") {
  const auto check = [](auto... policies) {
    for (const bool light_on_heavy : {true, false}) {
      const Shot struck = shoot(false, light_on_heavy, policies...);
      CHECK((struck.speed > 0.95 && struck.speed <= 2));  // between inelastic and elastic, while it swings
      CHECK(struck.momentum < 1e-12);
      CHECK(struck.energy < 1e-3);
      const Shot rebound = shoot(true, light_on_heavy, policies...);
      CHECK((rebound.speed > -0.05 && rebound.speed <= 1));
      CHECK(rebound.momentum < 1e-11);
      CHECK(rebound.energy < 5e-2);  // of the viscous hourglass control, where one node dents a coarse block
    }
  };
  check(Kinematic{});
  check(Penalty{});
}
