// Elements that have failed: free particles.
#include <cmath>

#include <strike/contact/rigid_wall.hpp>
#include <strike/dynamics/explicit.hpp>
#include <strike/element/tet4.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/load/prescribed_motion.hpp>
#include <strike/material/eos/linear.hpp>
#include <strike/material/failure/failure.hpp>
#include <strike/material/solid.hpp>
#include <strike/material/strength/von_mises.hpp>
#include <strike/mesh/box.hpp>
#include <strike/mesh/select.hpp>
#include <strike/mesh/tetrahedra.hpp>

#include "support/catch.hpp"

using namespace strike;
using Catch::Matchers::ContainsSubstring;

namespace {

/// Fails at once.
const Solid dust{LinearEos{.density = 1000, .bulk_modulus = 1e9}, VonMises{.shear_modulus = 5e8, .yield_stress = 1e6},
                 UltimateStress{0}};
const Mesh block = tetrahedralized(box({.size = {1, 1, 1}, .cells = {3, 3, 3}}));

template <class... Things>
auto dust_run(double largest_step, Things... things) {
  return Explicit{
      Scene{block.nodes, Part{Tet4{}, dust, block.tetrahedra, Erosion{}}, InitialVelocity{{0, 0, -100}}, things...},
      ExplicitOptions{.largest_step = largest_step}};
}

}  // namespace

TEST_CASE("D31: what has failed from the start flies freely, and gives a wall its whole momentum") {
  auto run = dust_run(1e-4, RigidWall{{0, 0, 0}, {0, 0, 1}});
  CHECK(run.part<0>().deleted() == block.tetrahedra.size());
  double worst = 0;
  run.until(5e-3, [&] { worst = std::max(worst, std::abs(run.energy().error())); });
  CHECK(std::abs(double(run.steps()) - 50) <= 1);  // no element bounds them
  CHECK(run.momentum().z() < -1000 * 100 * 0.4);
  for (std::size_t i = 0; i < block.nodes.size(); ++i)
    if (block.nodes[i].z() > 0.6) CHECK((run.nodes().v(i) - Eigen::Vector3d(0, 0, -100)).norm() == 0);
  run.until(0.011, [&] { worst = std::max(worst, std::abs(run.energy().error())); });
  CHECK(run.item<2>().impulse().z() == Approx(1000 * 100).epsilon(1e-12));
  CHECK(run.energy().contact == Approx(run.energy().initial).epsilon(1e-12));
  CHECK(worst < 1e-12);
}

TEST_CASE("D31: where nothing bounds the step the user must") {
  auto run = dust_run(std::numeric_limits<double>::infinity());
  CHECK_THROWS_WITH(run.until(1), ContainsSubstring("no element is left that bounds the step; give a `.largest_step`"));
}

TEST_CASE("D36: a node of failed elements moves as it is told, and its work is external") {
  const std::vector<Index> top = nodes_where(block.nodes, on_plane(Axis::z, 1));
  auto run = dust_run(1e-4, PrescribedVelocity{Axis::z, top, [](double t) { return 1000 * t; }});
  const double initial = run.energy().initial;
  run.until(0.01);
  for (const Index i : top) CHECK(run.nodes().x(i).z() == Approx(1 + 0.5 * 1000 * 1e-4).epsilon(1e-3));
  CHECK(run.energy().external != 0);
  CHECK(std::abs(run.energy().imbalance()) < 1e-9 * initial);
}
