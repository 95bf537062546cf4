#include <algorithm>
#include <array>
#include <numeric>

#include <strike/mesh/box.hpp>
#include <strike/mesh/check.hpp>
#include <strike/mesh/degenerate.hpp>
#include <strike/mesh/disc.hpp>
#include <strike/mesh/measure.hpp>
#include <strike/mesh/mixed_cells.hpp>
#include <strike/mesh/particles.hpp>
#include <strike/mesh/surface.hpp>
#include <strike/mesh/tetrahedra.hpp>
#include <strike/mesh/transform.hpp>

#include "right.hpp"
#include "support/catch.hpp"
#include "support/cut_hexahedra.hpp"

using namespace strike;
using Catch::Matchers::ContainsSubstring;
using testing::cut_into_pyramids;
using testing::cut_into_wedges;
using testing::is_right;

namespace {

/// A skew box.
Mesh skew(const std::array<Index, 3>& cells = {2, 3, 2}) {
  return transformed(box({.size = {1, 1, 1}, .cells = cells}), [](const auto& x) -> Eigen::Vector3d {
    return {x[0] + 0.6 * x[1], x[1] - 0.5 * x[2], x[2] * (2 + x[0])};
  });
}
/// Of all numberings of the corners of a cell that name these nodes, how many are right.
int right_numberings(Mesh mesh) {
  auto& cell = mesh.hexahedra[0];
  std::sort(cell.begin(), cell.end());
  int right = 0;
  do right += is_right(mesh);
  while (std::next_permutation(cell.begin(), cell.end()));
  return right;
}
/// The sum of the areas of the outer faces, as vectors: zero of a closed surface that looks outwards.
Eigen::Vector3d closure(const Mesh& mesh) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Face& face : surface(mesh)) sum += area_vector(mesh.nodes, face);
  return sum;
}

const Mesh wedge{.nodes = {{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, 0, 3}, {2, 0, 3}, {0, 1, 3}},
                 .hexahedra = {wedge_cell<Index>({0, 1, 2, 3, 4, 5})}};
const Mesh pyramid{.nodes = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}, {1, 1, 3}},
                   .hexahedra = {pyramid_cell<Index>({0, 1, 2, 3, 4})}};

}  // namespace

TEST_CASE("degenerate hexahedra: their numbering is found in every turned and mirrored one, and in no other") {
  static_assert(detail::turned_numberings().back() != detail::CornerOrder{});
  // LS-DYNA's wedge: the triangles a e b and d f c.
  CHECK(canonical_hexahedron(std::array{1, 2, 3, 4, 5, 5, 6, 6}).has_value());
  const auto ls_dyna = *canonical_hexahedron(std::array{1, 2, 3, 4, 5, 5, 6, 6});
  CHECK((ls_dyna[2] == ls_dyna[3] && ls_dyna[6] == ls_dyna[7]));
  const auto ends = [&](int i, int j) { return std::array{ls_dyna[std::size_t(i)], ls_dyna[std::size_t(j)]}; };
  CHECK((ends(2, 6) == std::array{5, 6} || ends(2, 6) == std::array{6, 5}));
  CHECK(canonical_hexahedron(std::array{1, 2, 3, 4, 5, 5, 5, 5}) == std::array{1, 2, 3, 4, 5, 5, 5, 5});
  CHECK(canonical_hexahedron(std::array{1, 2, 3, 4, 5, 6, 7, 8}) == std::array{1, 2, 3, 4, 5, 6, 7, 8});
  CHECK(!canonical_hexahedron(std::array{1, 2, 3, 4, 5, 6, 7, 7}));
  CHECK(!canonical_hexahedron(std::array{1, 2, 3, 4, 5, 6, 6, 6}));
  CHECK(canonical_hexahedron(std::array{1, 1, 2, 3, 4, 4, 5, 6}).has_value());   // both edges along x of a face
  CHECK(!canonical_hexahedron(std::array{1, 1, 2, 3, 4, 5, 5, 6}).has_value());  // edges along x and y
  CHECK(!canonical_hexahedron(std::array{1, 2, 1, 3, 4, 5, 4, 6}));              // across the faces
  CHECK(!canonical_hexahedron(std::array{1, 2, 3, 3, 4, 5, 5, 5}));

  // Patterns of equal corners: two edges of a face for a wedge, 6 faces by 2 pairs, and a face for a pyramid, 6.
  int wedges = 0, pyramids = 0;
  std::array<int, 8> cell{};
  for (int code = 0; code < 1 << 21; ++code) {
    // Restricted growth strings name each partition of the corners once.
    int highest = 0;
    bool grows = true;
    for (std::size_t i = 1; i < 8 && grows; ++i) {
      cell[i] = code >> (3 * (i - 1)) & 7;
      grows = cell[i] <= highest + 1;
      highest = std::max(highest, cell[i]);
    }
    if (!grows || (highest != 5 && highest != 4)) continue;
    const bool found = canonical_hexahedron(cell).has_value();
    (highest == 5 ? wedges : pyramids) += found;
  }
  CHECK(wedges == 12);
  CHECK(pyramids == 6);
}

