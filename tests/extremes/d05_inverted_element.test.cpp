#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>

#include <strike/dynamics/every.hpp>
#include <strike/dynamics/explicit.hpp>
#include <strike/element/hex8.hpp>
#include <strike/load/prescribed_motion.hpp>
#include <strike/load/support.hpp>
#include <strike/material/eos/linear.hpp>
#include <strike/material/failure/failure.hpp>
#include <strike/material/solid.hpp>
#include <strike/material/strength/von_mises.hpp>
#include <strike/mesh/box.hpp>
#include <strike/mesh/select.hpp>
#include <strike/output/history.hpp>

#include "support/catch.hpp"

using namespace strike;
using Catch::Matchers::ContainsSubstring;

namespace {

constexpr LinearEos eos{.density = 1000, .bulk_modulus = 1e9};
constexpr VonMises strength{.shear_modulus = 5e8, .yield_stress = 1e6};

/// 3 x 3 x 3 cubes of edge 1. The node at the corner (0, 0, 3) moves along the diagonal of its element, whose volume
/// vanishes at 4/sqrt(3); those in `held` do not move.
template <class Material, class Held, class Displacement>
auto pushed(const Material& material, Held held, Displacement u) {
  const Mesh mesh = box({.size = {3, 3, 3}, .cells = {3, 3, 3}});
  const Eigen::Vector3d corner(0, 0, 3);
  const std::vector<Index> fixed = nodes_where(mesh.nodes, [&](const auto& x) { return x != corner && held(x); });
  return Explicit{Scene{mesh.nodes, Part{Hex8{}, material, mesh.hexahedra}, Symmetry{Axis::x, fixed},
                        Symmetry{Axis::y, fixed}, Symmetry{Axis::z, fixed},
                        PrescribedDisplacement{Eigen::Vector3d(1, 1, -1), {nearest_node(mesh.nodes, corner)}, u}},
                  ExplicitOptions{.energy_tolerance = 1}};  // the start at full speed is a jolt
}

using Displacement = double (*)(double);
constexpr Displacement jump = [](double t) { return t < 0.01 ? 0.0 : 3.0; };
constexpr Displacement steady = [](double t) { return 100 * t; };

const auto everywhere = [](const Eigen::Vector3d&) { return true; };
const auto below = [](const Eigen::Vector3d& x) { return x.z() == 0; };

template <class Run, class... Observers>
std::string told(Run& run, Observers&&... observers) {
  try {
    run.until(0.05, observers...);
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

}  // namespace

TEST_CASE("D5: an inverted element is named with its place and time, and what was written stays") {
  const std::string path = "d05_history.csv";
  auto run = pushed(Solid{eos, strength}, everywhere, jump);
  {
    History history{path, {{"time", "s"}, {"height", "m"}}};
    const std::string message = told(run, Every{1e-3, [&] { history.row(run.time(), run.nodes().x(48).z()); }});
    CHECK_THAT(message, ContainsSubstring("strike: at t = 0.01") && ContainsSubstring("element 18 of part 0 at (") &&
                            ContainsSubstring("is inverted (volume -") && ContainsSubstring("let the material fail"));
  }
  std::ifstream file(path);
  std::size_t lines = 0;
  for (std::string line; std::getline(file, line); ++lines)
    CHECK_THAT(line, !ContainsSubstring("nan") && !ContainsSubstring("inf"));
  CHECK(lines == 1 + 10 + 1);  // the head, 0 to 9 ms, and the last state
  for (const auto& x : run.positions()) CHECK(x.allFinite());
  std::remove(path.c_str());
}

TEST_CASE("D5: an element that is crushed flat ends the run when its step has fallen to a millionth") {
  auto run = pushed(Solid{eos, strength}, everywhere, steady);
  CHECK_THAT(told(run), ContainsSubstring("strike: at t = 0.02") && ContainsSubstring("the time step has fallen to ") &&
                            ContainsSubstring("element 18 of part 0 at ("));
  // The volume falls linearly, and the step as its cube at the most: by a wave as 1/V, by the overlap as 1/V^2.
  CHECK(run.time() == Approx(4 / std::sqrt(3) / 100).epsilon(std::cbrt(1e-6)));
}

TEST_CASE("D5: where the material can fail the rest of the mesh runs on") {
  const FailureStrain failure{.failure_strain = 0.5};
  const VonMises hard{.shear_modulus = 5e8, .yield_stress = 1e8};  // above rho v^2: neighbours hold
  for (const Displacement u : {steady, jump}) {
    auto run = pushed(Solid{eos, hard, failure}, below, u);
    CHECK(told(run).empty());
    const std::vector<double> intact = run.template part<0>().field([](const auto& state) { return state.intact; });
    for (std::size_t e = 0; e < intact.size(); ++e) CHECK(intact[e] == (e == 18 ? 0 : 1));
    for (std::size_t i = 0; i < run.nodes().size(); ++i) CHECK((run.nodes().x(i) + run.nodes().v(i)).allFinite());
    CHECK(run.dt() > 1e-4);  // what has failed does not limit the step
  }
}
