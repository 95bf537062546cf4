// A Taylor bar from an LS-DYNA deck: its mesh, material, supports, velocity and wall are those of the file.
//
//   bash examples/run read_deck
#include <algorithm>
#include <cstdio>
#include <string>

#include <strike/input.hpp>
#include <strike/strike.hpp>

using namespace strike;

int main() try {  // the deck is in millimetres, milliseconds, kilograms
  const DynaDeck deck = read_dyna("../../examples/read_deck/taylor_bar.k");
  for (const std::string& warning : deck.warnings) std::printf("%s\n", warning.c_str());

  const PlasticMaterial& copper = deck.material<PlasticMaterial>("bar");
  const PartCells bar = deck.part("bar");
  const SupportCard &x = deck.supports.at(0), &y = deck.supports.at(1);
  const VelocityCard& flight = deck.velocities.at(0);
  const WallCard& wall = deck.walls.at(0);

  Explicit run{Scene{deck.mesh.nodes,
                     Part{Hex8{ViscousHourglass{deck.hourglass("bar").coefficient}}, Solid{copper.eos, copper.strength},
                          bar.hexahedra},
                     InitialVelocity{flight.velocity, Spin{flight.spin, flight.centre}, flight.nodes},
                     Support{x.nodes, x.directions(), x.axes()}, Support{y.nodes, y.directions(), y.axes()},
                     RigidWall{wall.point, wall.normal, wall.nodes, wall.friction}},
               {.step_factor = deck.step_factor}};
  run.until(deck.end_time);

  double length = 0;
  for (const Eigen::Vector3d& position : run.positions()) length = std::max(length, position.z());
  Results results;
  results.add({"final length", length, "mm", 21.47, 0.02 * 21.47, "X3D, 1350 elements"});
  results.add({"energy error", run.energy().error(), "1", 0, 1e-3, "balance"});
  results.write("results.csv");
  std::printf("final length %.3f mm, 21.47 with X3D and 1350 elements; energy error %.1e\n", length,
              run.energy().error());
} catch (const Error& error) {
  return std::fprintf(stderr, "%s\n", error.what()), 1;
}
