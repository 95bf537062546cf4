#include <filesystem>

#include <strike/dynamics/every.hpp>
#include <strike/input/read_mesh.hpp>

#include "problems/taylor_bar.hpp"
#include "support/catch.hpp"

using namespace strike;

TEST_CASE("Taylor bar, 1350 hexahedra: X3D's table and the history of an independent code") {
  struct Row {
    double time, length, radius, kinetic;  // us, mm, mm, share of the kinetic energy once the foot has stopped
  };
  // An independent Flanagan-Belytschko code on the same mesh, with V^(1/3) as the length in its bulk viscosity.
  const std::vector<Row> history{{0, 32.400, 3.200, 1.000}, {10, 30.143, 5.015, .811}, {20, 28.084, 6.018, .617},
                                 {30, 26.229, 6.657, .426}, {40, 24.620, 7.001, .262}, {50, 23.291, 7.092, .140},
                                 {60, 22.292, 7.089, .057}, {70, 21.679, 7.089, .011}, {80, 21.523, 7.088, .0005}};
  auto run = taylor::bar(taylor::mm_ms_kg, 3, 50, in<Pack<double>>, Hex8{ViscousHourglass{}});
  double drift = 0;
  std::size_t row = 0;
  run.until(taylor::mm_ms_kg.end,
            Every{0.01,
                  [&] {
                    REQUIRE(row < history.size());
                    INFO("at " << history[row].time << " us");
                    CHECK(taylor::length(run) == Approx(history[row].length).epsilon(1e-3));
                    CHECK(taylor::radius(run) == Approx(history[row].radius).epsilon(2e-3));
                    const Energy& e = run.energy();
                    CHECK(e.kinetic / (e.initial - e.contact) == Approx(history[row].kinetic).margin(2e-3));
                    ++row;
                  }},
            [&] { drift = std::max(drift, std::abs(run.energy().error())); });
  CHECK(row == history.size());

  // Between X3D and DYNA3D (Brockman and Held 1991): 21.47, 7.081 and 7.034, 2.95.
  CHECK(taylor::length(run) == Approx(21.47).margin(0.08));
  CHECK(taylor::radius(run) == Approx(7.08).margin(0.08));
  CHECK(taylor::plastic_strain(run) == Approx(2.92).margin(0.12));
  // The independent code with the length of the time step in its bulk viscosity, as here.
  CHECK(taylor::length(run) == Approx(21.517).epsilon(1e-3));
  CHECK(taylor::radius(run) == Approx(7.081).epsilon(1e-3));
  CHECK(taylor::plastic_strain(run) == Approx(2.877).epsilon(1e-3));

  CHECK(drift < 1e-3);
  CHECK(run.energy().hourglass < 0.02 * run.energy().initial);
  CHECK(run.energy().contact == Approx(run.energy().initial / (2 * 50)).epsilon(1e-3));  // the foot of 50 layers stops
  CHECK(run.energy().initial == Approx(239.8 / 4).epsilon(0.02));  // pi R^2 L rho v^2/2 [J], less the polygon's gaps
}

// The limit of fine meshes is 21.42 mm and 7.21 to 7.23 mm (docs/verification.md).
TEST_CASE("Taylor bar, 1350 hexahedra with the physical hourglass control: near the limit of fine meshes") {
  auto run = taylor::bar(taylor::mm_ms_kg, 3, 50, in<Pack<double>>);
  run.until(taylor::mm_ms_kg.end);
  CHECK(taylor::length(run) == Approx(21.42).epsilon(7e-3));
  CHECK(taylor::radius(run) == Approx(7.22).epsilon(7e-3));
  CHECK(taylor::length(run) == Approx(21.473).epsilon(1e-4));
  CHECK(taylor::radius(run) == Approx(7.190).epsilon(1e-4));
}

TEST_CASE("Taylor bar from files of gmsh 4.8.4: the built-in mesh and its result") {
  const Mesh own = cylinder({.radius = 3.2, .length = 32.4, .cells = 2, .layers = 10});
  auto reference = taylor::bar(taylor::mm_ms_kg, own, in<Pack<double>>);
  reference.until(taylor::mm_ms_kg.end);

  const auto folder = std::filesystem::path(__FILE__).parent_path() / "../../examples/taylor_from_deck";
  for (const char* name : {"taylor22.msh", "taylor41.msh", "taylor.inp", "taylor.key"}) {
    INFO(name);
    const Deck deck = read_mesh(folder / name);
    const Mesh& bar = deck.mesh;
    REQUIRE(bar.nodes.size() == own.nodes.size());
    REQUIRE(bar.hexahedra.size() == own.hexahedra.size());
    CHECK(std::all_of(bar.nodes.begin(), bar.nodes.end(), [&](const Eigen::Vector3d& x) {
      return std::any_of(own.nodes.begin(), own.nodes.end(),
                         [&](const auto& y) { return (x - y).norm() < 1e-8; });  // gmsh divides arcs to 3e-9
    }));
    REQUIRE(deck.node_sets.size() >= 3);
    const bool key = std::string(name) == "taylor.key";  // it names them in comments
    CHECK((key ? deck.nodes(1) : deck.nodes("foot")) == nodes_where(bar.nodes, on_plane(Axis::z, 0)));
    CHECK((key ? deck.nodes(2) : deck.nodes("x0")) == nodes_where(bar.nodes, on_plane(Axis::x, 0)));
    CHECK((key ? deck.nodes(3) : deck.nodes("y0")) == nodes_where(bar.nodes, on_plane(Axis::y, 0)));
    if (!key) CHECK(deck.part("bar").hexahedra == bar.hexahedra);

    // Nodes that far apart make differences of 1e-11 here; asked of the readers are 5e-3.
    auto run = taylor::bar(taylor::mm_ms_kg, bar, in<Pack<double>>);
    run.until(taylor::mm_ms_kg.end);
    CHECK(taylor::length(run) == Approx(taylor::length(reference)).epsilon(1e-8));
    CHECK(taylor::radius(run) == Approx(taylor::radius(reference)).epsilon(1e-8));
    CHECK(taylor::plastic_strain(run) == Approx(taylor::plastic_strain(reference)).epsilon(1e-8));
  }
}
