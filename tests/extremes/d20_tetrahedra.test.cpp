// Tetrahedra written as five nodes, the fifth the first.
#include <strike/dynamics/explicit.hpp>
#include <strike/element/tet4.hpp>
#include <strike/mesh/mixed_cells.hpp>

#include "problems/free_tetrahedra.hpp"
#include "support/catch.hpp"

using namespace strike;

TEST_CASE("D20: tetrahedra of five nodes are those of four, to the bit") {
  const Mesh four = free_tetrahedra::block(2, 0.2);
  std::vector<std::vector<Index>> list;
  for (const auto& [a, b, c, d] : four.tetrahedra) list.push_back({a, b, c, d, a});
  const Mesh five = sorted_by_kind(four.nodes, list).mesh;
  const auto shaken = [](const Mesh& mesh) {
    Explicit run{
        Scene{mesh.nodes, Part{Tet4{}, Elastic{1, 1, 0.3}, mesh.tetrahedra}, free_tetrahedra::RandomVelocity{0.05}}};
    for (int i = 0; i < 100; ++i) run.step();
    return run.positions();
  };
  CHECK(shaken(four) == shaken(five));
}

TEST_CASE("D20: a tetrahedron with coincident nodes is refused with its number and place") {
  const std::vector<Eigen::Vector3d> nodes{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 0}};
  CHECK_THROWS_WITH((Explicit{Scene{nodes, Part{Tet4{}, Elastic{1, 1, 0.3}, Cells<4>{{0, 1, 2, 3}}}}}),
                    Catch::Matchers::ContainsSubstring("element 0 of part 0 at (") &&
                        Catch::Matchers::ContainsSubstring("is flat or inside out (volume 0)"));
}
