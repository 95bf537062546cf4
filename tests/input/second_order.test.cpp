// Cells of second order in three formats, cut to first order.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <strike/input/read_mesh.hpp>
#include <strike/mesh/box.hpp>
#include <strike/mesh/check.hpp>
#include <strike/mesh/measure.hpp>
#include <strike/mesh/second_order.hpp>
#include <strike/mesh/surface.hpp>
#include <strike/mesh/tetrahedra.hpp>

#include "support/catch.hpp"
#include "written.hpp"

using namespace strike;
using Catch::Matchers::ContainsSubstring;
using Kind = detail::SecondOrderKind;

namespace {

const ReadOptions in_pieces{.second_order = SecondOrder::in_pieces};
const ReadOptions to_corners{.second_order = SecondOrder::to_corners};

/// Cells of one kind by their nodes, corners first and mid nodes in the order of Abaqus's edges, faces, centre.
struct Quadratic {
  Kind kind;
  std::vector<Eigen::Vector3d> nodes;
  std::size_t corners;  ///< of a cell; those of all cells stand before all mid nodes
  std::size_t first_mid;
  std::vector<std::vector<Index>> cells = {};
};
template <std::size_t N>
Quadratic quadratic(Kind kind, std::vector<Eigen::Vector3d> nodes, const Cells<N>& cells) {
  Quadratic all{kind, std::move(nodes), N, 0, {}};
  all.first_mid = all.nodes.size();
  std::map<std::vector<Index>, Index> known;
  for (const auto& cell : cells) {
    std::vector<Index> whole(cell.begin(), cell.end());
    for (const detail::MidNode& mid : detail::mid_nodes(kind)) {
      std::vector<Index> key;
      Eigen::Vector3d x = Eigen::Vector3d::Zero();
      for (std::size_t i = 0; i < mid.count; ++i) key.push_back(cell[mid.corners[i]]), x += all.nodes[key.back()];
      std::sort(key.begin(), key.end());
      const auto [place, is_new] = known.try_emplace(key, static_cast<Index>(all.nodes.size()));
      if (is_new) all.nodes.push_back(x / static_cast<double>(mid.count));
      whole.push_back(place->second);
    }
    all.cells.push_back(whole);
  }
  return all;
}
/// Mid nodes moved by up to a tenth of the edges, in all directions.
void bend(Quadratic& mesh, double by) {
  for (std::size_t n = mesh.first_mid; n < mesh.nodes.size(); ++n)
    for (int i = 0; i < 3; ++i) mesh.nodes[n][i] += by * std::sin(3.7 * double(n) + 1.9 * i);
}

/// Places of gmsh's mid nodes among those of Abaqus, as the manual of gmsh draws them: pairs of corners by edge.
std::vector<std::size_t> gmsh_order(Kind kind) {
  if (kind == Kind::tetrahedron10) return {0, 1, 2, 3, 5, 4};
  if (kind == Kind::hexahedron27 || kind == Kind::hexahedron20) {
    std::vector<std::size_t> order{0, 3, 8, 1, 9, 2, 10, 11, 4, 7, 5, 6, 12, 14, 17, 15, 16, 13, 18};
    order.resize(kind == Kind::hexahedron20 ? 12 : 19);
    return order;
  }
  if (kind == Kind::wedge18 || kind == Kind::wedge15) {
    std::vector<std::size_t> order{0, 2, 6, 1, 7, 8, 3, 5, 4, 9, 11, 10};
    order.resize(kind == Kind::wedge15 ? 9 : 12);
    return order;
  }
  if (kind == Kind::pyramid13) return {0, 3, 4, 1, 5, 2, 6, 7};
  std::vector<std::size_t> order(detail::mid_nodes(kind).size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  return order;
}
int gmsh_type(Kind kind) {
  return std::map<Kind, int>{{Kind::triangle6, 9},      {Kind::quadrilateral8, 16}, {Kind::quadrilateral9, 10},
                             {Kind::tetrahedron10, 11}, {Kind::hexahedron20, 17},   {Kind::hexahedron27, 12},
                             {Kind::wedge15, 18},       {Kind::wedge18, 13},        {Kind::pyramid13, 19}}
      .at(kind);
}
std::string abaqus_type(Kind kind) {
  return std::map<Kind, std::string>{
      {Kind::triangle6, "STRI65"},     {Kind::quadrilateral8, "S8R"},  {Kind::quadrilateral9, "S9R5"},
      {Kind::tetrahedron10, "C3D10M"}, {Kind::hexahedron20, "C3D20R"}, {Kind::hexahedron27, "C3D27"},
      {Kind::wedge15, "C3D15"},        {Kind::wedge18, "C3D15V"},      {Kind::pyramid13, "C3D13"}}
      .at(kind);
}
/// Nodes are numbered from the end, so that no order of theirs hides a fault.
std::string number(const Quadratic& mesh, Index node) { return std::to_string(10 + mesh.nodes.size() - node); }
std::string node_lines(const Quadratic& mesh, const std::string& separator) {
  std::string text;
  for (Index n = 0; n < mesh.nodes.size(); ++n) {
    const auto& x = mesh.nodes[n];
    text += number(mesh, n) + separator + exact(x[0]) + separator + exact(x[1]) + separator + exact(x[2]) + "\n";
  }
  return text;
}
/// The first cell is of group 1, the others of group 2; both are of solids.
std::string as_gmsh(const Quadratic& mesh, const std::string& marks = "", std::size_t mark_count = 0) {
  const std::string dimension = mesh.kind <= Kind::quadrilateral9 ? "2" : "3";
  std::string text = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n3\n" + dimension + " 1 \"one\"\n" +
                     dimension + " 2 \"others\"\n2 3 \"foot\"\n$EndPhysicalNames\n$Nodes\n" +
                     std::to_string(mesh.nodes.size()) + "\n" + node_lines(mesh, " ") + "$EndNodes\n$Elements\n" +
                     std::to_string(mesh.cells.size() + mark_count) + "\n";
  const auto order = gmsh_order(mesh.kind);
  for (std::size_t e = 0; e < mesh.cells.size(); ++e) {
    text += std::to_string(e + 1) + " " + std::to_string(gmsh_type(mesh.kind)) + " 2 " + (e == 0 ? "1 1" : "2 2");
    for (std::size_t i = 0; i < mesh.corners; ++i) text += " " + number(mesh, mesh.cells[e][i]);
    for (const std::size_t m : order) text += " " + number(mesh, mesh.cells[e][mesh.corners + m]);
    text += "\n";
  }
  return text + marks + "$EndElements\n";
}
std::string as_abaqus(const Quadratic& mesh) {
  std::string text = "*NODE\n" + node_lines(mesh, ",");
  for (std::size_t e = 0; e < mesh.cells.size(); ++e) {
    std::vector<Index> cell = mesh.cells[e];
    if (mesh.kind == Kind::hexahedron27) std::rotate(cell.begin() + 20, cell.end() - 1, cell.end());
    text += "*ELEMENT, TYPE=" + abaqus_type(mesh.kind) + ", ELSET=" + (e == 0 ? "one" : "others") + "\n" +
            std::to_string(e + 1);
    for (std::size_t i = 0; i < cell.size(); ++i) text += (i % 10 == 7 ? ",\n" : ",") + number(mesh, cell[i]);
    text += "\n";
  }
  return text;
}
std::string as_dyna(const Quadratic& mesh) {
  std::string text = "*KEYWORD\n*NODE\n" + node_lines(mesh, ",");
  const char* const keyword = mesh.kind == Kind::tetrahedron10  ? "*ELEMENT_SOLID\n"
                              : mesh.kind == Kind::hexahedron20 ? "*ELEMENT_SOLID_H20\n"
                                                                : "*ELEMENT_SOLID_H27\n";
  text += keyword;
  for (std::size_t e = 0; e < mesh.cells.size(); ++e) {
    text += std::to_string(e + 1) + "," + (e == 0 ? "1" : "2");
    for (std::size_t i = 0; i < mesh.cells[e].size(); ++i)
      text += (i % 10 == 0 ? "\n" : ",") + number(mesh, mesh.cells[e][i]);
    text += "\n";
  }
  return text + "*SET_SOLID\n1\n1\n*END\n";
}

/// Of a surface its area, the sum of its area vectors, and whether each edge has two faces that run along it both ways.
struct Skin {
  double area = 0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  bool is_closed = true;
};
Skin skin_of(const Mesh& mesh) {
  Skin skin;
  std::map<std::pair<Index, Index>, int> edges;
  for (const Face& face : surface(mesh)) {
    const Eigen::Vector3d a = area_vector(mesh.nodes, face);
    skin.area += a.norm(), skin.sum += a;
    const std::size_t corners = face.nodes[2] == face.nodes[3] ? 3 : 4;
    for (std::size_t i = 0; i < corners; ++i) {
      const Index from = face.nodes[i], to = face.nodes[(i + 1) % corners];
      edges[{std::min(from, to), std::max(from, to)}] += from < to ? 1 : -1;
    }
  }
  for (const auto& [edge, count] : edges) skin.is_closed = skin.is_closed && count == 0;
  return skin;
}
bool warns(const Deck& deck, const std::string& what) {
  return std::any_of(deck.warnings.begin(), deck.warnings.end(),
                     [&](const std::string& warning) { return warning.find(what) != warning.npos; });
}

/// A box of 1 x 2 x 3 in 5 tetrahedra for each of two bricks.
Quadratic tetrahedra_of_box() {
  const Mesh bricks = box({.size = {1, 2, 3}, .cells = {1, 1, 2}});
  const Mesh mesh = tetrahedralized(bricks, Split::five);
  return quadratic(Kind::tetrahedron10, mesh.nodes, mesh.tetrahedra);
}
Quadratic bricks(Kind kind) {
  const Mesh mesh = box({.size = {1, 2, 3}, .cells = {1, 2, 2}});
  return quadratic(kind, mesh.nodes, mesh.hexahedra);
}
const std::vector<Eigen::Vector3d> prism{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 2},
                                         {1, 0, 2}, {0, 1, 2}, {1, 1, 0}, {1, 1, 2}};
Quadratic wedges(Kind kind) { return quadratic(kind, prism, Cells<6>{{0, 1, 2, 3, 4, 5}, {1, 6, 2, 4, 7, 5}}); }

}  // namespace

