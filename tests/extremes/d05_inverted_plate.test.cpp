#include <cmath>
#include <string>

#include <strike/dynamics/explicit.hpp>
#include <strike/load/prescribed_motion.hpp>
#include <strike/load/support.hpp>
#include <strike/mesh/check.hpp>
#include <strike/mesh/select.hpp>
#include <strike/mesh/sheet.hpp>

#include "conformance/plate.hpp"

using namespace strike;
using Catch::Matchers::ContainsSubstring;

namespace {

/// 3 x 3 squares of edge 1. The node at the corner (0, 0) moves along the diagonal of its square, whose area vanishes
/// at sqrt(2); those in `held` do
/// not move.
template <class Section, class Held, class Displacement>
auto pushed(const Section& section, Held held, Displacement u) {
  const Mesh mesh = rectangle({.size = {3, 3}, .cells = {3, 3}});
  const std::vector<Index> fixed = nodes_where(mesh.nodes, [&](const auto& x) { return x.norm() > 0 && held(x); });
  return Explicit{Scene{mesh.nodes, Part{Plate4{}, section, mesh.quadrilaterals}, Clamped{fixed},
                        Support{{0}, {unit(Axis::z)}}, PrescribedDisplacement{Eigen::Vector3d(1, 1, 0), {0}, u}},
                  ExplicitOptions{.energy_tolerance = 1}};  // the start at full speed is a jolt
}

using Displacement = double (*)(double);
constexpr Displacement jump = [](double t) { return t < 10 ? 0.0 : 2.0; };
constexpr Displacement steady = [](double t) { return 0.05 * t; };

const auto everywhere = [](const Eigen::Vector3d&) { return true; };
const auto far = [](const Eigen::Vector3d& x) { return x.x() == 3 || x.y() == 3; };

template <class Run>
std::string told(Run& run) {
  try {
    run.until(50);
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

}  // namespace

TEST_CASE("D5: a plate whose corner is pushed through the opposite one is named with its place and time") {
  auto run = pushed(testing::metal_plate, everywhere, jump);
  CHECK_THAT(told(run), ContainsSubstring("strike: at t = 10") && ContainsSubstring("element 0 of part 0 at (") &&
                            ContainsSubstring("is inverted (volume -") && ContainsSubstring("let the material fail"));
  for (const auto& x : run.positions()) CHECK(x.allFinite());
}

TEST_CASE("D5: a plate that is crushed to a triangle and on to a line ends the run with one sentence") {
  auto run = pushed(testing::metal_plate, everywhere, steady);
  CHECK_THAT(told(run), ContainsSubstring("strike: at t = 2") && ContainsSubstring("element 0 of part 0 at ("));
  CHECK(run.time() == Approx(std::sqrt(2) / 0.05).epsilon(0.01));
  for (const auto& x : run.positions()) CHECK(x.allFinite());
}

TEST_CASE("D5: where its material can fail the rest of the plates run on") {
  for (const Displacement u : {steady, jump}) {
    auto run = pushed(testing::brittle_plate, far, u);
    CHECK(told(run).empty());
    const std::vector<double> intact = run.template part<0>().field([](const auto& state) { return state.intact; });
    CHECK(intact[0] == 0);
    CHECK(intact[8] == 1);
    for (std::size_t i = 0; i < run.nodes().size(); ++i)
      CHECK((run.nodes().x(i) + run.nodes().v(i) + run.nodes().w(i)).allFinite());
  }
}

TEST_CASE("D5: a bow-tie is refused before anything moves") {
  Mesh mesh = rectangle({.size = {1, 1}});
  std::swap(mesh.quadrilaterals[0][1], mesh.quadrilaterals[0][2]);
  CHECK_THROWS_WITH(check(mesh), ContainsSubstring("quadrilateral 0 at (0.5, 0.5, 0) is crossed"));
  CHECK_THROWS_WITH((Explicit{Scene{mesh.nodes, Part{Plate4{}, testing::metal_plate, mesh.quadrilaterals}}}),
                    ContainsSubstring("element 0 of part 0 at (0.5, 0.5, 0) is crossed, concave or flat"));
}
