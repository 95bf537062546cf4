#include <algorithm>
#include <cmath>

#include <strike/contact/contact.hpp>
#include <strike/element/hex8.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/mesh/surface.hpp>
#include <strike/mesh/transform.hpp>

#include "problems/column.hpp"
#include "support/catch.hpp"

using namespace strike;

TEST_CASE("D12: rubber that meets steel enters it by less than 5 % of an element, without chatter") {
  const double h = 0.02, v = 2;  // m, m/s
  const Mesh steel = box({.size = {0.2, 0.2, 0.06}, .cells = {6, 6, 2}});
  const Mesh rubber = box({.lower = {0.05, 0.05, 0.0601}, .size = {0.1, 0.1, 0.1}, .cells = {5, 5, 5}});
  const auto drop = [&](auto... policies) {
    Mesh mesh = steel;
    const Index first = append(mesh, rubber);
    const Cells<8> of_rubber(mesh.hexahedra.end() - 125, mesh.hexahedra.end());
    std::vector<Index> rubber_nodes;
    for (Index i = first; i < mesh.nodes.size(); ++i) rubber_nodes.push_back(i);
    const std::vector<Face> soft = surface(Mesh{mesh.nodes, of_rubber}), hard = surface(steel);
    Explicit run{Scene{mesh.nodes, Part{Hex8{}, Elastic{7850, 2e11, 0.3}, steel.hexahedra},
                       Part{Hex8{}, Elastic{1000, 1e6, 0.45}, of_rubber},
                       Contact{NodeToSurface{surface_nodes(soft), Surface{hard}}, policies...},
                       InitialVelocity{{0, 0, -v}, rubber_nodes}}};
    double deepest = 0, lowest = 0, taken = 0;
    run.until(5e-3, [&] {
      deepest = std::max(deepest, run.template item<2>().penetration());
      lowest = std::min(lowest, run.energy().contact);
      taken = std::max(taken, std::abs(run.energy().contact));
    });
    CHECK(deepest < 0.05 * h);
    CHECK(lowest > -1e-6 * run.energy().initial);
    CHECK(std::abs(run.energy().error()) < 1e-2);
    return taken / run.energy().initial;
  };
  CHECK(drop(Kinematic{}) < 0.11);  // inelastic impacts take 1/(2 N) of what meets a stiff surface with N = 5 elements
  CHECK(drop(Penalty{}) < 0.11);    // stored for a while
}
