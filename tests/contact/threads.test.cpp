#include <strike/contact/contact.hpp>
#include <strike/element/hex8.hpp>
#include <strike/load/initial_velocity.hpp>
#include <strike/mesh/surface.hpp>
#include <strike/mesh/transform.hpp>
#include <strike/motion/openmp.hpp>

#include "problems/column.hpp"
#include "support/catch.hpp"

using namespace strike;

TEST_CASE("contact gives the same bits for any number of threads") {
  const Mesh lower = box({.size = {1, 1, 0.3}, .cells = {9, 9, 3}});
  Mesh mesh = lower;
  append(mesh, rotated(box({.lower = {0.2, 0.1, 0.4}, .size = {0.5, 0.5, 0.5}, .cells = {6, 6, 6}}), {1, 0.2, 0}, 0.2));
  std::vector<Index> upper;
  for (Index i = static_cast<Index>(lower.nodes.size()); i < mesh.nodes.size(); ++i) upper.push_back(i);
  const Cells<8> of_upper(mesh.hexahedra.begin() + static_cast<std::ptrdiff_t>(lower.hexahedra.size()),
                          mesh.hexahedra.end());
  const auto after = [&](auto execution) {
    Explicit run{
        Scene{mesh.nodes, Part{Hex8{}, Elastic{1000, 1e9, 0.3}, mesh.hexahedra},
              Contact{TwoWay{Surface{surface(Mesh{mesh.nodes, of_upper})}, Surface{surface(lower)}}, Coulomb{0.2}},
              InitialVelocity{{0, 5, -20}, upper}},
        {},
        execution};
    for (int n = 0; n < 400; ++n) run.step();
    CHECK(run.template item<1>().impulse().z() > 10);
    return run.positions();
  };
  const auto serial = after(Serial{});
  CHECK(serial == after(OpenMP{1}));
  CHECK(serial == after(OpenMP{2}));
  CHECK(serial == after(OpenMP{5}));
}