TEST_CASE("second order: tetrahedra of ten nodes in eight pieces, from three formats") {
  Quadratic mesh = tetrahedra_of_box();
  const std::size_t parents = mesh.cells.size();
  for (const double by : {0.0, 0.06}) {
    bend(mesh, by);
    std::vector<Deck> decks{read_gmsh(as_gmsh(mesh), "a.msh", in_pieces),
                            read_abaqus(as_abaqus(mesh), "a.inp", in_pieces),
                            read_dyna(as_dyna(mesh), "a.k", in_pieces)};
    for (const Deck& deck : decks) {
      REQUIRE(deck.mesh.tetrahedra.size() == 8 * parents);
      CHECK(deck.mesh.nodes.size() == mesh.nodes.size());
      check(deck.mesh);  // all corners right-handed, no unused node
      const Skin skin = skin_of(deck.mesh);
      CHECK(skin.is_closed);
      CHECK(skin.sum.norm() < 1e-13);
      if (by == 0) {
        CHECK(volume(deck.mesh) == Approx(6).epsilon(1e-14));
        CHECK(skin.area == Approx(22).epsilon(1e-14));
      }
      CHECK(deck.cell_numbers.size() == 8 * parents);
      CHECK(deck.cell_numbers[7] == 1);
      CHECK(deck.cell_numbers[8] == 2);
      CHECK(warns(deck, "Cells of second order were cut to first: tetrahedra of 10 nodes (" + std::to_string(parents) +
                            ") in pieces; mid nodes that no cell uses (0) were dropped."));
      // The pieces are the same from every format, whose orders of mid nodes differ.
      CHECK(deck.mesh.tetrahedra == decks[0].mesh.tetrahedra);
    }
    CHECK(decks[0].part("one").tetrahedra.size() == 8);
    CHECK(decks[1].part("one").tetrahedra.size() == 8);
    CHECK(decks[1].part("others").tetrahedra.size() == 8 * (parents - 1));
    CHECK(decks[2].part(1).tetrahedra.size() == 8);
    CHECK(decks[2].cell_sets[0].members == std::vector<Index>{0, 1, 2, 3, 4, 5, 6, 7});
  }
}

