// The step knows what is about to touch, and springs are not measured by a step that something else has shortened.
#include <algorithm>
#include <cmath>
#include <vector>

#include <strike/contact/contact.hpp>
#include <strike/contact/rigid_wall.hpp>
#include <strike/contact/spacing.hpp>
#include <strike/dynamics/explicit.hpp>
#include <strike/element/hex8.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/material/elastic.hpp>
#include <strike/material/eos/gruneisen.hpp>
#include <strike/material/solid.hpp>
#include <strike/material/strength/von_mises.hpp>
#include <strike/mesh/box.hpp>
#include <strike/mesh/transform.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {

/// Copper [mm, us, mg: km/s and GPa].
const Solid copper{GruneisenEos{.density = 8.93, .sound_speed = 3.94, .S1 = 1.489, .gamma = 2.02},
                   VonMises{.shear_modulus = 47, .yield_stress = 0.3}};

/// A bar along z of cells of 0.25, which flies at what is at z = `gap` below it, and another one there.
struct Bars {
  Mesh mesh = box({.size = {0.5, 0.5, 5}, .cells = {2, 2, 20}});
  Cells<8> upper = mesh.hexahedra, lower;
  Index first_node;
  std::vector<Index> upper_nodes, lower_nodes;

  explicit Bars(double gap)
      : first_node(append(mesh, box({.lower = {0, 0, -5 - gap}, .size = {0.5, 0.5, 5}, .cells = {2, 2, 20}}))) {
    lower.assign(mesh.hexahedra.begin() + static_cast<std::ptrdiff_t>(upper.size()), mesh.hexahedra.end());
    for (Index i = 0; i < mesh.nodes.size(); ++i) (i < first_node ? upper_nodes : lower_nodes).push_back(i);
  }
};

/// The largest error of the balance until the wave has run through a good part of the bar.
template <class... Items>
double error_of(const Bars& bars, double velocity, const Items&... items) {
  Explicit run{Scene{bars.mesh.nodes, Part{Hex8{ViscousHourglass{}}, copper, bars.mesh.hexahedra},
                     InitialVelocity{{0, 0, -velocity}, bars.upper_nodes}, items...},
               ExplicitOptions{.energy_tolerance = 1, .print_warnings = false}};
  double most = 0;
  run.until(0.3, [&] { most = std::max(most, std::abs(run.energy().error())); });
  double lowest = 1;
  for (const Index i : bars.upper_nodes)  // of its face: inner nodes of a crushed mesh may come out of it
    if (bars.mesh.nodes[i].z() == 0) lowest = std::min(lowest, run.nodes().x(i).z());
  CHECK(lowest > -0.35);  // within a cell of where it is stopped
  return most;
}

/// The run ends with the sentence of a law whose springs are too soft.
template <class... Arguments>
void check_cannot(const Arguments&... arguments) {
  CHECK_THROWS_WITH(error_of(arguments...), Catch::Matchers::ContainsSubstring("more than a cell") &&
                                                Catch::Matchers::ContainsSubstring("take Kinematic"));
}

}  // namespace

TEST_CASE("the balance closes to half a per cent, however fast things meet, or the law says that it cannot") {
  const Mesh block =
      box({.lower = {-5, -5, -2.05}, .size = {10.5, 10.5, 2}, .cells = {3, 3, 1}});  // coarser than the bar
  for (const double v : {0.001, 0.5, 2.0, 3.0, 4.0, 6.0, 10.0}) {                    // the speed of sound is 3.94
    CAPTURE(v);
    const Bars alone(100);
    const double ground = v < 0.01 ? 1e-5 : 0.05;
    const RigidPlane plane{{0, 0, -ground}, {0, 0, 1}};
    const NodeToRigid on_plane{alone.upper_nodes, plane};
    const NodeToRigid on_ball{alone.upper_nodes, RigidSphere{{0.25, 0.25, -1000 - ground}, 1000}};
    const NodeToRigid on_faces{alone.upper_nodes, RigidSurface{block.nodes, surface(block)}};
    CHECK(error_of(alone, v, RigidWall{plane.point, plane.normal, alone.upper_nodes}) < 0.0075);
    CHECK(error_of(alone, v, Contact{on_ball}) < 0.0075);
    CHECK(error_of(alone, v, Contact{on_faces}) < 0.0075);
    if (v > 8) {
      check_cannot(alone, v, Contact{on_plane, Penalty{}});
    } else {
      CHECK(error_of(alone, v, Contact{on_plane, Penalty{}}) < 0.005);
      CHECK(error_of(alone, v, Contact{on_ball, Penalty{}}) < 0.005);
      CHECK(error_of(alone, v, Contact{on_faces, Penalty{}}) < 0.005);
    }
  }
  for (const double v : {0.5, 2.5, 5.0}) {
    CAPTURE(v);
    const Bars pair(0.01);
    const InitialVelocity against{{0, 0, v}, pair.lower_nodes};
    const TwoWay skins{Surface{hexahedron_surface(pair.upper)}, Surface{hexahedron_surface(pair.lower)}};
    CHECK(error_of(pair, v, against, Contact{skins}) < 0.005);
    if (v < 5)
      CHECK(error_of(pair, v, against, Contact{skins, Penalty{}}) < 0.005);
    else
      check_cannot(pair, v, against, Contact{skins, Penalty{}});
    if (v > 1) check_cannot(pair, v, against, Contact{skins, Penalty{.fraction = 1e-4}});
  }
}