TEST_CASE("degenerate hexahedra: check takes what turns a wedge or a pyramid onto itself, and refuses other orders") {
  check(wedge), check(pyramid);
  // Patterns by the turns of the cell onto itself that keep its edge 2 5 or its apex.
  CHECK(right_numberings(wedge) == 12 * 2);
  CHECK(right_numberings(pyramid) == 6 * 4);
  const auto message = [](Mesh mesh, const std::array<Index, 8>& cell) {
    mesh.hexahedra = {cell};
    try {
      check(mesh);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK_THAT(message(wedge, {0, 1, 2, 2, 4, 5, 3, 3}),
             ContainsSubstring("is twisted: corners 4 5 6 7 are turned against 0 1 2 3 by"));
  CHECK_THAT(message(wedge, {0, 2, 1, 1, 3, 5, 4, 4}),
             ContainsSubstring("is flat or inside out at corner 0 (volume -3)"));
  CHECK_THAT(message(wedge, {0, 1, 2, 3, 3, 4, 5, 5}),
             ContainsSubstring("names node 3 twice; give it 8 different corners, or make it a wedge a b c c d e f f or "
                               "a pyramid a b c d e e e e."));
  CHECK_THAT(message(pyramid, {0, 2, 1, 3, 4, 4, 4, 4}), ContainsSubstring("is flat or inside out"));
}

TEST_CASE("degenerate hexahedra: volume, middle and faces are those of the wedge and the pyramid") {
  CHECK(volume(wedge) == Approx(0.5 * 2 * 1 * 3).epsilon(1e-15));
  CHECK(volume(pyramid) == Approx(2 * 1 * 3 / 3.0).epsilon(1e-15));
  CHECK((centroid<8>(wedge.nodes, wedge.hexahedra[0]) - Eigen::Vector3d(2 / 3.0, 1 / 3.0, 1.5)).norm() < 1e-15);
  for (const auto& [mesh, triangles] : {std::pair{wedge, 2}, std::pair{pyramid, 4}}) {
    const auto faces = surface(mesh);
    CHECK(faces.size() == 5);
    CHECK(std::count_if(faces.begin(), faces.end(), [](const Face& f) { return f.is_triangle(); }) == triangles);
    CHECK(closure(mesh).norm() < 1e-14);
  }
  // Shares of the mass have its middle: that of a prism, and of a pyramid at a quarter of its height.
  for (const auto& [mesh, height] : {std::pair{wedge, 1.5}, std::pair{pyramid, 0.75}}) {
    const Particles shares = particles_at_nodes(mesh.nodes, mesh.hexahedra);
    double z = 0, sum = 0;
    for (std::size_t i = 0; i < shares.size(); ++i)
      z += shares.volumes[i] * mesh.nodes[shares[i][0]][2], sum += shares.volumes[i];
    CHECK(sum == Approx(volume(mesh)).epsilon(1e-15));
    CHECK(z / sum == Approx(height).epsilon(1e-15));
  }
}

TEST_CASE("degenerate hexahedra: a box cut into them has its volume and its surface, and splits into tetrahedra") {
  const Mesh whole = skew();
  const std::size_t cells = whole.hexahedra.size(), quads = surface(whole).size();
  const Mesh wedges = cut_into_wedges(whole), pyramids = cut_into_pyramids(whole);
  check(wedges), check(pyramids);
  // Faces of 2 x 3 cells above and below are cut by wedges into two triangles.
  CHECK(surface(wedges).size() == quads + 2 * 2 * 3);
  CHECK(surface(pyramids).size() == quads);
  CHECK(surface_nodes(surface(pyramids)) == surface_nodes(surface(whole)));
  for (const auto& [mesh, each] : {std::pair{wedges, std::size_t(6)}, std::pair{pyramids, std::size_t(12)}}) {
    CHECK(closure(mesh).norm() < 1e-14);
    const Mesh split = tetrahedralized(mesh);
    check(split);
    CHECK(split.tetrahedra.size() == each * cells);
    CHECK(surface(split).size() == 2 * quads);  // no gap inside: they fit
    CHECK(closure(split).norm() < 1e-14);
    CHECK_THROWS_WITH(tetrahedralized(mesh, Split::five),
                      ContainsSubstring("so it is not split into five tetrahedra; split by Split::six."));
    check(mirrored(mesh, Eigen::Vector3d::UnitY()));
    CHECK(volume(mirrored(mesh, Eigen::Vector3d::UnitY())) == Approx(volume(mesh)).epsilon(1e-14));
  }
  CHECK(volume(pyramids) == Approx(volume(whole)).epsilon(1e-14));
  CHECK(particles(cut_into_wedges(box({.size = {1, 1, 1}, .cells = {2, 2, 2}})), 0.25).particles.size() == 64);
}

TEST_CASE("degenerate hexahedra: triangles of tetrahedra and quadrilaterals of hexahedra fit theirs") {
  // A pyramid on a cube, and a tetrahedron on one of its sides.
  Mesh mesh = box({.size = {1, 1, 1}});
  mesh.nodes.emplace_back(0.5, 0.5, 2), mesh.nodes.emplace_back(0.5, -1, 2);
  const auto top = mesh.hexahedra[0];
  mesh.hexahedra.push_back(pyramid_cell<Index>({top[4], top[5], top[6], top[7], 8}));
  mesh.tetrahedra = {{top[4], top[5], 8, 9}};
  check(mesh);
  CHECK(surface(mesh).size() == 5 + 3 + 3);
  CHECK(closure(mesh).norm() < 1e-14);
}

TEST_CASE("degenerate hexahedra: triangles of a plan are swept to wedges, and lists of cells may hold them") {
  Mesh plan{.nodes = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, .quadrilaterals = {{0, 1, 2, 2}}};
  const std::array<double, 3> levels{0, 1, 2};
  const Mesh bar = extruded(plan, levels);
  check(bar);
  CHECK(volume(bar) == Approx(1).epsilon(1e-15));
  const std::vector<std::vector<Index>> cells{{3, 4, 1, 0, 5, 5, 2, 2}};
  const Mesh sorted = sorted_by_kind(wedge.nodes, cells).mesh;
  check(sorted);
  CHECK(volume(sorted) == Approx(3).epsilon(1e-15));
}