TEST_CASE("second order: forces of a uniform stress in pieces act on the skin alone, the patch test") {
  Quadratic mesh = tetrahedra_of_box();
  bend(mesh, 0.06);
  const Mesh cut = read_gmsh(as_gmsh(mesh), "a.msh", in_pieces).mesh;
  const Eigen::Matrix3d stress{{3, 1, -2}, {1, -5, 4}, {-2, 4, 7}};
  std::vector<Eigen::Vector3d> forces(cut.nodes.size(), Eigen::Vector3d::Zero());
  const auto add = [&](const Face& face, double sign) {  // a third of its traction to each corner
    for (std::size_t i = 0; i < 3; ++i) forces[face.nodes[i]] += sign / 3 * stress * area_vector(cut.nodes, face);
  };
  for (const auto& cell : cut.tetrahedra)
    for (const Face& face : tetrahedron_surface({cell})) add(face, 1);
  for (const Face& face : surface(cut)) add(face, -1);
  for (const auto& force : forces) CHECK(force.norm() < 1e-14);  // of terms of 7 x 2 x some 10 roundings
}

TEST_CASE("second order: the volume of pieces of a bent tetrahedron in closed form") {
  const Cells<4> one{{0, 1, 2, 3}};
  Quadratic mesh = quadratic(Kind::tetrahedron10, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, one);
  // The edge 1-2 between the faces z = 0 and x + y + z = 1. Of each face, a middle has a third of three of the four
  // triangles around it: a quarter of the area.
  const Eigen::Vector3d move(0.1, 0.15, -0.05), areas = Eigen::Vector3d(0, 0, -0.5) + Eigen::Vector3d(0.5, 0.5, 0.5);
  mesh.nodes[mesh.cells[0][5]] += move;
  const Mesh cut = read_gmsh(as_gmsh(mesh), "a.msh", in_pieces).mesh;
  check(cut);
  CHECK(volume(cut) == Approx(1.0 / 6 + move.dot(areas) / 4).epsilon(1e-14));
}

