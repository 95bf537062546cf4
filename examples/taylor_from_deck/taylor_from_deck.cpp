// The Taylor bar on meshes that gmsh wrote, each beside the built-in mesh of its size.
//
//   bash examples/run taylor_from_deck                              120 hexahedra, from files of gmsh 4.8.4
//   bash examples/taylor_from_deck/decks out/decks                  gmsh writes 1350
//   bash examples/run taylor_from_deck deck=../decks/taylor.inp
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <tuple>
#include <vector>

#include <strike/input.hpp>
#include <strike/strike.hpp>

#include "../support/options.hpp"

using namespace strike;

namespace {

// Millimetres, milliseconds, kilograms; so kN, GPa and J.
constexpr double radius = 3.2, length = 32.4, speed = 227, end = 0.08;

const Solid copper{LinearEos{.density = 8.93e-6, .bulk_modulus = 130},
                   VonMises{.shear_modulus = 117 / 2.7, .yield_stress = 0.4, .hardening_modulus = 0.1}};

struct Shape {
  double length, foot_radius, plastic_strain;
};

/// Figures of a quarter of the bar after 80 microseconds.
Shape struck(const Mesh& bar) {
  Explicit run{Scene{bar.nodes, Part{Hex8{}, copper, bar.hexahedra}, InitialVelocity{{0, 0, -speed}},
                     Symmetry{Axis::x, nodes_where(bar.nodes, on_plane(Axis::x, 0))},
                     Symmetry{Axis::y, nodes_where(bar.nodes, on_plane(Axis::y, 0))}, RigidWall{{0, 0, 0}, {0, 0, 1}}}};
  run.until(end);
  const auto strains = run.part<0>().field([](const auto& state) { return state.equivalent_plastic_strain; });
  Shape shape{0, 0, *std::max_element(strains.begin(), strains.end())};
  for (const Eigen::Vector3d& x : run.positions()) {
    shape.length = std::max(shape.length, x.z());
    shape.foot_radius = std::max(shape.foot_radius, std::hypot(x.x(), x.y()));
  }
  return shape;
}

/// The built-in mesh with as many hexahedra in as many layers.
Mesh built_in(const Mesh& bar) {
  const auto on_axis = [](const Eigen::Vector3d& x) { return std::hypot(x.x(), x.y()) < 1e-6 * radius; };
  const std::size_t layers = nodes_where(bar.nodes, on_axis).size() - 1;
  const double cells = std::sqrt(static_cast<double>(bar.hexahedra.size()) / (3.0 * static_cast<double>(layers)));
  return cylinder({.radius = radius,
                   .length = length,
                   .cells = static_cast<Index>(std::lround(cells)),
                   .layers = static_cast<Index>(layers)});
}

void compare(const std::string& path, Results& results) {
  const Deck deck = read_mesh(path);
  for (const std::string& warning : deck.warnings) std::printf("%s: %s\n", path.c_str(), warning.c_str());
  const Mesh own = built_in(deck.mesh);
  const Shape theirs = struck(deck.mesh), ours = struck(own);
  const std::string name = path.substr(path.rfind('/') + 1);
  std::printf("%s: %zu hexahedra, built in %zu\n", name.c_str(), deck.mesh.hexahedra.size(), own.hexahedra.size());
  for (const auto& [quantity, read, made] : {std::tuple{"final length [mm]", theirs.length, ours.length},
                                             {"foot radius [mm]", theirs.foot_radius, ours.foot_radius},
                                             {"largest plastic strain", theirs.plastic_strain, ours.plastic_strain}}) {
    const double difference = 100 * (read / made - 1);
    std::printf("  %-24s%10.5f%10.5f%+12.1e %%\n", quantity, read, made, difference);
    results.add({name + ", " + quantity, difference, "%", 0, 0.5, "built-in mesh"});
  }
}

}  // namespace

int main(int count, char** arguments) {
  return examples::run(count, arguments, [](examples::Options& options) {
    const std::string folder = "../../examples/taylor_from_deck/";
    const std::string deck = options.text("deck", "");
    options.check();
    Results results;
    for (const std::string& path : deck.empty() ? std::vector{folder + "taylor22.msh", folder + "taylor41.msh",
                                                              folder + "taylor.inp", folder + "taylor.key"}
                                                : std::vector{deck})
      compare(path, results);
    results.write("results.csv");
  });
}
