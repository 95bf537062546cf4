// Wedges and pyramids of three formats: the same two cells, one beside the other.
#include <strike/input/read_mesh.hpp>
#include <strike/mesh/check.hpp>
#include <strike/mesh/measure.hpp>
#include <strike/mesh/surface.hpp>

#include "support/catch.hpp"

using namespace strike;

namespace {

/// A wedge of 1 x 1 x 3 on the triangle under the diagonal, and a pyramid of the height 2 on its quadrilateral at y =
/// 0.
void is_the_pair(const Deck& deck) {
  const Mesh& mesh = deck.mesh;
  REQUIRE(mesh.hexahedra.size() == 2);
  REQUIRE(mesh.nodes.size() == 7);
  check(mesh);
  CHECK(hexahedron_volume(mesh.nodes, mesh.hexahedra[0]) == Approx(1.5).epsilon(1e-15));
  CHECK(hexahedron_volume(mesh.nodes, mesh.hexahedra[1]) == Approx(2).epsilon(1e-15));
  const auto& w = mesh.hexahedra[0];
  const auto& p = mesh.hexahedra[1];
  CHECK((w[2] == w[3] && w[6] == w[7]));
  CHECK((p[4] == p[5] && p[4] == p[6] && p[4] == p[7]));
  CHECK(surface(mesh).size() == 5 + 5 - 2);
}

constexpr const char* nodes[7]{"0,0,0", "1,0,0", "0,1,0", "0,0,3", "1,0,3", "0,1,3", "0.5,-2,1.5"};

std::string listed(const char* separator) {
  std::string text;
  for (int n = 0; n < 7; ++n) {
    std::string place = nodes[n];
    for (char& c : place)
      if (c == ',') c = *separator;
    text += std::to_string(n + 1) + separator + place + "\n";
  }
  return text;
}

}  // namespace

TEST_CASE("wedges and pyramids: types 6 and 7 of gmsh, C3D6 and C3D5 of Abaqus, degenerate solids of LS-DYNA") {
  is_the_pair(read_gmsh("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n7\n" + listed(" ") +
                            "$EndNodes\n$Elements\n2\n1 6 2 1 1 1 2 3 4 5 6\n2 7 2 1 1 1 2 5 4 7\n$EndElements\n",
                        "pair.msh"));
  is_the_pair(read_abaqus(
      "*NODE\n" + listed(",") + "*ELEMENT, TYPE=C3D6\n1,1,2,3,4,5,6\n*ELEMENT, TYPE=C3D5H\n2,1,2,5,4,7\n", "pair.inp"));
  is_the_pair(read_abaqus("*NODE\n" + listed(",") + "*ELEMENT, TYPE=C3D8R\n1,1,2,3,3,4,5,6,6\n2,1,2,5,4,7,7,7,7\n",
                          "pair.inp"));
  // n1 n2 n3 n4 n5 n5 n6 n6, its wedge, from the quadrilateral at y = 0 to the edge at y = 1.
  is_the_pair(
      read_dyna("*KEYWORD\n*NODE\n" + listed(",") + "*ELEMENT_SOLID\n1,1,2,1,4,5,3,3,6,6\n2,1,1,2,5,4,7,7,7,7\n*END\n",
                "pair.k"));
}

TEST_CASE("wedges and pyramids: their faces in surfaces of Abaqus look outward, and free ones are found") {
  const AbaqusDeck deck =
      read_abaqus("*NODE\n" + listed(",") +
                      "*ELEMENT, TYPE=C3D6, ELSET=all\n1,1,2,3,4,5,6\n*ELEMENT, TYPE=C3D5, ELSET=all\n2,1,2,5,4,7\n"
                      "*SURFACE, NAME=top\n1,S2\n*SURFACE, NAME=side\n1,S4\n*SURFACE, NAME=slope\n2,S3\n"
                      "*SURFACE, NAME=skin\nall,\n",
                  "pair.inp");
  const auto area = [&](const char* name) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const auto& segment : deck.surface(name).side.segments) sum += area_vector(deck.mesh.nodes, Face{segment, 0});
    return sum;
  };
  CHECK(area("top") == Eigen::Vector3d(0, 0, 0.5));
  CHECK(area("side") == Eigen::Vector3d(3, 3, 0));       // between 2-3 and 5-6
  CHECK(area("slope") == Eigen::Vector3d(3, -0.75, 0));  // 2, 5 and the apex: (0 0 3) x (-0.5 -2 1.5) / 2, outward
  CHECK(deck.surface("skin").side.segments.size() == 5 + 5 - 2);
  CHECK(area("skin").norm() < 1e-15);
}
