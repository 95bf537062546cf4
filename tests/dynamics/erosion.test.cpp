#include <algorithm>
#include <cmath>
#include <vector>

#include <strike/dynamics/explicit.hpp>
#include <strike/dynamics/global_step.hpp>
#include <strike/element/hex8.hpp>
#include <strike/element/plate4.hpp>
#include <strike/element/tet4.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/load/support.hpp>
#include <strike/material/eos/ideal_gas.hpp>
#include <strike/material/eos/linear.hpp>
#include <strike/material/failure/failure.hpp>
#include <strike/material/fluid.hpp>
#include <strike/material/plane_stress.hpp>
#include <strike/material/solid.hpp>
#include <strike/material/strength/von_mises.hpp>
#include <strike/mesh/box.hpp>
#include <strike/mesh/select.hpp>
#include <strike/mesh/sheet.hpp>
#include <strike/mesh/tetrahedra.hpp>
#include <strike/motion/openmp.hpp>
#include <strike/section/layered.hpp>

#include "support/catch.hpp"

using namespace strike;
using Catch::Matchers::ContainsSubstring;

namespace {

constexpr LinearEos eos{.density = 1, .bulk_modulus = 1};
constexpr VonMises strength{.shear_modulus = 0.4, .yield_stress = 0.02, .hardening_modulus = 0.01};
const Solid metal{eos, strength};

/// Keeps what it is told.
struct Listener {
  struct Told {
    std::size_t part;
    std::vector<bool> alive;
  };
  std::vector<Told> told{};
  void remove(std::size_t part, const std::vector<bool>& alive) { told.push_back({part, alive}); }
};

/// A bar of 12 x 2 x 2 cubes, held at x = 0, whose other end flies off.
const Mesh bar = box({.size = {12, 2, 2}, .cells = {12, 2, 2}});
struct Tear {
  template <class N>
  void begin(N& nodes) const {
    for (std::size_t i = 0; i < nodes.size(); ++i)
      nodes.set_velocity(i, {0.3 * std::clamp((nodes.x(i).x() - 3) / 4, 0.0, 1.0), 0, 0});
  }
};
template <class Part, class... Policies>
auto torn(Part part, const Policies&... policies) {
  return Explicit{
      Scene{bar.nodes, part, Tear{}, Symmetry{Axis::x, nodes_where(bar.nodes, on_plane(Axis::x, 0))}, Listener{}},
      ExplicitOptions{.step_factor = 0.3}, policies...};
}

std::size_t count_dead(const std::vector<bool>& alive) {
  return static_cast<std::size_t>(std::count(alive.begin(), alive.end(), false));
}
template <class Run>
double total_mass(const Run& run) {
  double mass = 0;
  for (std::size_t i = 0; i < run.nodes().size(); ++i) mass += run.nodes().mass(i);
  return mass;
}

template <class Run>
void tears(Run& run) {
  auto& part = run.template part<0>();
  const double mass = total_mass(run);
  double worst = 0;
  run.until(20, [&] { worst = std::max(worst, std::abs(run.energy().error())); });
  CHECK(worst < 5e-4);  // as without deletion: 2e-4
  const std::vector<bool> alive = part.alive();
  CHECK(part.deleted() > 0);
  CHECK(part.deleted() < part.size() / 2);
  CHECK(count_dead(alive) == part.deleted());
  CHECK(run.energy().eroded > 0.01 * run.energy().initial);
  CHECK(run.energy().eroded < 0.9 * run.energy().initial);
  CHECK(total_mass(run) == mass);
  CHECK_THAT(part.warning(), ContainsSubstring(std::to_string(part.deleted()) + " of " + std::to_string(part.size()) +
                                               " elements of part 0 have been deleted."));
  // Whoever listens was told of each deletion, and what is gone stays gone.
  const auto& told = run.template item<3>().told;
  REQUIRE(!told.empty());
  CHECK(told.back().alive == alive);
  for (std::size_t k = 1; k < told.size(); ++k) {
    CHECK(count_dead(told[k].alive) > count_dead(told[k - 1].alive));
    for (std::size_t e = 0; e < alive.size(); ++e) CHECK((told[k - 1].alive[e] || !told[k].alive[e]));
  }
}

}  // namespace

TEST_CASE("erosion: a bar that is torn loses elements, and the balance has the energy that they held") {
  auto run = torn(Part{Hex8{}, metal, bar.hexahedra, Erosion{.strain = 0.5}});
  tears(run);
  const auto strain = run.part<0>().field([](const auto& s) { return s.equivalent_plastic_strain; });
  const auto alive = run.part<0>().alive();
  for (std::size_t e = 0; e < alive.size(); ++e) CHECK(strain[e] <= 0.5);  // of what is gone, that before the end
}