TEST_CASE("second order: the octahedron is cut along its shortest diagonal, however the cell is turned or numbered") {
  // Stretched along the line from the middle of 0-1 to that of 2-3, of which the diagonals across are the shorter ones;
  // from 0-2 to 1-3 is the shortest.
  const std::vector<Eigen::Vector3d> at{{1, 0, 0}, {-1, 0, 0}, {0, 0.8, 3}, {0.3, -0.8, 3}};
  for (const Cells<4>& cells :
       {Cells<4>{{0, 1, 3, 2}}, Cells<4>{{1, 3, 0, 2}}, Cells<4>{{2, 3, 1, 0}}, Cells<4>{{3, 2, 0, 1}}})
    for (const double turn : {0.0, 0.4, 2.0}) {
      std::vector<Eigen::Vector3d> turned;
      for (const auto& x : at)
        turned.emplace_back(std::cos(turn) * x[0] - std::sin(turn) * x[2], x[1],
                            std::sin(turn) * x[0] + std::cos(turn) * x[2]);
      const Quadratic mesh = quadratic(Kind::tetrahedron10, turned, cells);
      const Mesh cut = read_gmsh(as_gmsh(mesh), "a.msh", in_pieces).mesh;
      check(cut);
      std::set<std::pair<Index, Index>> edges;
      for (const auto& cell : cut.tetrahedra)
        for (const Index a : cell)
          for (const Index b : cell) edges.insert({a, b});
      const auto node_at = [&](int i, int j) {
        const Eigen::Vector3d x = (turned[static_cast<std::size_t>(i)] + turned[static_cast<std::size_t>(j)]) / 2;
        for (Index n = 0; n < cut.nodes.size(); ++n)
          if ((cut.nodes[n] - x).norm() < 1e-12) return n;
        return Index(0);
      };
      CHECK_FALSE(edges.contains({node_at(0, 1), node_at(2, 3)}));
      CHECK(edges.contains({node_at(0, 3), node_at(1, 2)}) != edges.contains({node_at(0, 2), node_at(1, 3)}));
      const auto length = [&](int a, int b, int c, int d) {
        return (cut.nodes[node_at(a, b)] - cut.nodes[node_at(c, d)]).norm();
      };
      CHECK(edges.contains({node_at(0, 2), node_at(1, 3)}) == (length(0, 2, 1, 3) < length(0, 3, 1, 2)));
    }
}

