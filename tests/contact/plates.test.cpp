#include <algorithm>
#include <cmath>
#include <vector>

#include <strike/contact/contact.hpp>
#include <strike/element/hex8.hpp>
#include <strike/element/plate4.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/material/eos/cubic.hpp>
#include <strike/material/fluid.hpp>
#include <strike/material/plane_stress.hpp>
#include <strike/mesh/sheet.hpp>
#include <strike/mesh/surface.hpp>
#include <strike/mesh/transform.hpp>
#include <strike/section/layered.hpp>

#include "problems/column.hpp"
#include "support/catch.hpp"

using namespace strike;

namespace {

/// A soft block that flies at a clamped sheet of aluminium of 4 mm, obliquely, from above or from below [m, s, kg].
template <class... Policies>
void strike_sheet(double side, double depth, const Policies&... policies) {
  const double thickness = 4e-3, v = 100;
  const Mesh panel = rectangle({.lower = {-0.2, -0.2, 0}, .size = {0.4, 0.4}, .cells = {16, 16}});
  Mesh mesh = panel;
  const double gap = 0.5 * thickness + 1e-4, length = 0.12;
  const Index first = append(
      mesh,
      box({.lower = {-0.05, -0.05, side > 0 ? gap : -gap - length}, .size = {0.1, 0.1, length}, .cells = {6, 6, 7}}));
  std::vector<Index> soft;
  for (Index i = first; i < mesh.nodes.size(); ++i) soft.push_back(i);
  const Surface sheet_surface{quadrilateral_surface(mesh.quadrilaterals), thickness};
  const Surface skin{surface(Mesh{mesh.nodes, mesh.hexahedra})};
  Explicit run{Scene{
      mesh.nodes, Part{Plate4{}, Homogeneous{PlaneStress{Elastic{2700, 70e9, 0.33}}, thickness}, mesh.quadrilaterals},
      Part{Hex8{}, Elastic{950, 5e7, 0.4}, mesh.hexahedra}, Contact{TwoWay{skin, sheet_surface}, policies...},
      Clamped{nodes_where(panel.nodes, [](const Eigen::Vector3d& x) { return x.cwiseAbs().maxCoeff() > 0.199; })},
      InitialVelocity{{0.3 * v, 0, -side * v}, soft}}};
  double deepest = 0, drift = 0;
  const double end = 1.5e-3;
  run.until(end, [&] {
    deepest = std::max(deepest, run.template item<2>().penetration());
    if (run.time() < 0.95 * end) drift = std::max(drift, std::abs(run.energy().error()));
  });
  CHECK(deepest < depth * thickness);
  CHECK(drift < 0.01);
  CHECK(side * run.template item<2>().impulse().z() > 0.5 * 950 * 0.1 * 0.1 * length * v);
  CHECK(run.energy().contact > -1e-6 * run.energy().initial);
  int through = 0;
  std::vector<Eigen::Vector3d> sheet_now = run.positions();
  for (auto& x : sheet_now) x.z() = 0;
  for (const Index i : soft) {  // on the side from which it came, of the node of the sheet next to it
    const Eigen::Vector3d x = run.nodes().x(i);
    const Index nearest = nearest_node({sheet_now.data(), panel.nodes.size()}, {x.x(), x.y(), 0});
    if (side * (x - run.nodes().x(nearest)).z() < 0) ++through;
  }
  CHECK(through == 0);
}

}  // namespace

TEST_CASE("a plate is struck on both sides, half its thickness away, and nothing comes through") {
  for (const double side : {1.0, -1.0}) {
    strike_sheet(side, 0.01);
    strike_sheet(side, 0.5, Penalty{}, Coulomb{0.2});  // a spring of the light sheet's nodes under a block
  }
}

TEST_CASE("nodes that two contacts press on keep the balance") {
  const Mesh mesh = box({.size = {1, 1, 1}, .cells = {2, 2, 2}});
  const RigidPlane floor{{0, 0, 0}, {0, 0, 1}}, wall{{0, 0, 0}, {1, 1, 1}};
  Explicit run{Scene{
      mesh.nodes,
      Part{Hex8{StiffnessHourglass{}, HughesWinget{}, NoBulkViscosity{}}, Elastic{1000, 1e7, 0.3}, mesh.hexahedra},
      Contact{NodeToRigid{all_nodes(mesh.nodes), floor}}, Contact{NodeToRigid{all_nodes(mesh.nodes), wall}},
      InitialVelocity{{-0.01, -0.015, -0.02}}}};
  double drift = 0;
  for (int n = 0; n < 300; ++n) run.step(), drift = std::max(drift, std::abs(run.energy().error()));
  CHECK(drift < 1e-4);
}
