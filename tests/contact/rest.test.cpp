// Bodies that lie on others come to rest, and stay or slide by Coulomb.
#include <algorithm>
#include <cmath>
#include <vector>

#include <strike/contact/contact.hpp>
#include <strike/dynamics/dynamic_relaxation.hpp>
#include <strike/dynamics/explicit.hpp>
#include <strike/element/hex8.hpp>
#include <strike/element/hourglass.hpp>
#include <strike/load/body_force.hpp>
#include <strike/load/nodal_force.hpp>
#include <strike/load/support.hpp>
#include <strike/material/elastic.hpp>
#include <strike/mesh/box.hpp>
#include <strike/mesh/surface.hpp>
#include <strike/mesh/transform.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {

/// A block above a slab that is clamped from below; their cells do not fit.
struct Stack {
  Mesh mesh;
  Index first;
  Surface slab;
  std::vector<Index> base, block;

  explicit Stack(double gap, double length = 3)
      : mesh(box({.lower = {0, 0, -1}, .size = {length, 3, 1}, .cells = {5, 5, 2}})),
        first(static_cast<Index>(mesh.nodes.size())),
        slab(hexahedron_surface(mesh.hexahedra)) {
    append(mesh, box({.lower = {0.7, 0.7, gap}, .size = {1.5, 1.5, 1}, .cells = {4, 4, 2}}));
    base = nodes_where(mesh.nodes, on_plane(Axis::z, -1));
    for (Index i = first; i < mesh.nodes.size(); ++i) block.push_back(i);
  }
};

}  // namespace

TEST_CASE("a block relaxes to rest on a slab under its weight") {
  const Elastic elastic{.density = 1, .youngs_modulus = 100, .poissons_ratio = 0};
  for (const double gap : {0.0, 0.001}) {
    const auto rest = [&](auto law) {
      const Stack stack(gap);
      Explicit run{Scene{stack.mesh.nodes, Part{Hex8{StiffnessHourglass{}}, elastic, stack.mesh.hexahedra},
                         Clamped{stack.base}, Support{all_nodes(stack.mesh.nodes), {unit(Axis::x), unit(Axis::y)}},
                         NodalForce{{0, 0, -0.01}, stack.block}, Contact{NodeToSurface{stack.block, stack.slab}, law}},
                   {},
                   DynamicRelaxation{}};
      run.until(200);
      CHECK(run.damping().is_at_rest());
      CHECK(run.warnings().empty());
      const double weight = 0.01 * static_cast<double>(stack.block.size());
      CHECK(run.template item<4>().force().z() == Approx(weight).epsilon(1e-4));
      CHECK(std::abs(run.energy().error()) < 0.01);
    };
    rest(Kinematic{});
    rest(Penalty{.fraction = 0.1});
    rest(Penalty{.stiffness = 5});
  }
}

TEST_CASE("a block of hexahedra stays on a slope below the angle of friction, and slides above it by Coulomb") {
  // The weight is put on slowly, then the slope, so that the normal force does not swing: 20 periods of the block each.
  const double mu = 0.3, g = 1, put_on = 3;
  const Elastic stiff{.density = 1, .youngs_modulus = 1000, .poissons_ratio = 0.3};
  const auto smooth = [](double t) { return t <= 0 ? 0.0 : t >= 1 ? 1.0 : t * t * (3 - 2 * t); };
  struct Motion {
    double way, velocity;
  };
  const auto slide = [&](double slope, auto law) {
    const Stack stack(0, 9);
    Explicit run{Scene{stack.mesh.nodes, Part{Hex8{StiffnessHourglass{}}, stiff, stack.mesh.hexahedra},
                       Clamped{nodes_where(stack.mesh.nodes, [](const auto& x) { return x.z() < -1e-9; })},
                       BodyForce{{0, 0, -g}, [&](double t) { return smooth(t / put_on); }},
                       BodyForce{{slope * mu * g, 0, 0}, [&](double t) { return smooth((t - put_on) / put_on); }},
                       Contact{NodeToSurface{stack.block, stack.slab}, law, Coulomb{mu}}},
                 ExplicitOptions{.print_warnings = false}};
    const auto now = [&] {
      Motion sum{0, 0};
      double mass = 0;
      for (const Index i : stack.block) {
        const double m = run.nodes().mass(i);
        sum.way += m * (run.nodes().x(i) - stack.mesh.nodes[i]).x(), sum.velocity += m * run.nodes().v(i).x(),
            mass += m;
      }
      return Motion{sum.way / mass, sum.velocity / mass};
    };
    run.until(2 * put_on);
    const Motion before = now();
    run.until(2 * put_on + 2);
    return std::pair{before, now()};
  };
  const auto check = [&](auto law) {
    const auto [stays, still] = slide(0.95, law);
    CHECK(std::abs(stays.way) < 3e-3);              // shear, rocking, and slip at the edges while the load comes
    CHECK(std::abs(still.way - stays.way) < 5e-5);  // what still swings
    const auto [starts, slides] = slide(1.1, law);
    CHECK((slides.velocity - starts.velocity) / 2 == Approx(0.1 * mu * g).epsilon(0.01));
  };
  check(Kinematic{});
  check(Penalty{});
}