TEST_CASE("second order: hexahedra of 27 and wedges of 18 nodes in eight pieces, those of 20 and 15 to their corners") {
  for (const double by : {0.0, 0.04}) {
    Quadratic mesh = bricks(Kind::hexahedron27);
    bend(mesh, by);
    for (const Deck& deck : {read_gmsh(as_gmsh(mesh), "a.msh", in_pieces),
                             static_cast<Deck>(read_abaqus(as_abaqus(mesh), "a.inp", in_pieces))}) {
      CHECK(deck.mesh.hexahedra.size() == 8 * mesh.cells.size());
      CHECK(deck.mesh.nodes.size() == mesh.nodes.size());
      check(deck.mesh);
      const Skin skin = skin_of(deck.mesh);
      CHECK(skin.is_closed);
      CHECK(deck.part("one").hexahedra.size() == 8);
      if (by == 0) CHECK(volume(deck.mesh) == Approx(6).epsilon(1e-14));
      if (by == 0) CHECK(skin.area == Approx(22).epsilon(1e-14));
    }
  }
  const Quadratic prisms = wedges(Kind::wedge18);
  for (const Deck& deck : {read_gmsh(as_gmsh(prisms), "a.msh", in_pieces),
                           static_cast<Deck>(read_abaqus(as_abaqus(prisms), "a.inp", in_pieces))}) {
    CHECK(deck.mesh.hexahedra.size() == 16);
    check(deck.mesh);
    CHECK(volume(deck.mesh) == Approx(2).epsilon(1e-14));
    CHECK(skin_of(deck.mesh).area == Approx(2 + 8).epsilon(1e-14));
  }
  for (const ReadOptions& options : {in_pieces, to_corners}) {
    Quadratic mesh = bricks(Kind::hexahedron20), prism15 = wedges(Kind::wedge15);
    bend(mesh, 0.04);
    for (const Deck& deck :
         {read_gmsh(as_gmsh(mesh), "a.msh", options), static_cast<Deck>(read_abaqus(as_abaqus(mesh), "a.inp", options)),
          static_cast<Deck>(read_dyna(as_dyna(mesh), "a.k", options))}) {
      CHECK(deck.mesh.hexahedra.size() == 4);
      CHECK(deck.mesh.nodes.size() == 18);
      check(deck.mesh);
      CHECK(volume(deck.mesh) == Approx(6).epsilon(1e-14));
      CHECK(warns(deck, "hexahedra of 20 nodes (4) to their corners; mid nodes that no cell uses (33) were dropped."));
      CHECK_FALSE(warns(deck, "Nodes without an element"));
    }
    for (const Deck& deck : {read_gmsh(as_gmsh(prism15), "a.msh", options),
                             static_cast<Deck>(read_abaqus(as_abaqus(prism15), "a.inp", options))}) {
      CHECK(deck.mesh.hexahedra.size() == 2);
      check(deck.mesh);
      CHECK(volume(deck.mesh) == Approx(2).epsilon(1e-14));
    }
    const Quadratic pyramid = quadratic(Kind::pyramid13, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 3}},
                                        Cells<5>{{0, 1, 2, 3, 4}});
    const Mesh one = read_gmsh(as_gmsh(pyramid), "a.msh", options).mesh;
    check(one);
    CHECK(volume(one) == Approx(1).epsilon(1e-14));
  }
  const Mesh corners = read_dyna(as_dyna(bricks(Kind::hexahedron27)), "a.k", to_corners).mesh;
  CHECK(volume(corners) == Approx(6).epsilon(1e-14));
  CHECK_THROWS_WITH(read_dyna(as_dyna(bricks(Kind::hexahedron27)), "a.k", in_pieces),
                    ContainsSubstring("cannot be cut in pieces, as the order of its mid nodes is not read"));
}