TEST_CASE("what flies past shortens no step") {
  const Bars alone(100);
  const auto step_of = [&](const auto&... items) {
    return Explicit{Scene{alone.mesh.nodes, Part{Hex8{ViscousHourglass{}}, copper, alone.mesh.hexahedra},
                          InitialVelocity{{0, 0, -5}, alone.upper_nodes}, items...}}
        .stable_step()
        .dt;
  };
  const double free = step_of();
  CHECK(step_of(RigidWall{{0, 0, -10}, {0, 0, 1}, alone.upper_nodes}) == free);    // far
  CHECK(step_of(RigidWall{{0, 0, -1e-9}, {1, 0, 0}, alone.upper_nodes}) == free);  // along it
  CHECK(step_of(RigidWall{{0, 0, -1e-9}, {0, 0, -1}, alone.lower_nodes}) == free);
  const double near = step_of(RigidWall{{0, 0, -1e-9}, {0, 0, 1}, alone.upper_nodes});
  CHECK(near * 5 == Approx(detail::closing_share * 0.25).epsilon(1e-6));  // from gap 0, a share of the cell
  CHECK(near < free);
}

TEST_CASE("springs answer alike with any step factor") {
  const Elastic elastic{.density = 1, .youngs_modulus = 1, .poissons_ratio = 0};
  const auto strike_with = [&](double factor) {
    const Bars bars(0);
    Explicit run{Scene{bars.mesh.nodes, Part{Hex8{ViscousHourglass{}}, elastic, bars.mesh.hexahedra},
                       InitialVelocity{{0, 0, -0.01}, bars.upper_nodes},
                       Contact{TwoWay{Surface{hexahedron_surface(bars.upper)}, Surface{hexahedron_surface(bars.lower)}},
                               Penalty{}}},
                 ExplicitOptions{.step_factor = factor}};
    double deepest = 0;
    run.until(5, [&] { deepest = std::max(deepest, run.template item<2>().penetration()); });
    return deepest;
  };
  const double expected = strike_with(0.9);
  for (const double factor : {0.45, 0.1}) CHECK(strike_with(factor) == Approx(expected).epsilon(0.02));
}

TEST_CASE("the spacing of points is the distance to the nearest, but for bodies that nearly touch") {
  std::vector<Eigen::Vector3d> points = box({.size = {20, 3, 40}, .cells = {20, 3, 40}}).nodes;
  const std::size_t n = points.size();
  points.push_back(points[0]);           // in the same place
  points.push_back({0.25, 0.0, 0.0});    // near the first
  points.push_back({20, 3, 40 + 1e-9});  // of a body that nearly touches
  points.push_back({0.25, -2e9, 0.0});   // far from all
  const auto distance = detail::spacing(points);
  CHECK(distance[0] == Approx(0.25));
  CHECK(distance[n / 2] == Approx(1));
  CHECK(distance[n] == Approx(0.25));
  CHECK(distance[n + 1] == Approx(0.25));
  CHECK(distance[n + 2] == Approx(0.1));
  CHECK(distance[n + 3] == Approx(2e9));
  CHECK(detail::spacing(std::vector<Eigen::Vector3d>{{1, 2, 3}})[0] > 1e300);
  CHECK(detail::spacing({}).empty());
  for (Index i = 0; i < n; i += 97) {  // against all pairs
    double least = 1e300;
    for (std::size_t j = 0; j < points.size(); ++j)
      if (const double apart = (points[j] - points[i]).norm(); apart > 0) least = std::min(least, apart);
    CHECK(distance[i] == Approx(std::max(least, 0.1)));
  }
}