TEST_CASE("erosion: the same where the material fails, and of tetrahedra with the pressure of their nodes") {
  auto failing = torn(Part{Hex8{}, Solid{eos, strength, FailureStrain{0.5}}, bar.hexahedra, Erosion{}});
  tears(failing);
  auto tetrahedra = torn(Part{Tet4{}, metal, tetrahedralized(bar).tetrahedra, Erosion{.strain = 0.5}});
  tears(tetrahedra);
}

TEST_CASE("erosion: the same for any number of threads") {
  const auto ends = [](const auto& execution) {
    auto run = torn(Part{Tet4{}, metal, tetrahedralized(bar).tetrahedra, Erosion{.strain = 0.5}}, execution);
    run.until(20);
    return run.positions();
  };
  CHECK(ends(Serial{}) == ends(OpenMP{.threads = 2}));
}

TEST_CASE("erosion: what is deleted has no say in the step of the whole mesh either") {
  auto run = torn(Part{Hex8{}, metal, bar.hexahedra, Erosion{.strain = 0.5}}, GlobalStep{});
  tears(run);
}

TEST_CASE("erosion: elements are deleted by their volume, their step, or as they are inverted") {
  // The face z = 1 of one cube of a fluid of no great stiffness goes through that at z = 0.
  const Mesh cube = box({.size = {1, 1, 1}, .cells = {1, 1, 1}});
  const auto crushed = [&](const Erosion& erosion) {
    Explicit run{
        Scene{cube.nodes,
              Part{Hex8{NoHourglass{}, HughesWinget{}, NoBulkViscosity{}}, Fluid{eos}, cube.hexahedra, erosion},
              InitialVelocity{{0, 0, -100}, nodes_where(cube.nodes, on_plane(Axis::z, 1))}},
        ExplicitOptions{.largest_step = 1e-4}};
    while (run.part<0>().deleted() == 0 && run.steps() < 1000) run.step();
    REQUIRE(run.part<0>().deleted() == 1);
    CHECK(std::abs(run.energy().error()) < 0.02);  // the last steps take it to a hundredth of its volume
    const double height = run.nodes().x(7).z() - run.nodes().x(0).z();
    const Eigen::Vector3d v = run.nodes().v(7);
    for (int i = 0; i < 10; ++i) run.step();
    CHECK((run.nodes().v(7) - v).norm() == 0);  // it flies on
    CHECK(run.dt() <= 1e-4);
    return height;
  };
  CHECK(crushed({.volume = 0.5}) == Approx(0.5).margin(0.011));  // 0.01 a step
  CHECK(crushed({.volume = 0.2}) == Approx(0.2).margin(0.011));
  CHECK(crushed({.step = 5e-3}) > 0);
  CHECK(crushed({.step = 5e-3}) < 1);
  CHECK(crushed({}) <= 0);
}

TEST_CASE("erosion: a gas that leaves takes the energy that it had from the start") {
  const Mesh cube = box({.size = {1, 1, 1}, .cells = {1, 1, 1}});
  const Fluid gas{IdealGas{.density = 1, .gamma = 1.4, .initial_energy = 2.5}};
  Explicit run{Scene{cube.nodes, Part{Hex8{}, gas, cube.hexahedra, Erosion{.volume = 2}}}, {.largest_step = 1e-6}};
  run.until(3e-6);
  CHECK(run.energy().eroded == Approx(2.5));  // it is below twice its volume at once
  CHECK(run.energy().internal == Approx(0).margin(1e-12));
  CHECK(std::abs(run.energy().error()) < 1e-12);
}

TEST_CASE("erosion: a plate loses elements") {
  const Mesh sheet = rectangle({.size = {12, 2}, .cells = {12, 2}});
  const Homogeneous section{PlaneStress{metal}, 0.1};
  Explicit run{Scene{sheet.nodes, Part{Plate4{}, section, sheet.quadrilaterals, Erosion{.strain = 0.5}}, Tear{},
                     Symmetry{Axis::x, nodes_where(sheet.nodes, on_plane(Axis::x, 0))}, Listener{}},
               ExplicitOptions{.step_factor = 0.3}};
  tears(run);
}

TEST_CASE("erosion: without it a part has nothing for it") {
  using Metal = Solid<LinearEos, VonMises>;
  using D8 = Pack<double, 8>;
  using Plain = RunningPart<Hex8<>, Metal, D8>;
  using Eroding = RunningPart<Hex8<>, Metal, D8, Nodes<double>, Erosion>;
  static_assert(sizeof(Eroding::Block) == sizeof(Plain::Block) + 3 * sizeof(D8));
  static_assert(sizeof(Part<Hex8<>, Metal, 8, NoErosion>) == sizeof(Part<Hex8<>, Metal>));
  SUCCEED();
}