TEST_CASE("second order: plates") {
  const std::vector<Eigen::Vector3d> square{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}};
  const auto six = quadratic(Kind::triangle6, square, Cells<3>{{0, 1, 2}, {0, 2, 3}});
  const auto eight = quadratic(Kind::quadrilateral8, square, Cells<4>{{0, 1, 2, 3}});
  const auto nine = quadratic(Kind::quadrilateral9, square, Cells<4>{{0, 1, 2, 3}});
  const auto areas = [](const Mesh& mesh) {
    std::vector<double> all;
    for (const Face& face : surface(mesh)) all.push_back(area_vector(mesh.nodes, face)[2]);
    return all;
  };
  for (const bool gmsh : {true, false}) {
    const auto read = [&](const Quadratic& mesh, const ReadOptions& options) {
      return gmsh ? read_gmsh(as_gmsh(mesh), "a.msh", options).mesh
                  : static_cast<Deck>(read_abaqus(as_abaqus(mesh), "a.inp", options)).mesh;
    };
    CHECK(areas(read(six, in_pieces)) == std::vector<double>(8, 0.25));
    CHECK(areas(read(six, to_corners)) == std::vector<double>(2, 1));
    CHECK(areas(read(nine, in_pieces)) == std::vector<double>(4, 0.5));
    CHECK(areas(read(nine, to_corners)) == std::vector<double>(1, 2));
    CHECK(areas(read(eight, in_pieces)) == std::vector<double>(1, 2));
  }
  const Deck shell =
      read_dyna("*KEYWORD\n*NODE\n" + node_lines(eight, ",") + "*ELEMENT_SHELL\n1,1," + number(eight, 0) + "," +
                    number(eight, 1) + "," + number(eight, 2) + "," + number(eight, 3) + "," + number(eight, 4) + "," +
                    number(eight, 5) + "," + number(eight, 6) + "," + number(eight, 7) + "\n",
                "a.k", in_pieces);
  CHECK(areas(shell.mesh) == std::vector<double>(1, 2));
}

TEST_CASE("second order: marks on faces name the middles too, and surfaces and segments their pieces") {
  const Cells<4> one{{0, 1, 2, 3}};
  const Quadratic mesh = quadratic(Kind::tetrahedron10, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, one);
  const auto n = [&](std::size_t i) { return number(mesh, mesh.cells[0][i]); };
  const std::string mark = "7 9 2 3 9 " + n(0) + " " + n(2) + " " + n(1) + " " + n(6) + " " + n(5) + " " + n(4) +
                           "\n8 8 2 0 4 " + n(0) + " " + n(1) + " " + n(4) + "\n";
  const Deck marked = read_gmsh(as_gmsh(mesh, mark, 2), "a.msh", in_pieces);
  CHECK(marked.nodes("foot").size() == 6);
  CHECK(marked.nodes("line 4").size() == 3);
  CHECK(marked.mesh.triangles.empty());
  CHECK(warns(marked, "Surface elements on solids (1) mark faces"));
  CHECK(read_gmsh(as_gmsh(mesh, mark, 2), "a.msh", to_corners).nodes("foot").size() == 3);

  const std::string loaded =
      as_abaqus(mesh) + "*NSET, NSET=all, ELSET=one\n*SURFACE, NAME=foot\none, S1\n*SURFACE, NAME=skin\none,\n";
  const AbaqusDeck cut = read_abaqus(loaded, "a.inp", in_pieces);
  CHECK(cut.nodes("all").size() == 10);
  Eigen::Vector3d area = Eigen::Vector3d::Zero();
  const auto& segments = cut.surface("foot").side.segments;
  for (const auto& segment : segments) area += area_vector(cut.mesh.nodes, Face{segment, 0});
  CHECK(segments.size() == 4);
  CHECK((area - Eigen::Vector3d(0, 0, -0.5)).norm() < 1e-15);
  CHECK(cut.surface("skin").side.segments.size() == 16);
  const AbaqusDeck corners = read_abaqus(loaded, "a.inp", to_corners);
  CHECK(corners.surface("foot").side.segments.size() == 1);
  CHECK(corners.nodes("all").size() == 4);

  const DynaDeck dyna = read_dyna(
      "*KEYWORD\n*SET_SEGMENT\n5\n" + n(0) + "," + n(2) + "," + n(1) + "," + n(1) + "\n" + as_dyna(mesh) + "*END\n",
      "a.k", in_pieces);
  CHECK(dyna.segment_sets.at(0).segments.size() == 4);
}

TEST_CASE("second order: copies of Abaqus keep their mid nodes") {
  const Cells<4> one{{0, 1, 2, 3}};
  const Quadratic mesh = quadratic(Kind::tetrahedron10, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, one);
  const std::string part = "*PART, NAME=p\n" + as_abaqus(mesh) + "*END PART\n*ASSEMBLY, NAME=a\n";
  const Deck two = read_abaqus(part +
                                   "*INSTANCE, NAME=i, PART=p\n*END INSTANCE\n*INSTANCE, NAME=j, PART=p\n5,0,0\n"
                                   "*END INSTANCE\n*END ASSEMBLY\n",
                               "a.inp", in_pieces);
  CHECK(two.part("j").tetrahedra.size() == 8);
  CHECK(volume(two.mesh) == Approx(1.0 / 3).epsilon(1e-14));
  const Deck copied = read_abaqus(as_abaqus(mesh) +
                                      "*NSET, NSET=n, GENERATE\n1,99\n*NCOPY, OLD SET=n, CHANGE NUMBER=100, SHIFT\n"
                                      "3,0,0\n0,0,0,0,0,1,0\n*ELCOPY, OLD SET=one, ELEMENT SHIFT=1, SHIFT NODES=100\n",
                                  "a.inp", in_pieces);
  CHECK(copied.mesh.tetrahedra.size() == 16);
  CHECK(volume(copied.mesh) == Approx(1.0 / 3).epsilon(1e-14));
  check(copied.mesh);
}

TEST_CASE("second order: what would be wrong is a sentence") {
  const Cells<4> one{{0, 1, 2, 3}};
  Quadratic mesh = quadratic(Kind::tetrahedron10, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, one);
  const std::string advice =
      "cut them with {.second_order = SecondOrder::in_pieces} or SecondOrder::to_corners, or mesh in first order.";
  CHECK_THROWS_WITH(read_gmsh(as_gmsh(mesh), "a.msh"), ContainsSubstring("is of type 11, of second order: " + advice));
  CHECK_THROWS_WITH(read_abaqus(as_abaqus(mesh), "a.inp"),
                    ContainsSubstring("elements of type 'C3D10M' are of second order: " + advice));
  CHECK_THROWS_WITH(read_dyna(as_dyna(mesh), "a.k"),
                    ContainsSubstring("element 1 is a tetrahedron of ten nodes: " + advice));
  CHECK_THROWS_WITH(read_dyna(as_dyna(bricks(Kind::hexahedron20)), "a.k"),
                    ContainsSubstring("element 1 is of second order: " + advice));

  // The mid nodes 8 and 9 of gmsh in a file of Abaqus.
  Quadratic swapped = mesh;
  std::swap(swapped.cells[0][8], swapped.cells[0][9]);
  CHECK_THROWS_WITH(read_abaqus(as_abaqus(swapped), "a.inp", in_pieces),
                    ContainsSubstring("in the place of another one: order its mid nodes as the format has them."));
  CHECK(volume(read_abaqus(as_abaqus(swapped), "a.inp", to_corners).mesh) == Approx(1.0 / 6));

  Quadratic folded = mesh;
  folded.nodes[folded.cells[0][4]] = {0.2, 0.9, 0.9};
  CHECK_THROWS_WITH(read_gmsh(as_gmsh(folded), "a.msh", in_pieces),
                    ContainsSubstring("has a piece that is flat or inside out"));
  Quadratic repeated = mesh;
  repeated.cells[0][9] = repeated.cells[0][8];
  CHECK_THROWS_WITH(read_gmsh(as_gmsh(repeated), "a.msh", in_pieces), ContainsSubstring("element 1 repeats a node"));

  const auto n = [&](std::size_t i) { return number(mesh, mesh.cells[0][i]); };
  // A tetrahedron of four nodes at a middle of one that is taken by its corners.
  const std::string beside =
      as_abaqus(mesh) + "*NODE\n99,1,1,1\n*ELEMENT, TYPE=C3D4\n2," + n(1) + "," + n(2) + "," + n(9) + ",99\n";
  CHECK_THROWS_WITH(read_abaqus(beside, "a.inp", to_corners),
                    ContainsSubstring("where it would hang: mesh in one order."));
  CHECK(read_abaqus(beside, "a.inp", in_pieces).mesh.tetrahedra.size() == 9);

  const std::string pushed =
      as_abaqus(mesh) + "*NSET, NSET=push\n" + n(0) + "," + n(4) + "\n*STEP\n*DYNAMIC, EXPLICIT\n,1\n*CLOAD\n";
  CHECK_THROWS_WITH(read_abaqus(pushed + n(4) + ",1,2.\n", "a.inp", to_corners),
                    ContainsSubstring("a force on node " + n(4)));
  CHECK_THROWS_WITH(read_abaqus(pushed + "push,1,2.\n", "a.inp", to_corners),
                    ContainsSubstring("forces on 1 nodes of the set 'push' would be lost"));
  CHECK(read_abaqus(pushed + "push,1,2.\n", "a.inp", in_pieces).forces.at(0).nodes.size() == 2);
}
